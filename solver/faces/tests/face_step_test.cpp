#include "solver/faces/face_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/faces/uniform_water.hpp"

namespace sunder::faces {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Water that answers a closing face with c · rate² and an opening one with nothing, each pair for itself: the
/// stiffness and the kink of the real one, and a closed form.
class SquareWater final : public FaceWater {
 public:
  SquareWater(Eigen::Index pairs, double c) : c_(c), accepted_(VectorXd::Zero(pairs)), last_(VectorXd::Zero(pairs)) {}
  Eigen::Index pairs() const override { return accepted_.size(); }
  Eigen::Index forces() const override { return accepted_.size(); }
  bool trial(std::span<const double> openings, double mouth, double time_step, WaterForces& result) override {
    result.by_opening.setZero();
    for (Eigen::Index i = 0; i < accepted_.size(); ++i) {
      last_[i] = openings[static_cast<std::size_t>(i)];
      const double rate = std::fmin((last_[i] - accepted_[i]) / time_step, 0.0);
      result.force[i] = mouth + c_ * rate * rate;
      result.by_opening(i, i) = 2.0 * c_ * rate / time_step;
      result.by_mouth[i] = 1.0;
    }
    return true;
  }
  void accept() override { accepted_ = last_; }

 private:
  double c_;
  VectorXd accepted_, last_;
};

FaceStructure one_crack(MatrixXd answer, FaceWater* water = nullptr) {
  const Eigen::Index n = answer.rows();
  return {.cracks = {{.first = 0, .pairs = n, .forces = n, .water = water}},
          .answer = std::move(answer),
          .mouth = MatrixXd::Zero(1, n),
          .tributary_length = VectorXd::Constant(n, 0.5)};
}

MatrixXd beam_like(int n) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> values(-1.0, 1.0);
  const MatrixXd A = MatrixXd::NullaryExpr(n, n, [&] { return values(engine); });
  return 1e-10 * (A * A.transpose() + 0.1 * MatrixXd::Identity(n, n));
}

const VectorXd no_mouth = VectorXd::Zero(1);

TEST(FaceStep, WithoutContactTheFacesOverlapAsTheyWould) {
  FaceStep step(one_crack(MatrixXd::Constant(1, 1, 1e-9)), {});
  const FaceStepResult& result = step.solve(VectorXd::Constant(1, -0.02), no_mouth, 0.01);
  EXPECT_EQ(result.status, FaceStatus::solved);
  EXPECT_EQ(result.opening[0], -0.02);
  EXPECT_EQ(result.largest_penetration, 0.02);
}

TEST(FaceStep, ExactContactClosesTheGapAndNoMore) {
  FaceStep step(one_crack(MatrixXd::Constant(1, 1, 1e-9)), {.contact = ContactRule::exact});
  const FaceStepResult& pressed = step.solve(VectorXd::Constant(1, -1e-3), no_mouth, 0.01);
  EXPECT_EQ(pressed.status, FaceStatus::solved);
  EXPECT_NEAR(pressed.contact_force[0], 1e6, 1e-6);  // g = g* + S λ = 0
  EXPECT_LE(std::abs(pressed.opening[0]), 1e-18);
  const FaceStepResult& open = step.solve(VectorXd::Constant(1, 2e-3), no_mouth, 0.01);
  EXPECT_EQ(open.contact_force[0], 0.0);
  EXPECT_EQ(open.opening[0], 2e-3);
}

TEST(FaceStep, PenaltyIsEnlargedUntilTheGateHoldsAndTendsToExactContact) {
  const MatrixXd S = beam_like(12);
  const VectorXd motion = VectorXd::LinSpaced(12, -4e-3, 2e-3);
  FaceStep exact(one_crack(S), {.contact = ContactRule::exact});
  const VectorXd reference = exact.solve(motion, no_mouth, 0.01).contact_force;
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    FaceStep penalty(one_crack(S), {.contact = ContactRule::penalty, .penetration_tolerance = tolerance});
    const FaceStepResult& result = penalty.solve(motion, no_mouth, 0.01);
    ASSERT_EQ(result.status, FaceStatus::solved);
    EXPECT_LE(result.largest_penetration, tolerance);
    EXPECT_NEAR(result.stiffness, 1e8 * std::pow(10.0, result.enlargements), 1e-6 * result.stiffness);
    // λ = k L · penetration: the error of λ is proportional to 1/k, so it falls with the tolerance
    const double error = (result.contact_force - reference).norm() / reference.norm();
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(FaceStep, StiffWaterIsSolvedWithTheMotion) {
  // g = g* + S c (g/Δt)², g < 0: the smaller root. The gain S ∂f/∂g at the trial motion runs from 0.02 to 2e12.
  const double dt = 0.01, motion = -1e-3, S = 1e-9;
  for (const double c : {1e4, 1e8, 1e12, 1e18}) {
    SquareWater water(1, c);
    FaceStep step(one_crack(MatrixXd::Constant(1, 1, S), &water), {});
    const FaceStepResult& result = step.solve(VectorXd::Constant(1, motion), no_mouth, dt);
    ASSERT_EQ(result.status, FaceStatus::solved) << c;
    const double b = S * c / (dt * dt);
    const double exact = 2.0 * motion / (1.0 + std::sqrt(1.0 - 4.0 * b * motion));
    EXPECT_NEAR(result.opening[0], exact, 1e-8 * 1e-3) << c;
    EXPECT_EQ(result.parts, 1) << c;
  }
}

TEST(FaceStep, WaterAndContactTogether) {
  // Closing is resisted by water on every pair and stopped by contact on some.
  const int n = 12;
  const MatrixXd S = beam_like(n);
  const VectorXd motion = VectorXd::LinSpaced(n, -8e-3, 2e-3);
  for (const ContactRule rule : {ContactRule::exact, ContactRule::penalty}) {
    SquareWater water(n, 3e8);
    FaceStep step(one_crack(S, &water), {.contact = rule});
    const FaceStepResult& result = step.solve(motion, VectorXd::Constant(1, 2e5), 0.01);
    ASSERT_EQ(result.status, FaceStatus::solved);
    for (int i = 0; i < n; ++i) {
      const double rate = std::fmin(result.opening[i] / 0.01, 0.0);
      const double water_force = 2e5 + 3e8 * rate * rate;
      // inequality 1 allows 1e-9 of 8 mm; the water's slope turns it into a force
      const double slope = std::abs(2.0 * 3e8 * rate / 0.01);
      EXPECT_NEAR(result.force[i] - result.contact_force[i], water_force, 1e-6 * water_force + 1e-11 * slope);
      EXPECT_GE(result.contact_force[i], 0.0);
      EXPECT_GE(result.opening[i], rule == ContactRule::exact ? -1e-11 : -1e-4);
    }
  }
}

TEST(FaceStep, TheMouthFollowsTheFaces) {
  // p = p* + R y with y = share · p: p = p* / (1 - R share).
  const double share = 3.0, R = -0.25;
  UniformWater water(1, VectorXd::Constant(1, share));
  FaceStructure structure = one_crack(MatrixXd::Constant(1, 1, 1e-9), &water);
  structure.mouth(0, 0) = R;
  FaceStep step(std::move(structure), {});
  const FaceStepResult& result = step.solve(VectorXd::Constant(1, 1e-3), VectorXd::Constant(1, 4e5), 0.01);
  ASSERT_EQ(result.status, FaceStatus::solved);
  EXPECT_NEAR(result.mouth_pressure[0], 4e5 / (1.0 - R * share), 1e-6);
  EXPECT_NEAR(result.opening[0], 1e-3 + 1e-9 * share * 4e5 / 1.75, 1e-12);
}

TEST(FaceStep, ASecondSolveFromTheAcceptedAnswerTakesNoIterationMoreThanOne) {
  SquareWater water(6, 1e8);
  FaceStep step(one_crack(beam_like(6), &water), {.contact = ContactRule::exact});
  const VectorXd motion = VectorXd::LinSpaced(6, -3e-3, 1e-3);
  const VectorXd first = step.solve(motion, no_mouth, 0.01).opening;
  const FaceStepResult& again = step.solve(motion, no_mouth, 0.01);
  EXPECT_LE(again.iterations, 1);
  EXPECT_LE((again.opening - first).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(FaceStep, RefusesWhatItCannotUse) {
  const MatrixXd S = MatrixXd::Constant(1, 1, 1e-9);
  EXPECT_THROW(FaceStep(one_crack(S), {.growth_factor = 1.0}), std::invalid_argument);
  EXPECT_THROW(FaceStep(one_crack(S), {.initial_stiffness = 0.0}), std::invalid_argument);
  EXPECT_THROW(FaceStep(one_crack(S * NAN), {}), std::invalid_argument);
  FaceStructure unequal = one_crack(S);
  unequal.tributary_length.resize(2);
  EXPECT_THROW(FaceStep(std::move(unequal), {}), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::faces
