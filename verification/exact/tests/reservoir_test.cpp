#include "verification/exact/reservoir.hpp"

#include <gtest/gtest.h>

namespace sunder::exact {
namespace {

TEST(Reservoir, HasTheForceOfStillAndOfMovingWater) {
  EXPECT_NEAR(reservoir_force(0.0), 0.5427545144, 1e-10);  // 14 ζ(3)/π³
  EXPECT_NEAR(2.0 * reservoir_force(0.5 * 1.5707963267948966), 1.24576285, 1e-8);
  EXPECT_NEAR(2.0 * reservoir_force(0.9 * 1.5707963267948966), 2.42316308, 1e-8);
  EXPECT_THROW(reservoir_force(1.6), std::invalid_argument);
}

TEST(Reservoir, LowersTheFrequencyOfAnOscillator) {
  const double kappa = coupled_frequency(1.0, 1.3);
  EXPECT_NEAR(kappa * kappa * (reservoir_force(0.0) + reservoir_force(kappa)), 1.69 * reservoir_force(0.0), 1e-12);
  EXPECT_LT(kappa, 1.3 / 1.4142);  // compressible water is heavier than incompressible
  EXPECT_NEAR(coupled_frequency(1e9, 1.0), 1.0, 1e-8);
}

}  // namespace
}  // namespace sunder::exact
