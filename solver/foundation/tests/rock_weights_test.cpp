#include "solver/foundation/rock_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/convolution/direct_sum.hpp"
#include "solver/foundation/impulse_response.hpp"
#include "solver/foundation/tests/lines.hpp"

namespace sunder::foundation {
namespace {

UnboundedDomain small_block() {
  return unbounded_domain(sbfem::coefficients(block_line(1, 1, 2, 1, 2), unit_rock));
}

/// Away from t = 0 a weight over the step is M(t), with the square of the step, for motions that the step resolves.
/// Stiff shapes of the line ring on from t = 0 as under average acceleration itself, so single entries do not converge.
TEST(RockWeights, SampleTheImpulseResponseToSecondOrder) {
  const UnboundedDomain domain = small_block();
  const std::vector<double> times{4.0};
  const Eigen::MatrixXd exact = impulse_response(domain, times).M[0];
  for (const int component : {0, 1}) {
    std::vector<double> errors;
    for (const double dt : {0.2, 0.1, 0.05}) {
      const auto last = static_cast<long long>(std::lround(4.0 / dt));
      const RockWeights rock = rock_weights(domain, dt, last);
      ASSERT_EQ(rock.path.status, StiffnessStatus::converged);
      const Eigen::MatrixXd W = rock.weights.dense(last);
      errors.push_back(std::abs(translation(W, component) / dt / translation(exact, component) - 1.0));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.3) << component;
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.2) << component;
  }
}

TEST(RockWeights, AreSymmetricAndBeginWithMoreThanTheRadiation) {
  const UnboundedDomain domain = small_block();
  const RockWeights rock = rock_weights(domain, 0.1, 50);
  for (const long long j : {0LL, 1LL, 50LL}) {
    const Eigen::MatrixXd W = rock.weights.dense(j);
    EXPECT_EQ((W - W.transpose()).norm(), 0.0);
  }
  // W_0 = M(2/Δt) = (Δt/2) C + (Δt/2)² K + …
  EXPECT_GT(translation(Eigen::MatrixXd(rock.weights.dense(0)), 0), 0.05 * 5.4);
}

/// M grows with time and so do errors of its weights; what they do to a force after thousands of steps is bounded by
/// what two different contours differ by.
TEST(RockWeights, HoldTheForceAfterThousandsOfSteps) {
  const UnboundedDomain domain = small_block();
  constexpr long long steps = 4000;
  constexpr double dt = 0.1;
  convolution::WeightSequence usual = rock_weights(domain, dt, steps).weights;
  convolution::WeightSequence fine =
      rock_weights(domain, dt, steps, {.stiffness = {.tolerance = 1e-12}, .oversampling = 8}).weights;
  const double worst = (usual.values - fine.values).colwise().norm().maxCoeff() / fine.values.col(steps).norm();
  EXPECT_LT(worst, 1e-7) << "1e-10 a step of the integration, raised by r^-N = 1.6e5 where it is not smooth";
  convolution::DirectSum one(std::move(usual), steps), other(std::move(fine), steps);
  const int n = one.size();
  Eigen::VectorXd a(n), force(n), reference(n);
  double largest = 0.0, difference = 0.0;
  for (long long step = 0; step <= steps; ++step) {
    for (int i = 0; i < n; ++i) a[i] = step < 500 ? std::sin(0.05 * static_cast<double>(step) + i % 2) : 0.0;
    one.history_force(force);
    other.history_force(reference);
    largest = std::max(largest, reference.norm());
    difference = std::max(difference, (force - reference).norm());
    one.append(a);
    other.append(a);
  }
  EXPECT_LT(difference, 1e-6 * largest);
}

TEST(RockWeights, StopWhereTheStiffnessStops) {
  const RockWeights rock = rock_weights(small_block(), 0.1, 10, {.stiffness = {.max_steps = 3}});
  EXPECT_EQ(rock.path.status, StiffnessStatus::too_many_steps);
  EXPECT_EQ(rock.weights.values.size(), 0);
  EXPECT_THROW((void)rock_weights(small_block(), 0.0, 10), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::foundation
