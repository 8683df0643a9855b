#include "verification/exact/vibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sunder::exact {
namespace {

using std::numbers::pi;

TEST(RollerSquare, SortsItsTwoFamilies) {
  const PlaneBody body = plane_strain(2.5, 0.25);  // G = 1, c_p / c_s = √3
  const double rho = 1.0, L = 2.0, c_s = 1.0, c_p = std::sqrt(3.0);
  EXPECT_NEAR(longitudinal_wave_speed(body, rho), c_p, 1e-14);
  // c² (i² + j²) in units of c_s²: 2 (s11), 3 3 (p10 p01), 5 5 (s12 s21), 6 (p11), 8 (s22), 10 10 (s13 s31)
  const double squares[] = {2, 3, 3, 5, 5, 6, 8, 10, 10};
  for (int n = 0; n < 9; ++n)
    EXPECT_NEAR(roller_square_frequency(body, rho, L, n), pi / L * c_s * std::sqrt(squares[n]), 1e-13) << n;
}

TEST(SlenderCantilever, HasTheTabulatedRoots) {
  // λ L of a clamped-free beam: 1.87510407, 4.69409113, 7.85475744 [Blevins 1979, Table 8-1].
  const double roots[] = {1.87510407, 4.69409113, 7.85475744};
  for (int n = 1; n <= 3; ++n)  // E' h² / (12 ρ) = 1, L = 1
    EXPECT_NEAR(std::sqrt(slender_cantilever_frequency(12.0, 1.0, 1.0, 1.0, n)), roots[n - 1], 5e-9) << n;
}

}  // namespace
}  // namespace sunder::exact
