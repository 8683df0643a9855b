#include "solver/fracture/kink_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sunder::fracture {
namespace {

constexpr double pi = std::numbers::pi;

TEST(KinkAngle, InPureModeTwoIsTheAngleWithCosineOneThird) {
  const double exact = std::acos(1.0 / 3.0);  // 70.5288°
  EXPECT_DOUBLE_EQ(kink_angle({.K_I = 0.0, .K_II = 1.0}), -exact);
  EXPECT_DOUBLE_EQ(kink_angle({.K_I = 0.0, .K_II = -3e6}), exact);
  EXPECT_DOUBLE_EQ(equivalent_factor({.K_I = 0.0, .K_II = 1.0}), 2.0 / std::sqrt(3.0));
}

TEST(KinkAngle, KeepsItsDigitsFromVanishingToOverwhelmingModeTwo) {
  // tan(θ/2) = t solves 2 K_II t² - K_I t - K_II = 0; long double holds the cancelling form to 1e-19 relative to K_I,
  // so the small root is taken from the product of the roots, -½.
  for (int exponent = -16; exponent <= 16; ++exponent) {
    const long double ratio = std::pow(10.0L, exponent);
    const long double large = (1.0L + std::sqrt(1.0L + 8.0L * ratio * ratio)) / (4.0L * ratio);
    const auto exact = static_cast<double>(2.0L * std::atan(-0.5L / large));
    const double computed = kink_angle({.K_I = 1.0, .K_II = static_cast<double>(ratio)});
    EXPECT_NEAR(computed, exact, 4e-16 * std::abs(exact)) << "K_II / K_I = 1e" << exponent;
    EXPECT_EQ(kink_angle({.K_I = 1.0, .K_II = -static_cast<double>(ratio)}), -computed);
  }
  EXPECT_DOUBLE_EQ(kink_angle({.K_I = 1.0, .K_II = 1e-200}), -2e-200);
  EXPECT_EQ(kink_angle({.K_I = 2.0, .K_II = 0.0}), 0.0);
  EXPECT_EQ(kink_angle({.K_I = 0.0, .K_II = 0.0}), 0.0);
}

TEST(KinkAngle, PointsToTheLargestHoopStress) {
  for (const double K_I : {1.0, 0.2, 0.0, -0.5, -3.0}) {
    for (const double K_II : {1e-3, 0.4, -1.0, 5.0}) {
      const auto hoop = [&](double theta) {
        const double c = std::cos(0.5 * theta);
        return c * (K_I * c * c - 1.5 * K_II * std::sin(theta));
      };
      double best = -pi;
      for (int i = -2000; i <= 2000; ++i) {
        if (hoop(pi * i / 2000) > hoop(best)) best = pi * i / 2000;
      }
      const StressIntensityFactors factors{.K_I = K_I, .K_II = K_II};
      // The scan steps by π/2000.
      EXPECT_NEAR(kink_angle(factors), best, pi / 2000) << K_I << ", " << K_II;
      EXPECT_GE(equivalent_factor(factors), hoop(best));
    }
  }
}

TEST(KinkAngle, OfOverlappingFacesHasNoDriveAndNoDirectionWithoutSliding) {
  EXPECT_EQ(kink_angle({.K_I = -1.0, .K_II = 0.0}), 0.0);
  EXPECT_EQ(equivalent_factor({.K_I = -1.0, .K_II = 0.0}), 0.0);
  EXPECT_NEAR(kink_angle({.K_I = -1.0, .K_II = 1e-9}), -pi, 1e-8);
  EXPECT_NEAR(equivalent_factor({.K_I = -1.0, .K_II = 1e-9}), 0.0, 1e-8);
}

TEST(KinkAngle, DoesNotDependOnUnits) {
  const double angle = kink_angle({.K_I = 1.0, .K_II = 0.3});
  EXPECT_DOUBLE_EQ(kink_angle({.K_I = 1e-160, .K_II = 0.3e-160}), angle);
  EXPECT_DOUBLE_EQ(kink_angle({.K_I = 1e200, .K_II = 0.3e200}), angle);
}

}  // namespace
}  // namespace sunder::fracture
