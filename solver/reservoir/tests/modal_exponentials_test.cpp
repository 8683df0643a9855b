/// The memory of water over a rigid bottom as exponentials, against its weights in closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/reservoir/modal_exponentials.hpp"

namespace sunder::reservoir {
namespace {

FaceModes rigid_modes(int elements = 6) {
  return face_modes(pressure_mesh(uniform_face(80.0, elements, 2), 80.0),
                    {.density = 1000.0, .sound_speed = 1440.0, .reflection_coefficient = 1.0});
}

/// Largest over the modes of Σ_j |w_j - w~_j| / Σ_j |w_j|, by weights that are all kept.
double error_against_weights(const FaceModes& modes, double time_step, const convolution::ExponentialSums& sums) {
  const convolution::WeightSequence exact = modal_weights(modes, time_step, sums.certified_lags);
  double worst = 0.0;
  for (Eigen::Index k = 0; k < exact.size; ++k) {
    double error = std::abs(exact.values(k, 0) - sums.mass[k]), total = std::abs(exact.values(k, 0));
    Eigen::ArrayXcd power = sums.weight.col(k);
    for (Eigen::Index j = 1; j < exact.values.cols(); ++j) {
      error += std::abs(exact.values(k, j) - power.sum().real());
      total += std::abs(exact.values(k, j));
      power *= sums.decay.col(k).array();
    }
    worst = std::fmax(worst, error / total);
  }
  return worst;
}

TEST(ModalExponentials, ErrAsTheySayWhateverTheStep) {
  const FaceModes modes = rigid_modes();
  // c Δt/H from 2e-3, all angles small, to 20, all near π
  for (const double time_step : {1e-4, 0.01, 0.05, 1.0}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const convolution::ExponentialSums sums = modal_exponentials(modes, time_step, 3000, tolerance);
      EXPECT_TRUE(sums.within_tolerance) << time_step << ' ' << tolerance << ": " << sums.error.relative;
      EXPECT_LE(sums.error.relative, tolerance);
      // two orders of adding up the same numbers
      EXPECT_NEAR(error_against_weights(modes, time_step, sums), sums.error.relative, 1e-12 + 1e-6 * tolerance);
    }
  }
}

TEST(ModalExponentials, ThousandTimesTheStepsNeedAFewNodesMore) {
  const FaceModes modes = rigid_modes(2);
  const auto few = modal_exponentials(modes, 0.01, 100, 1e-6), many = modal_exponentials(modes, 0.01, 100'000, 1e-6);
  EXPECT_TRUE(few.within_tolerance && many.within_tolerance);
  // ln(1000) / h with h = π² / ln(1 / 0.3e-6): ten
  EXPECT_LE(many.decay.rows(), few.decay.rows() + 11);
}

TEST(ModalExponentials, SayTheSameForOneThreadAndTwo) {
  numerics::ThreadPool pool(2);
  const auto alone = modal_exponentials(rigid_modes(), 0.01, 10'000, 1e-5),
             together = modal_exponentials(rigid_modes(), 0.01, 10'000, 1e-5, &pool);
  EXPECT_EQ(alone.error.absolute, together.error.absolute);
  EXPECT_EQ(alone.error.relative, together.error.relative);
  EXPECT_EQ(alone.weight, together.weight);
}

TEST(ModalExponentials, RefuseWhatTheyCannotMake) {
  const FaceModes modes = rigid_modes(1);
  EXPECT_THROW((void)modal_exponentials(modes, 0.0, 10, 1e-5), std::invalid_argument);
  EXPECT_THROW((void)modal_exponentials(modes, 0.01, 0, 1e-5), std::invalid_argument);
  EXPECT_THROW((void)modal_exponentials(modes, 0.01, 10, 1e-13), std::invalid_argument);
  EXPECT_THROW((void)modal_exponentials(modes, 0.01, 10, NAN), std::invalid_argument);
}

TEST(FaceConvolution, OfFewExponentialsIsThatOfAllWeights) {
  for (const double alpha : {1.0, 0.9}) {
    FaceModes modes = rigid_modes(3);
    modes.water.reflection_coefficient = alpha;
    constexpr int steps = 600;
    const auto exact = face_convolution(modes, 0.01, steps),
               brief = face_convolution(modes, 0.01, steps,
                                        {.method = convolution::Method::state_space, .reduction = {.tolerance = 1e-4}});
    ASSERT_TRUE(brief.within_tolerance) << brief.error.relative;
    EXPECT_LE((exact.convolution->instantaneous_mass() - brief.convolution->instantaneous_mass()).norm(),
              1e-12 * exact.convolution->instantaneous_mass().norm());
    const int n = modes.size();
    Eigen::VectorXd a(n), one(n), other(n);
    double worst = 0.0, largest = 0.0;
    for (int step = 0; step < steps; ++step) {
      exact.convolution->history_force(one);
      brief.convolution->history_force(other);
      worst = std::fmax(worst, (one - other).norm());
      for (int i = 0; i < n; ++i) a[i] = std::sin(0.3 * step + i) + std::cos(2.7 * step * (i + 1));
      largest = std::fmax(largest, a.norm());
      exact.convolution->append(a);
      brief.convolution->append(a);
    }
    EXPECT_LE(worst, brief.error.absolute * largest) << alpha;
  }
}

}  // namespace
}  // namespace sunder::reservoir
