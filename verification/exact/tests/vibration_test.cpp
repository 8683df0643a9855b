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

TEST(StepResponse, SolvesItsEquation) {
  // u'' + 2 ζ u' + u = 1 by central differences; their error is h² / 12 times a derivative of size 1
  const double h = 1e-3;
  for (const double ratio : {0.0, 0.05, 0.9}) {
    for (const double t : {0.5, 3.0, 20.0}) {
      const double before = step_response(ratio, t - h), now = step_response(ratio, t),
                   after = step_response(ratio, t + h);
      const double acceleration = (after - 2.0 * now + before) / (h * h), velocity = (after - before) / (2.0 * h);
      EXPECT_NEAR(acceleration + 2.0 * ratio * velocity + now, 1.0, 1e-6) << ratio << ' ' << t;
    }
    EXPECT_EQ(step_response(ratio, 0.0), 0.0);
  }
  EXPECT_THROW((void)step_response(1.0, 1.0), std::invalid_argument);
}

TEST(ShakenRod, MovesWithTheInverseGroundUntilTheFirstWaveAndIsItsModesAfterwards) {
  const double omega = 3.0;
  EXPECT_EQ(shaken_rod(1.0, omega, 0.9), -(0.9 / omega - std::sin(omega * 0.9) / (omega * omega)));
  // Σ of fixed-free modes: participation 2 / κ, at the free end (-1)^n, κ = (n + ½) π; terms fall like n^-4
  for (const double t : {0.4, 1.7, 3.9}) {
    double sum = 0.0;
    for (int n = 0; n < 2000; ++n) {
      const double k = (n + 0.5) * pi;
      sum -= 2.0 / k * (n % 2 == 0 ? 1.0 : -1.0) * shaken_oscillator(k, omega, t);
    }
    EXPECT_NEAR(shaken_rod(1.0, omega, t), sum, 1e-9) << t;
  }
}

TEST(StepSchemes, NearTheStepResponseWithOrderTwo) {
  const auto error = [](int steps, auto scheme) {
    const double phase = 6.0 / steps;
    return std::abs(scheme(phase, steps) - step_response(0.1, 6.0));
  };
  const auto newmark = [](double phase, int n) { return newmark_step_response(phase, 0.1, n); };
  const auto hht = [](double phase, int n) { return hht_alpha_step_response(0.7, phase, 0.1, n); };
  const auto alpha = [](double phase, int n) { return generalised_alpha_step_response(0.3, phase, 0.1, n); };
  EXPECT_NEAR(error(400, newmark) / error(800, newmark), 4.0, 0.1);  // the next term is 1 % at phase 0.015
  EXPECT_NEAR(error(400, hht) / error(800, hht), 4.0, 0.2);
  EXPECT_NEAR(error(400, alpha) / error(800, alpha), 4.0, 0.2);
  // average acceleration turns by 2 atan(φ / 2)
  EXPECT_NEAR(newmark_step_response(0.4, 0.0, 50), 1.0 - std::cos(100.0 * std::atan(0.2)), 1e-12);
}

}  // namespace
}  // namespace sunder::exact
