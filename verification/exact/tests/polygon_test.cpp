#include "verification/exact/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sunder::exact {
namespace {

TEST(AreaMoments, OfARectangleAwayFromTheOrigin) {
  const std::vector<Complex> rectangle{{1.0, 2.0}, {4.0, 2.0}, {4.0, 3.0}, {1.0, 3.0}};
  const AreaMoments moments = area_moments(rectangle);
  const double xx = (64.0 - 1.0) / 3.0, yy = 3.0 * (27.0 - 8.0) / 3.0, xy = 7.5 * 2.5;  // ∫ x², y², xy by hand
  EXPECT_NEAR(moments.area, 3.0, 1e-14);
  EXPECT_NEAR(std::abs(moments.first - Complex(7.5, 7.5)), 0.0, 1e-13);
  EXPECT_NEAR(moments.polar, xx + yy, 1e-13);
  EXPECT_NEAR(std::abs(moments.second - Complex(xx - yy, 2.0 * xy)), 0.0, 1e-13);
}

TEST(GaussRule, IsExactToItsDegree) {
  for (const int count : {1, 2, 5, 20, 40})
    for (int degree = 0; degree <= 2 * count - 1; ++degree) {
      double sum = 0.0;
      for (const auto& [x, weight] : gauss_rule(count)) sum += weight * std::pow(x, degree);
      EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0, 1e-14)
          << count << " " << degree;  // 40 terms of 2 eps
    }
}

TEST(EdgeForces, SplitALinearTractionAsByHand) {
  // Two nodes, length 5, traction falling from 6 to 0: 2/3 and 1/3 of the resultant 15, all along y.
  const std::vector<Complex> nodes{{0.0, 0.0}, {3.0, 4.0}};
  const auto forces = edge_forces(
      nodes, [](Complex z) { return Complex(0.0, 6.0 - 2.0 * z.real()); }, 2);
  EXPECT_NEAR(std::abs(forces[0] - Complex(0.0, 10.0)), 0.0, 1e-13);
  EXPECT_NEAR(std::abs(forces[1] - Complex(0.0, 5.0)), 0.0, 1e-13);
  // Three nodes carry a uniform traction as 1/6, 4/6, 1/6.
  const std::vector<Complex> quadratic{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  const auto uniform = edge_forces(
      quadratic, [](Complex) { return Complex(3.0, 0.0); }, 2);
  EXPECT_NEAR(uniform[1].real(), 4.0, 1e-14);
  EXPECT_NEAR(uniform[2].real(), 1.0, 1e-14);
}

}  // namespace
}  // namespace sunder::exact
