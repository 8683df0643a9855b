#pragma once
/// The convolution of some weights by the way that is cheapest, or by the one that is asked for.

#include <memory>

#include "solver/convolution/convolution.hpp"
#include "solver/convolution/state_space.hpp"
#include "solver/convolution/weight_sequence.hpp"

namespace sunder::convolution {

enum class Method {
  automatic,       ///< the cheaper of the exact ones
  direct,          ///< plain sum
  blocked_direct,  ///< plain sum, 32 steps at a time
  block_fft,
  state_space,  ///< to a tolerance; never chosen by itself
};

struct ConvolutionOptions {
  Method method = Method::automatic;
  ReductionOptions reduction = {};       ///< of the state space
  numerics::ThreadPool* pool = nullptr;  ///< of all methods; must live as long as the convolution
};

/// Seconds that a run of `steps` with n = `size` costs, set-up included, as the machine of benchmarks/README measured
/// them: to compare methods, not to promise. `automatic` and `state_space` are refused.
[[nodiscard]] double estimated_seconds(Method method, long long steps, int size, bool diagonal = false);

/// The cheapest of direct, blocked_direct and block_fft.
[[nodiscard]] Method cheapest(long long steps, int size, bool diagonal = false);

struct MadeConvolution {
  std::unique_ptr<Convolution> convolution;
  Method method = Method::automatic;  ///< the one taken
  KernelError error = {};             ///< 0 but for the state space
  bool within_tolerance = true;       ///< the state space missed its tolerance where false; it runs all the same
};

/// For accelerations 0 … `steps`. Throws std::invalid_argument as the method taken.
[[nodiscard]] MadeConvolution make_convolution(WeightSequence weights, long long steps,
                                               const ConvolutionOptions& options = {});

}  // namespace sunder::convolution
