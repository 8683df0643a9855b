#include "solver/simulation/step_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <tuple>

#include "solver/convolution/make_convolution.hpp"
#include "solver/numerics/tests/allocation_count.hpp"
#include "solver/simulation/energy_account.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int nodes = 12, dofs = 2 * nodes, wet = 5;
constexpr double time_step = 0.05, eps = std::numeric_limits<double>::epsilon();

/// A chain of nodes with springs along and across, held at its first node, beside water and rock that remember.
struct ChainInMedia {
  MatrixXd K = MatrixXd::Zero(dofs, dofs), M = MatrixXd::Zero(dofs, dofs);
  Constraints constraints{dofs};
  AttachedMedium water, rock;

  explicit ChainInMedia(long long steps) {
    for (int i = 0; i + 1 < nodes; ++i) {
      const Index at = 2 * Index{i};
      Eigen::Matrix2d spring;
      spring << 400.0 + i, 60.0, 60.0, 150.0;
      for (const auto& [r, c, sign] : {std::tuple{0, 0, 1.0}, {2, 2, 1.0}, {0, 2, -1.0}, {2, 0, -1.0}})
        K.block<2, 2>(at + r, at + c) += sign * spring;
      for (const auto& [r, c, share] : {std::tuple{0, 0, 2.0}, {2, 2, 2.0}, {0, 2, 1.0}, {2, 0, 1.0}})
        M.block<2, 2>(at + r, at + c) += share / 6.0 * Eigen::Matrix2d::Identity();
    }
    for (const int dof : {0, 1}) constraints.prescribe(dof, 0.0);
    make(water, "reservoir", DrivenBy::total, 4, steps);
    make(rock, "foundation", DrivenBy::relative, 5, steps);
  }

  static void make(AttachedMedium& medium, const char* name, DrivenBy driven_by, int first, long long steps) {
    medium.name = name;
    medium.driven_by = driven_by;
    for (int i = 0; i < wet; ++i) medium.dofs.push_back(first + 4 * i);
    convolution::WeightSequence weights{wet, false, MatrixXd(wet * wet, steps + 1)};
    const VectorXd shape = VectorXd::LinSpaced(wet, 0.3, 0.8);
    MatrixXd W = shape * shape.transpose();
    W.diagonal().array() += 0.4;
    for (long long j = 0; j <= steps; ++j)
      weights.values.col(j) = (std::pow(0.6, static_cast<double>(j)) * W).reshaped();
    medium.convolution = convolution::make_convolution(weights, steps).convolution;
  }

  std::vector<AttachedMedium*> media() { return {&water, &rock}; }
  std::vector<const AttachedMedium*> constant_media() const { return {&water, &rock}; }
};

StepLoad load_at(double time) {
  StepLoad load{.force = VectorXd::Zero(dofs), .ground = {std::sin(9.0 * time), 0.3 * std::cos(4.0 * time)}};
  load.force[dofs - 2] = std::cos(6.0 * time);
  return load;
}

VectorXd at_rest() {
  return VectorXd::Zero(dofs);
}

/// C v + K u + ΣR - f + M r a_g at one end of a step.
VectorXd without_inertia(const ChainInMedia& chain, const StepEquations& equations, const MotionState& state,
                         const StepLoad& load) {
  const dynamics::Rayleigh& damping = equations.options().damping;
  VectorXd sum = damping.of_mass * (chain.M * state.velocity) +
                 chain.K * (state.displacement + damping.of_stiffness * state.velocity) - load.force;
  for (Index dof = 0; dof < dofs; ++dof) sum += chain.M.col(dof) * load.ground[dof % 2];
  const std::vector<const AttachedMedium*> media = chain.constant_media();
  for (std::size_t m = 0; m < media.size(); ++m)
    for (Index i = 0; i < wet; ++i) sum[media[m]->dofs[static_cast<std::size_t>(i)]] += equations.medium_forces()[m][i];
  return sum;
}

TEST(StepEquations, HoldInEveryStepOfEveryScheme) {
  constexpr int steps = 70;
  for (const dynamics::TimeScheme& scheme :
       {dynamics::newmark(), dynamics::hht_alpha(0.7), dynamics::generalised_alpha(0.4)}) {
    ChainInMedia chain(steps);
    StepEquations equations(chain.K.sparseView(), chain.M.sparseView(), chain.constraints, chain.constant_media(),
                            {.scheme = scheme, .time_step = time_step, .damping = {0.2, 0.003}});
    ASSERT_EQ(equations.status(), numerics::FactorStatus::factorised);
    MotionState state{.displacement = at_rest(), .velocity = at_rest(), .acceleration = at_rest()}, next = state;
    StepLoad start = load_at(0.0);
    equations.stand_at(state);
    equations.begin(state, start.ground, chain.media());
    for (int step = 1; step <= steps; ++step) {
      const StepLoad end = load_at(time_step * step);
      const VectorXd before = without_inertia(chain, equations, state, start);
      const VectorXd d = equations.trial(state, start, end);
      equations.advance(state, d, next);
      equations.accept(next, end.ground, chain.media());
      const VectorXd residual =
          chain.M * ((1.0 - scheme.alpha_m) * next.acceleration + scheme.alpha_m * state.acceleration) +
          (1.0 - scheme.alpha_f) * without_inertia(chain, equations, next, end) + scheme.alpha_f * before;
      // a solution's backward error, on the numbers that a' and the right side are sums of
      const double scale = (chain.M.norm() + 4.0) * (d.norm() / (scheme.beta * time_step * time_step) +
                                                     state.velocity.norm() / (scheme.beta * time_step) + 1.0) +
                           chain.K.norm() * next.displacement.norm();
      EXPECT_LT(residual.tail(dofs - 2).norm(), 50.0 * eps * scale) << step;
      EXPECT_EQ(next.displacement.head(2).norm(), 0.0);
      std::swap(state, next);
      start = end;
    }
  }
}

TEST(StepEquations, StepWithoutAllocating) {
  constexpr int steps = 200;
  ChainInMedia chain(steps);
  const std::vector<AttachedMedium*> media = chain.media();
  StepEquations equations(chain.K.sparseView(), chain.M.sparseView(), chain.constraints, chain.constant_media(),
                          {.scheme = dynamics::newmark(), .time_step = time_step, .damping = {0.2, 0.003}});
  MotionState state{.displacement = at_rest(), .velocity = at_rest(), .acceleration = at_rest()}, next = state;
  StepLoad start = load_at(0.0), end = start;
  equations.stand_at(state);
  EnergyAccount energy;
  energy.begin(equations, state);
  std::vector<VectorXd> media_before = equations.medium_forces();
  const VectorXd none;
  long before = 0;
  for (int step = 1; step <= steps; ++step) {
    if (step == 3) before = numerics::allocations;
    end.ground = {std::sin(0.4 * step), 0.2};
    equations.advance(state, equations.trial(state, start, end), next);
    equations.accept(next, end.ground, media);
    energy.add(equations, state, next, start, end, media_before, FaceWork(), none);
    media_before = equations.medium_forces();
    std::swap(state, next);
    std::swap(start, end);
  }
  EXPECT_EQ(numerics::allocations - before, 0);
  EXPECT_GT(state.displacement.norm(), 0.0);
}

TEST(EnergyAccount, StaysClosedOverALongRun) {
  // Free vibration and damping by average acceleration, where the account closes exactly: each of the steps leaves a
  // few tens of eps of the energy, at worst all of one sign.
  constexpr int steps = 100'000;
  ChainInMedia chain(1);
  StepEquations equations(chain.K.sparseView(), chain.M.sparseView(), chain.constraints, {},
                          {.scheme = dynamics::newmark(), .time_step = time_step, .damping = {1e-5, 1e-8}});
  MotionState state{.displacement = at_rest(), .velocity = at_rest(), .acceleration = at_rest()}, next = state;
  state.velocity.tail(dofs - 2) = VectorXd::LinSpaced(dofs - 2, 0.2, -1.0);
  const StepLoad none{.force = at_rest()};
  // the acceleration of the first instant: M a = -C v on the free dofs, K u = 0
  const MatrixXd C = 1e-5 * chain.M + 1e-8 * chain.K;
  state.acceleration.tail(dofs - 2) =
      -chain.M.bottomRightCorner(dofs - 2, dofs - 2).llt().solve((C * state.velocity).tail(dofs - 2));
  equations.stand_at(state);
  EnergyAccount energy;
  energy.begin(equations, state);
  const double begun_with = energy.energies().stored();
  for (int step = 1; step <= steps; ++step) {
    equations.advance(state, equations.trial(state, none, none), next);
    equations.accept(next, none.ground, {});
    energy.add(equations, state, next, none, none, {}, FaceWork(), VectorXd());
    std::swap(state, next);
  }
  EXPECT_LT(energy.balance_error(), 30.0 * eps * steps);
  EXPECT_NEAR(energy.energies().stored() + energy.energies().damped, begun_with, 30.0 * eps * steps * begun_with);
  EXPECT_GT(energy.energies().damped, 0.02 * begun_with);
}

}  // namespace
}  // namespace sunder::simulation
