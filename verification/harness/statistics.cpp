#include "verification/harness/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace sunder::verification {

MedianEstimate median_interval(std::span<const double> sample, double confidence) {
  if (sample.empty()) throw std::invalid_argument("median_interval: the sample is empty");
  std::vector<double> x(sample.begin(), sample.end());
  std::sort(x.begin(), x.end());
  const std::size_t n = x.size();
  MedianEstimate estimate;
  estimate.median = n % 2 == 1 ? x[n / 2] : 0.5 * (x[n / 2 - 1] + x[n / 2]);
  // Narrow from the widest interval x_(1) … x_(n) while P(B <= k - 1) keeps 1 - 2P at or above the confidence.
  double term = std::pow(0.5, static_cast<double>(n));  // P(B = 0); n stays far below 1000 here
  double below = term;
  std::size_t k = 0;  // zero-based index of the lower bound
  estimate.confidence = 1.0 - 2.0 * below;
  while (2 * (k + 1) < n) {
    term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    if (1.0 - 2.0 * (below + term) < confidence) break;
    below += term;
    ++k;
    estimate.confidence = 1.0 - 2.0 * below;
  }
  estimate.low = x[k];
  estimate.high = x[n - 1 - k];
  return estimate;
}

double relative_spread(const MedianEstimate& estimate, double confidence) {
  if (estimate.confidence < confidence || !(estimate.median > 0.0)) return std::numeric_limits<double>::infinity();
  return 0.5 * (estimate.high - estimate.low) / estimate.median;
}

}  // namespace sunder::verification
