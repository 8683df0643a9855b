// Which convolution stands for the water behind a face.

#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/convolution/simple_convolutions.hpp"
#include "solver/reservoir/face_water.hpp"
#include "solver/reservoir/modal_exponentials.hpp"

namespace sunder::reservoir {
namespace {

constexpr double most_bytes = 1e9;  // of the weights that a memory is made from

/// Weights until they have faded: what the last tenth of them still holds, and by its decay what lies beyond, is
/// `forgotten` of the sum of all.
struct FadingWeights {
  convolution::WeightSequence weights;
  double forgotten = 0.0;
};

FadingWeights fading_weights(const FaceModes& modes, double time_step, double forgotten, numerics::ThreadPool* pool) {
  // the branch points of M(s) lie at s H/c = ln(α)/2 ± …: the kernel fades at least like α^(c t / 2 H)
  const double alpha = std::fmax(modes.water.reflection_coefficient, 0.3);
  const double per_lag = -0.5 * std::log(alpha) * modes.water.sound_speed * time_step / modes.depth;
  const double n = modes.size(), most_lags = most_bytes / (8.0 * n * n);
  for (double lags = std::ceil(-std::log(forgotten) / per_lag) + 20.0; lags <= most_lags; lags *= 2.0) {
    FadingWeights found{face_weights(modes, time_step, static_cast<long long>(lags), pool), 0.0};
    const Eigen::RowVectorXd norms = found.weights.values.colwise().norm();
    const Eigen::Index tenth = norms.size() / 10;
    const double last = norms.tail(tenth).sum(), before = norms.segment(norms.size() - 2 * tenth, tenth).sum();
    found.forgotten = last < before ? last / (1.0 - last / before) / norms.sum() : 1.0;
    if (last == 0.0 || found.forgotten <= forgotten) return found;
  }
  throw std::invalid_argument(
      "memory_tolerance: over a bottom that reflects " + std::to_string(modes.water.reflection_coefficient) +
      " the water's memory lasts more than " + std::to_string(static_cast<long long>(most_lags)) +
      " steps; accepted: 0, a larger tolerance or time step, or a reflection of 1");
}

/// In the memory of a few exponentials, to a stated error.
convolution::MadeConvolution brief_convolution(const FaceModes& modes, double time_step, long long steps,
                                               const convolution::ConvolutionOptions& options) {
  const double tolerance = options.reduction.tolerance;
  convolution::MadeConvolution made;
  if (modes.water.reflection_coefficient == 1.0) {
    const convolution::ExponentialSums sums = modal_exponentials(modes, time_step, steps, tolerance, options.pool);
    made.method = convolution::Method::state_space;
    made.error = sums.error;
    made.within_tolerance = sums.within_tolerance;
    made.convolution =
        std::make_unique<convolution::Transformed>(modes.load, std::make_unique<convolution::DiagonalStateSpace>(sums));
    return made;
  }
  const FadingWeights fading = fading_weights(modes, time_step, 0.1 * tolerance, options.pool);
  made = convolution::make_convolution(fading.weights, steps, options);
  made.error.relative += fading.forgotten;
  made.error.absolute += fading.forgotten * fading.weights.values.colwise().norm().sum();
  made.within_tolerance = made.error.relative <= tolerance;
  return made;
}

}  // namespace

convolution::MadeConvolution face_convolution(const FaceModes& modes, double time_step, long long steps,
                                              const convolution::ConvolutionOptions& options) {
  if (options.method == convolution::Method::state_space) return brief_convolution(modes, time_step, steps, options);
  if (modes.water.reflection_coefficient < 1.0)
    return convolution::make_convolution(face_weights(modes, time_step, steps, options.pool), steps, options);
  convolution::MadeConvolution made =
      convolution::make_convolution(modal_weights(modes, time_step, steps), steps, options);
  made.convolution = std::make_unique<convolution::Transformed>(modes.load, std::move(made.convolution));
  return made;
}

}  // namespace sunder::reservoir
