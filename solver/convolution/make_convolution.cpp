#include "solver/convolution/make_convolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/direct_sum.hpp"

namespace sunder::convolution {
namespace {

constexpr int block = 32;

}  // namespace

double estimated_seconds(Method method, long long steps, int size, bool diagonal) {
  const double N = static_cast<double>(std::max<long long>(steps, 1)), n = size;
  const double per_lag = diagonal ? n : n * n;
  const double pairs = 0.5 * N * N * per_lag;
  const double in_cache = 8.0 * N * per_lag < 1e6 ? 0.5 : 1.0;  // weights that fit in the cache are read twice as fast
  switch (method) {
    case Method::direct:
      return pairs * 1.6e-9 * in_cache + N * 1e-7;
    case Method::blocked_direct:
      return diagonal ? pairs * 1.6e-9 : pairs * 1.2e-10 + N * block * per_lag * 3e-10 + N * 3e-7;
    case Method::block_fft: {
      const double levels = std::max(std::log2(N / block), 0.0), entries = diagonal ? n : 0.5 * n * (n + 1.0);
      const double set_up = entries * N * (levels + 5.0) * 1.2e-8;
      return set_up + N * levels * (entries * 2e-9 + n * 6e-8) + N * block * per_lag * 2e-10 + N * 3e-7;
    }
    case Method::automatic:
    case Method::state_space:
      break;
  }
  throw std::invalid_argument("estimated_seconds: method must be direct, blocked_direct or block_fft");
}

Method cheapest(long long steps, int size, bool diagonal) {
  constexpr std::array exact{Method::direct, Method::blocked_direct, Method::block_fft};
  return *std::min_element(exact.begin(), exact.end(), [&](Method a, Method b) {
    return estimated_seconds(a, steps, size, diagonal) < estimated_seconds(b, steps, size, diagonal);
  });
}

MadeConvolution make_convolution(WeightSequence weights, long long steps, const ConvolutionOptions& options) {
  MadeConvolution made;
  made.method = options.method == Method::automatic
                    ? cheapest(std::min(steps, weights.last()), weights.size, weights.diagonal)
                    : options.method;
  switch (made.method) {
    case Method::automatic:
    case Method::direct:
      made.convolution = std::make_unique<DirectSum>(std::move(weights), steps);
      break;
    case Method::blocked_direct:
      made.convolution =
          std::make_unique<DirectSum>(std::move(weights), steps, DirectOptions{.block = block, .pool = options.pool});
      break;
    case Method::block_fft:
      made.convolution =
          std::make_unique<BlockFft>(weights, steps, BlockFftOptions{.block = block, .pool = options.pool});
      break;
    case Method::state_space: {
      ReductionOptions reduction = options.reduction;
      reduction.pool = options.pool;
      const StateSpaceModel model = reduce(weights, reduction);
      made.error = model.error;
      made.within_tolerance = model.within_tolerance;
      made.convolution = std::make_unique<StateSpace>(model);
      break;
    }
  }
  return made;
}

}  // namespace sunder::convolution
