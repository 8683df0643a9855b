#include "solver/foundation/free_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/foundation/curved_line.hpp"
#include "solver/foundation/tests/lines.hpp"

namespace sunder::foundation {
namespace {

/// A record with corners, that starts and ends with a jump.
std::vector<double> record() {
  std::vector<double> a;
  for (int i = 0; i <= 40; ++i) a.push_back(std::cos(0.7 * i) - 0.3 * (i % 5));
  return a;
}

TEST(SampledMotion, IsLinearBetweenSamplesAndItsVelocityTheIntegral) {
  const SampledMotion motion(record(), 0.1);
  double velocity = 0.0;
  constexpr double h = 1e-3;  // 100 parts a sample: trapezia are exact on linear pieces
  for (int i = 0; i < 4000; ++i) {
    velocity += 0.5 * h * (motion.acceleration(i * h) + motion.acceleration((i + 1) * h));
    ASSERT_NEAR(motion.velocity((i + 1) * h), velocity, 1e-11) << i;
  }
  EXPECT_EQ(motion.acceleration(-1e-9), 0.0);
  EXPECT_EQ(motion.acceleration(4.1), 0.0);
  EXPECT_EQ(motion.velocity(7.0), motion.velocity(4.0));
  EXPECT_EQ(SampledMotion({}, 0.1).velocity(1.0), 0.0);
  EXPECT_THROW(SampledMotion({0.0, NAN}, 0.1), std::invalid_argument);
  EXPECT_THROW(SampledMotion({0.0}, 0.0), std::invalid_argument);
}

/// Newton's law for the rock inside the line, whatever its shape: Σ forces = ∫ ρ ü dA. The wave's ü does not depend on
/// x, and ∫ a over the depth is a difference of velocities: -2bρ ½c [v(t - d/c) - v(t + d/c)].
TEST(FreeField, ForcesCarryTheRockInside) {
  const sbfem::Boundary line = block_line(1.5, 0.8, 5, 3, 2);
  constexpr double dt = 0.05;
  const SampledMotion x(record(), 0.1), y(record(), 0.13);
  const FreeField field(line, unit_rock, x, y, dt);
  const double c_p = std::sqrt(3.0);
  Eigen::VectorXd acceleration(line.nodes.size()), force(line.nodes.size());
  for (int n = 0; n < 120; ++n) {
    field.at(n, acceleration, force);
    const double t = (n - field.delay()) * dt;
    Eigen::Vector2d total = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < line.nodes.cols(); ++i) total += force.segment<2>(2 * i);
    // n + 3 Gauss points on pieces of a piecewise quadratic: corners of the record fall inside edges on the sides only,
    // where horizontal motion has no horizontal and vertical motion no vertical force.
    EXPECT_NEAR(total.x(), 3.0 * 0.5 * (x.velocity(t + 0.8) - x.velocity(t - 0.8)), 1e-12) << n;
    EXPECT_NEAR(total.y(), 3.0 * 0.5 * c_p * (y.velocity(t + 0.8 / c_p) - y.velocity(t - 0.8 / c_p)), 1e-12) << n;
  }
}

TEST(FreeField, IsAtRestBeforeItArrivesAndShowsTheRecordAtTheSurface) {
  const sbfem::Boundary line = block_line(1.0, 0.52, 4, 2, 1);
  const FreeField field(line, unit_rock, SampledMotion(record(), 0.1), SampledMotion({}, 0.1), 0.1);
  EXPECT_EQ(field.delay(), 6) << "0.52 / c_s in steps of 0.1, rounded up";
  EXPECT_EQ(field.surface(5), Eigen::Vector2d::Zero());
  EXPECT_EQ(field.surface(6).x(), record()[0]);
  Eigen::VectorXd acceleration(line.nodes.size()), force(line.nodes.size());
  field.at(0, acceleration, force);
  EXPECT_EQ(acceleration.norm(), 0.0);
  field.at(8, acceleration, force);
  EXPECT_EQ(acceleration[0], field.surface(8).x()) << "the first node lies on the surface";
}

TEST(FreeField, BecomesARigidMotionAsTheRockStiffens) {
  const sbfem::Boundary line = block_line(30.0, 20.0, 6, 3, 1);
  double last = std::numeric_limits<double>::infinity();
  for (const double E : {1e9, 1e11, 1e13, 1e15}) {
    const material::Isotropic rock{.youngs_modulus = E, .poisson_ratio = 0.25, .density = 2500};
    std::vector<double> smooth;
    for (int i = 0; i < 400; ++i) smooth.push_back(std::pow(std::sin(0.02 * i), 2));
    const FreeField field(line, rock, SampledMotion(smooth, 0.01), SampledMotion({}, 0.01), 0.01);
    Eigen::VectorXd acceleration(line.nodes.size()), force(line.nodes.size());
    const int n = 150 + field.delay();
    field.at(n, acceleration, force);
    double worst = 0.0;
    for (Eigen::Index i = 0; i < acceleration.size(); i += 2)
      worst = std::max(worst, std::abs(acceleration[i] - field.surface(n).x()));
    EXPECT_LT(worst, 0.2 * last) << "at least first order in 1/c, c ten times as large";
    last = worst;
  }
}

TEST(FreeField, RefusesRockWithoutInertiaAndLinesAboveTheSurface) {
  const SampledMotion none({}, 0.1);
  material::Isotropic massless = unit_rock;
  massless.density = 0.0;
  EXPECT_THROW(FreeField(block_line(1, 1, 2, 1, 1), massless, none, none, 0.1), std::invalid_argument);
  EXPECT_THROW(FreeField(circle(1.0, 4, 1, false), unit_rock, none, none, 0.1), std::invalid_argument);
  EXPECT_THROW(FreeField(block_line(1, 1, 2, 1, 1), unit_rock, none, none, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::foundation
