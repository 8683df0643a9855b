#include "solver/fracture/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/fracture/kink_angle.hpp"

namespace sunder::fracture {
namespace {

constexpr PropagationLaw concrete{.fracture_toughness = 2e6, .increment = 0.5};

TEST(Propagation, GrowsFromTheToughnessOn) {
  EXPECT_EQ(decide_growth({.K_I = std::nextafter(2e6, 0.0), .K_II = 0.0}, Faces::as_K_I_says, concrete).verdict,
            GrowthVerdict::below_toughness);
  const GrowthDecision straight = decide_growth({.K_I = 2e6, .K_II = 0.0}, Faces::as_K_I_says, concrete);
  EXPECT_EQ(straight.verdict, GrowthVerdict::grows);
  EXPECT_EQ(straight.kink_angle, 0.0);
  EXPECT_EQ(straight.equivalent_factor, 2e6);
  // Pure shear grows at K_II = (√3 / 2) K_IC, at 70.5288 degrees.
  const double shear = 0.5 * std::numbers::sqrt3 * 2e6;
  EXPECT_EQ(decide_growth({.K_I = 0.0, .K_II = 0.999999 * shear}, Faces::as_K_I_says, concrete).verdict,
            GrowthVerdict::below_toughness);
  const GrowthDecision sheared = decide_growth({.K_I = 0.0, .K_II = 1.000001 * shear}, Faces::as_K_I_says, concrete);
  EXPECT_EQ(sheared.verdict, GrowthVerdict::grows);
  EXPECT_DOUBLE_EQ(sheared.kink_angle, -std::acos(1.0 / 3.0));
}

TEST(Propagation, AClosedCrackDoesNotGrow) {
  for (const double K_II : {0.0, 1e6, -1e9}) {
    EXPECT_EQ(decide_growth({.K_I = -1e6, .K_II = K_II / 1e3}, Faces::as_K_I_says, concrete).verdict,
              GrowthVerdict::closed);
    EXPECT_EQ(decide_growth({.K_I = 1e9, .K_II = K_II}, Faces::held_closed, concrete).verdict, GrowthVerdict::closed);
  }
  // A notch has no faces that could meet: the same field as with K_I > 0 opens the kink.
  EXPECT_EQ(decide_growth({.K_I = -1e6, .K_II = 8e6}, Faces::apart, concrete).verdict, GrowthVerdict::grows);
  EXPECT_EQ(decide_growth({.K_I = -1e6, .K_II = 8e6}, Faces::as_K_I_says, concrete).verdict, GrowthVerdict::closed);
  // Round-off of K_I in pure shear does not close the crack.
  EXPECT_EQ(decide_growth({.K_I = -1.0, .K_II = 1e7}, Faces::as_K_I_says, concrete).verdict, GrowthVerdict::grows);
}

TEST(Propagation, ToughnessAtTheEndsOfItsRange) {
  PropagationLaw law = concrete;
  law.fracture_toughness = INFINITY;
  check(law);
  EXPECT_EQ(decide_growth({.K_I = 1e300, .K_II = 0.0}, Faces::as_K_I_says, law).verdict,
            GrowthVerdict::below_toughness);
  law.fracture_toughness = 1e-300;
  check(law);
  EXPECT_EQ(decide_growth({.K_I = 1e-9, .K_II = 0.0}, Faces::as_K_I_says, law).verdict, GrowthVerdict::grows);
  for (const double bad : {0.0, -1.0, static_cast<double>(NAN)}) {
    law.fracture_toughness = bad;
    EXPECT_THROW(check(law), std::invalid_argument) << bad;
  }
}

TEST(Propagation, TheTipGoesTheIncrementAtItsAngle) {
  const Eigen::Vector2d to = next_tip({1.0, 2.0}, std::numbers::pi / 6, std::numbers::pi / 3, 0.5);
  EXPECT_NEAR(to.x(), 1.0, 1e-16);
  EXPECT_DOUBLE_EQ(to.y(), 2.5);
}

/// Increments in each of 100 steps of a tip that is always driven.
int increments_in_100_steps(const PropagationLaw& law, double time_step, int most_a_step) {
  SpeedAllowance allowance;
  int all = 0;
  for (int step = 0; step < 100; ++step) {
    refill(allowance, law, time_step);
    int taken = 0;
    while (taken < most_a_step && take_increment(allowance, law, taken)) ++taken;
    all += taken;
  }
  return all;
}

TEST(Propagation, SpeedIsLimitedWhateverTheStep) {
  PropagationLaw law = concrete;
  EXPECT_EQ(increments_in_100_steps(law, 0.01, 1000), 100);  // one a step
  law.max_speed = 5.0;                                       // 1 s: 5 m, 10 increments
  EXPECT_EQ(increments_in_100_steps(law, 0.01, 1000), 10);
  law.per_step = GrowthPerStep::until_arrest;
  EXPECT_EQ(increments_in_100_steps(law, 0.01, 1000), 10);
  law.max_speed = 500.0;
  EXPECT_EQ(increments_in_100_steps(law, 0.01, 1000), 1000);  // 500 m in 1 s
  law.max_speed = INFINITY;
  EXPECT_EQ(increments_in_100_steps(law, 0.01, 7), 700);  // as many as the caller wants
}

TEST(Propagation, ARestingTipSavesUpOneIncrement) {
  PropagationLaw law = concrete;
  law.max_speed = 5.0;
  SpeedAllowance allowance;
  for (int step = 0; step < 1000; ++step) refill(allowance, law, 0.01);
  EXPECT_TRUE(take_increment(allowance, law, 0));
  EXPECT_FALSE(take_increment(allowance, law, 0));
}

}  // namespace
}  // namespace sunder::fracture
