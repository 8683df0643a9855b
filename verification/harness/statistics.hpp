#pragma once
/// Is the median of these run times settled? Order statistics only: run times are not normally distributed.

#include <span>

namespace sunder::verification {

struct MedianEstimate {
  double median = 0.0;
  double low = 0.0, high = 0.0;  ///< bounds of the interval that holds the true median with at least `confidence`
  double confidence = 0.0;       ///< reached: 1 - 2 P(B < k), B binomial(n, 1/2); below the wanted one for n < 6
};

/// The median of the sample and its distribution-free interval from the order statistics x_(k), x_(n+1-k)
/// [Conover 1999]. At least one value.
[[nodiscard]] MedianEstimate median_interval(std::span<const double> sample, double confidence = 0.95);

/// Half the interval's width over the median; infinite where the confidence is not reached.
[[nodiscard]] double relative_spread(const MedianEstimate& estimate, double confidence = 0.95);

}  // namespace sunder::verification
