/// Weights from Laplace transforms whose series are known, the state space and its certificate, allocations.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/contour_weights.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/convolution/make_convolution.hpp"
#include "solver/convolution/simple_convolutions.hpp"
#include "solver/convolution/state_space.hpp"
#include "solver/numerics/tests/allocation_count.hpp"

namespace sunder::convolution {
namespace {

using numerics::allocations;

using Complex = std::complex<double>;

/// M(s) = 1 / √(s² + ω²), of J0(ωt): its weights are (Δt/2) cos(θ/2) (P_j + P_{j-1})(cos θ), tan(θ/2) = ωΔt/2, because
/// 1/√(1 - 2xζ + ζ²) = Σ P_j(x) ζ^j.
Eigen::VectorXd bessel_weights(double omega, double time_step, int last) {
  const double theta = 2.0 * std::atan(0.5 * omega * time_step), x = std::cos(theta);
  Eigen::VectorXd w(last + 1);
  double now = 1.0, before = 0.0;
  for (int j = 0; j <= last; ++j) {
    w[j] = 0.5 * time_step * std::cos(0.5 * theta) * (now + before);
    const double next = ((2.0 * j + 1.0) * x * now - j * before) / (j + 1.0);
    before = now;
    now = next;
  }
  return w;
}

WeightSequence bessel_sequence(double omega, double time_step, int last, const ContourOptions& options = {}) {
  return contour_weights(
      1, time_step, last,
      [omega](const ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> M) {
        M(0, 0) = 1.0 / std::sqrt(at.s + Complex(0.0, omega)) / std::sqrt(at.s - Complex(0.0, omega));
      },
      options);
}

TEST(ContourWeights, AreTheLegendreSeriesOfABesselKernel) {
  for (const double step : {0.01, 1.0, 50.0})
    for (const int last : {0, 1, 40, 2000}) {
      SCOPED_TRACE(step * 1e4 + last);
      const Eigen::VectorXd exact = bessel_weights(1.3, step, last);
      const WeightSequence weights = bessel_sequence(1.3, step, last);
      // both errors of the header are at most eps^(2/3) = 4e-11 of the largest weight
      EXPECT_LE((weights.values.row(0).transpose() - exact).cwiseAbs().maxCoeff(), 1e-10 * exact.maxCoeff());
      const WeightSequence finer = bessel_sequence(1.3, step, last, {.oversampling = 8});  // eps^(8/9) = 1e-14
      EXPECT_LE((finer.values.row(0).transpose() - exact).cwiseAbs().maxCoeff(), 2e-13 * exact.maxCoeff());
    }
}

TEST(ContourWeights, RefuseWhatHasNoSeries) {
  const LaplaceMass one = [](const ContourPoint&, Eigen::Ref<Eigen::MatrixXcd> M) { M.setOnes(); };
  const LaplaceMass none = [](const ContourPoint&, Eigen::Ref<Eigen::MatrixXcd> M) { M.setConstant(NAN); };
  EXPECT_THROW((void)contour_weights(0, 1.0, 5, one), std::invalid_argument);
  EXPECT_THROW((void)contour_weights(1, 0.0, 5, one), std::invalid_argument);
  EXPECT_THROW((void)contour_weights(1, NAN, 5, one), std::invalid_argument);
  EXPECT_THROW((void)contour_weights(1, 1.0, -1, one), std::invalid_argument);
  EXPECT_THROW((void)contour_weights(1, 1.0, 5, one, {.oversampling = 0}), std::invalid_argument);
  EXPECT_THROW((void)contour_weights(1, 1.0, 5, none), std::invalid_argument);
}

/// A kernel that fades: J0 damped, in three coupled degrees of freedom.
WeightSequence fading(int last, bool diagonal) {
  Eigen::MatrixXd turn(3, 3);
  turn << 0.8, -0.6, 0.0, 0.48, 0.64, -0.6, 0.36, 0.48, 0.8;
  WeightSequence weights{3, diagonal, Eigen::MatrixXd(diagonal ? 3 : 9, last + 1)};
  const Eigen::VectorXd w[3] = {bessel_weights(1.0, 0.3, last), bessel_weights(2.5, 0.3, last),
                                bessel_weights(9.0, 0.3, last)};
  for (int j = 0; j <= last; ++j) {
    Eigen::VectorXd d(3);
    for (int i = 0; i < 3; ++i) d[i] = std::exp(-0.03 * j) * w[i][j];
    if (diagonal) {
      weights.values.col(j) = d;
    } else {
      weights.values.col(j) = (turn * d.asDiagonal() * turn.transpose()).reshaped();
    }
  }
  return weights;
}

TEST(StateSpace, KeepsToItsStatedErrorWhateverTheAccelerations) {
  for (const bool diagonal : {false, true}) {
    const WeightSequence weights = fading(900, diagonal);
    double before = 1.0;
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const StateSpaceModel model = reduce(weights, {.tolerance = tolerance});
      ASSERT_TRUE(model.within_tolerance) << tolerance << " " << model.error.relative;
      EXPECT_LE(model.error.relative, tolerance);
      EXPECT_LT(model.error.relative, before);  // a finer one is a better one
      before = model.error.relative;
      StateSpace states(model);
      DirectSum exact(weights, 900);
      Eigen::VectorXd a(3), mine(3), theirs(3);
      double worst = 0.0, largest = 0.0;
      for (int n = 0; n <= 900; ++n) {
        a << std::sin(0.7 * n), n % 7 < 3 ? 1.0 : -1.0, std::cos(0.01 * n * n);
        states.history_force(mine);
        exact.history_force(theirs);
        states.append(a);
        exact.append(a);
        worst = std::fmax(worst, (mine - theirs).norm());
        largest = std::fmax(largest, a.norm());
      }
      EXPECT_LE(worst, model.error.absolute * largest);
      EXPECT_GT(worst, 1e-4 * model.error.absolute * largest);  // the bound says something
    }
  }
}

TEST(StateSpace, FirstLagsMayStayAsTheyAre) {
  const WeightSequence weights = fading(900, false);
  const StateSpaceModel model = reduce(weights, {.tolerance = 1e-4, .direct_lags = 5});
  ASSERT_TRUE(model.within_tolerance);
  StateSpace states(model);
  Eigen::VectorXd force(3), unit = Eigen::VectorXd::Unit(3, 1);
  states.append(unit);
  for (int j = 1; j <= 30; ++j) {
    states.history_force(force);
    const double allowed = j <= 5 ? 1e-15 : model.error.absolute;
    EXPECT_LE((force - weights.weight(j) * unit).norm(), allowed) << j;
    states.append(Eigen::VectorXd::Zero(3));
  }
}

TEST(StateSpace, SaysWhereTheToleranceIsNotMet) {
  const WeightSequence weights = fading(300, false);
  const StateSpaceModel model = reduce(weights, {.tolerance = 1e-9, .most_states = 4});
  EXPECT_FALSE(model.within_tolerance);
  EXPECT_GT(model.error.relative, 1e-9);
  EXPECT_THROW((void)reduce(weights, {.tolerance = 0.0}), std::invalid_argument);
  EXPECT_THROW((void)reduce(weights, {.direct_lags = 65}), std::invalid_argument);
}

TEST(Transformed, IsTheCongruentWeights) {
  Eigen::MatrixXd G(3, 2);
  G << 1.0, 0.5, -0.3, 2.0, 0.7, -1.1;
  const WeightSequence inner = fading(60, true);
  WeightSequence outer{2, false, Eigen::MatrixXd(4, 61)};
  for (int j = 0; j <= 60; ++j) outer.values.col(j) = (G.transpose() * inner.weight(j) * G).reshaped();
  Transformed mine(G, std::make_unique<DirectSum>(inner, 60));
  DirectSum theirs(outer, 60);
  EXPECT_LE((mine.instantaneous_mass() - theirs.instantaneous_mass()).norm(), 1e-15);
  Eigen::VectorXd a(2), b(2);
  for (int n = 0; n <= 60; ++n) {
    mine.history_force(a);
    theirs.history_force(b);
    EXPECT_LE((a - b).norm(), 1e-13);
    a << std::sin(n), 1.0;
    mine.append(a);
    theirs.append(a);
  }
}

TEST(MakeConvolution, TakesWhatCostsLeast) {
  EXPECT_EQ(cheapest(3, 2), Method::direct);
  EXPECT_EQ(cheapest(100'000, 20), Method::block_fft);
  const WeightSequence weights = fading(100, false);
  for (const Method method : {Method::direct, Method::blocked_direct, Method::block_fft, Method::state_space})
    EXPECT_EQ(make_convolution(weights, 100, {.method = method, .reduction = {.tolerance = 1e-2}}).method, method);
  EXPECT_EQ(make_convolution(weights, 100).error.absolute, 0.0);
}

TEST(Allocations, AreNoneInAStep) {
  if (!numerics::counts_allocations) GTEST_SKIP() << "allocations are the sanitizer's";
  const WeightSequence weights = fading(300, false);
  const StateSpaceModel model = reduce(weights, {.tolerance = 1e-2, .direct_lags = 2});
  numerics::ThreadPool pool(2);
  DirectSum plain(weights, 300), blocked(weights, 300, {.block = 32, .pool = &pool});
  BlockFft fast(weights, 300, {.block = 16, .pool = &pool});
  StateSpace states(model);
  Transformed transformed(Eigen::MatrixXd::Identity(3, 3), std::make_unique<DirectSum>(weights, 300));
  InstantaneousMass mass(weights.weight(0));
  const long nothing = allocations;
  Eigen::VectorXd a(3), force(3);
  ASSERT_GT(allocations, nothing);  // the count counts
  a << 1.0, -2.0, 0.5;
  for (Convolution* c : {static_cast<Convolution*>(&plain), static_cast<Convolution*>(&blocked),
                         static_cast<Convolution*>(&fast), static_cast<Convolution*>(&states),
                         static_cast<Convolution*>(&transformed), static_cast<Convolution*>(&mass)}) {
    const long before = allocations;
    for (int n = 0; n <= 300; ++n) {
      c->history_force(force);
      c->append(a);
    }
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace sunder::convolution
