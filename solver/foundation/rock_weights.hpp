#pragma once
/// The weights with which the accelerations of a line act on the unbounded rock, step by step (convolution.hpp).
///
/// Trapezoidal convolution quadrature of M(s) = S(s)/s² (contour_weights.hpp): all points of its contour lie on one
/// path of falling |s| and Re s, so that one integration of the stiffness serves all steps. Work: a few thousand
/// products of (n, n) matrices, hardly growing with the number of steps. M(t) grows for ever, because rock resists
/// displacement also at rest; nothing is cut off.

#include "solver/convolution/weight_sequence.hpp"
#include "solver/foundation/dynamic_stiffness.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::foundation {

struct RockWeightOptions {
  StiffnessOptions stiffness = {};
  int oversampling = 2;                  ///< of the contour, as convolution::ContourOptions
  numerics::ThreadPool* pool = nullptr;  ///< of the transforms; the bits are the same for any number of threads
};

struct RockWeights {
  convolution::WeightSequence weights;  ///< W_0 … W_last (n, n) [kg/m]; empty unless converged
  StiffnessPath path;
};

/// For steps of `time_step` [s] > 0 and accelerations 0 … last. Memory: about 16 n² (last + 1) bytes beside the
/// weights, twice. Throws std::invalid_argument as contour_weights().
[[nodiscard]] RockWeights rock_weights(const UnboundedDomain& domain, double time_step, long long last,
                                       const RockWeightOptions& options = {});

}  // namespace sunder::foundation
