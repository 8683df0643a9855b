#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "solver/dynamics/ground_motion.hpp"
#include "solver/dynamics/rayleigh.hpp"
#include "solver/dynamics/time_scheme.hpp"

namespace sunder::dynamics {
namespace {

double radius(const TimeScheme& scheme, double phase) {
  double largest = 0.0;
  for (const std::complex<double>& value : amplification(scheme, phase)) largest = std::max(largest, std::abs(value));
  return largest;
}

TEST(TimeScheme, AverageAccelerationKeepsEveryAmplitude) {
  for (const double phase : {1e-3, 0.1, 1.0, 10.0, 1e3}) EXPECT_NEAR(radius(newmark(), phase), 1.0, 1e-12) << phase;
}

TEST(TimeScheme, SpectralRadiusAtInfiniteFrequencyIsTheOneAskedFor) {
  // Below infinity the radius differs by O(1 / phase²); a triple eigenvalue loses the cube root of round-off.
  for (const double rho : {0.5, 0.7, 0.9, 1.0}) EXPECT_NEAR(radius(hht_alpha(rho), 1e7), rho, 2e-5) << rho;
  for (const double rho : {0.2, 0.5, 0.8, 1.0}) EXPECT_NEAR(radius(generalised_alpha(rho), 1e7), rho, 2e-5) << rho;
}

TEST(TimeScheme, NoneGrowsAnywhere) {
  for (double phase = 1e-4; phase < 1e5; phase *= 1.5) {
    for (const double rho : {0.5, 0.8, 1.0}) EXPECT_LE(radius(hht_alpha(rho), phase), 1.0 + 1e-10) << phase;
    for (const double rho : {0.2, 0.5, 0.8}) EXPECT_LE(radius(generalised_alpha(rho), phase), 1.0 + 1e-10) << phase;
    // At ρ = 1 the eigenvalue of the acceleration's memory is -1 for every phase, and the other two come to it with
    // growing phase: of a triple eigenvalue round-off leaves its cube root, 6e-6, times a factor of order one.
    EXPECT_LE(radius(generalised_alpha(1.0), phase), 1.0 + 2e-5) << phase;
  }
}

TEST(TimeScheme, RefusesARadiusOutsideItsRange) {
  EXPECT_THROW((void)hht_alpha(0.4), std::invalid_argument);
  EXPECT_THROW((void)generalised_alpha(1.1), std::invalid_argument);
  EXPECT_THROW((void)generalised_alpha(NAN), std::invalid_argument);
}

TEST(Rayleigh, GivesTheRatioAtBothFrequencies) {
  const Rayleigh damping = rayleigh(0.05, 17.975, 47.486);
  EXPECT_NEAR(damping.ratio(17.975), 0.05, 1e-16);
  EXPECT_NEAR(damping.ratio(47.486), 0.05, 1e-16);
  EXPECT_NEAR(stiffness_proportional(0.03, 18.9).ratio(18.9), 0.03, 1e-16);
  EXPECT_THROW((void)rayleigh(0.05, 2.0, 1.0), std::invalid_argument);
}

class Record : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / name;
    std::ofstream(file) << text;
    return file;
  }
  std::string refusal(const std::string& name, const std::string& text) {
    try {
      (void)read_ground_motion(write(name, text));
    } catch (const RecordError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(Record, IsLinearBetweenSamplesAndNothingOutside) {
  const GroundMotion motion =
      read_ground_motion(write("a.csv", "time [s],acceleration [m/s2]\n0,0\n0.01,2\n0.02,-1\n"));
  EXPECT_EQ(motion.at(0.01), 2.0);
  EXPECT_NEAR(motion.at(0.0125), 1.25, 1e-12);
  EXPECT_EQ(motion.at(0.02), -1.0);
  EXPECT_EQ(motion.at(0.03), 0.0);
  EXPECT_EQ(motion.at(-1.0), 0.0);
}

TEST_F(Record, OfPeerIsInUnitsOfGravity) {
  const GroundMotion motion = read_ground_motion(write(
      "b.AT2",
      "PEER\nsome quake\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  5, DT=  .0050 SEC\n 0.1 0.2 -.3\n 1E-2 0\n"));
  ASSERT_EQ(motion.acceleration.size(), 5u);
  EXPECT_EQ(motion.sample_step, 0.005);
  EXPECT_NEAR(motion.acceleration[2], -0.3 * 9.80665, 1e-15);
}

double last_velocity(const GroundMotion& motion) {
  double velocity = 0.0;
  for (std::size_t i = 1; i < motion.acceleration.size(); ++i)
    velocity += 0.5 * motion.sample_step * (motion.acceleration[i - 1] + motion.acceleration[i]);
  return velocity;
}

TEST(Baseline, AParabolaIsTakenOffWholly) {
  GroundMotion motion{.start = 2.0, .sample_step = 0.02, .acceleration = {}};
  for (int i = 0; i < 500; ++i) motion.acceleration.push_back(0.3 - 0.02 * i + 1e-4 * i * i);
  // The fit is exact; the normal equations of 1, t, t² on 0 … 1 lose about four of sixteen digits of 20 m/s².
  for (const double value : baseline_corrected(motion).acceleration) EXPECT_NEAR(value, 0.0, 1e-9);
}

TEST(Baseline, SecondCorrectionChangesNothing) {
  GroundMotion motion{.start = 0.0, .sample_step = 0.01, .acceleration = {}};
  for (int i = 0; i < 700; ++i) motion.acceleration.push_back(std::sin(0.11 * i) + 0.02 + 1e-4 * i);
  const GroundMotion once = baseline_corrected(motion), twice = baseline_corrected(once);
  EXPECT_LT(std::abs(last_velocity(once)), 0.2 * std::abs(last_velocity(motion)));  // the drift is what it takes off
  for (std::size_t i = 0; i < 700; ++i) EXPECT_NEAR(twice.acceleration[i], once.acceleration[i], 1e-10);
}

TEST(Baseline, NeedsMoreSamplesThanCoefficients) {
  const GroundMotion motion{.start = 0.0, .sample_step = 0.01, .acceleration = {1.0, 2.0, 3.0}};
  EXPECT_THROW((void)baseline_corrected(motion), std::invalid_argument);
}

TEST_F(Record, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_NE(refusal("c.csv", "0,0\n0.01,nan\n").find("c.csv:2: acceleration: \"nan\" is not finite"),
            std::string::npos);
  EXPECT_NE(refusal("d.csv", "0,0\n0.01,1\n0.03,1\n").find("d.csv:3: the time step changes"), std::string::npos);
  EXPECT_NE(refusal("e.csv", "0,0\n0.01,1,7\n").find("e.csv:2: has 3 column(s)"), std::string::npos);
  EXPECT_NE(refusal("f.csv", "0,0\n0.01,x\n").find("f.csv:2: acceleration: \"x\" is no number"), std::string::npos);
  EXPECT_NE(refusal("g.csv", "0,0\n0,1\n").find("g.csv:2: time 0 does not follow"), std::string::npos);
  EXPECT_NE(refusal("h.csv", "time,acceleration\n").find("0 sample(s)"), std::string::npos);
  EXPECT_NE(refusal("i.at2", "a\nb\nc\nNPTS= 3, DT= .01\n1 2\n").find("has 2 samples, but NPTS says 3"),
            std::string::npos);
  EXPECT_NE(refusal("j.at2", "a\nb\nc\nNPTS= 1e300, DT= .01\n1 2\n").find("but NPTS says 1e300"), std::string::npos);
  EXPECT_NE(refusal("k.at2", "a\nb\nc\nNPTS= 2, DT= .01\n1 1e308\n").find("\"1e308\" g is not finite"),
            std::string::npos);
  EXPECT_NE(refusal("l.at2", "a\nb\nc\nNPTS= 3, DT= 1e308\n1 2 3\n").find("more time than a number holds"),
            std::string::npos);
  EXPECT_NE(refusal("m.csv", "-1e308,0\n1e308,1\n").find("does not follow"), std::string::npos);
  EXPECT_THROW((void)read_ground_motion("nowhere/at/all.csv"), RecordError);
}

}  // namespace
}  // namespace sunder::dynamics
