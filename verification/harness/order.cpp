#include "verification/harness/order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sunder::verification {
namespace {

constexpr double least_order = -20.0, greatest_order = 40.0;

std::vector<Level> coarse_first(std::span<const Level> levels) {
  if (levels.size() < 3) throw std::invalid_argument("observed_order: at least three levels are needed");
  std::vector<Level> sorted(levels.begin(), levels.end());
  std::sort(sorted.begin(), sorted.end(), [](const Level& a, const Level& b) { return a.h > b.h; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!(sorted[i].h > 0.0) || !std::isfinite(sorted[i].value))
      throw std::invalid_argument("observed_order: every level needs h > 0 and a finite value");
    if (i > 0 && sorted[i].h == sorted[i - 1].h)
      throw std::invalid_argument("observed_order: two levels have the same h");
  }
  return sorted;
}

/// Slope of ln|e| over ln h.
double least_squares_order(const std::vector<Level>& errors) {
  double x_mean = 0.0, y_mean = 0.0;
  for (const Level& e : errors) {
    x_mean += std::log(e.h);
    y_mean += std::log(std::abs(e.value));
  }
  x_mean /= static_cast<double>(errors.size());
  y_mean /= static_cast<double>(errors.size());
  double xy = 0.0, xx = 0.0;
  for (const Level& e : errors) {
    const double x = std::log(e.h) - x_mean;
    xy += x * (std::log(std::abs(e.value)) - y_mean);
    xx += x * x;
  }
  return xy / xx;
}

bool changes_sign(const std::vector<double>& values) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if ((values[i] > 0.0) != (values[i - 1] > 0.0)) return true;
  return false;
}

void extrapolate(const Level& fine, const Level& coarse, double safety, OrderEstimate& estimate) {
  const double gain = std::pow(coarse.h / fine.h, estimate.order) - 1.0;  // r^p - 1
  estimate.extrapolated = fine.value;
  if (!(gain > 0.0)) return;  // p <= 0: nothing to extrapolate to
  estimate.extrapolated += (fine.value - coarse.value) / gain;
  if (fine.value != 0.0)
    estimate.convergence_index = safety * std::abs((fine.value - coarse.value) / fine.value) / gain;
}

OrderEstimate order_of_errors(const std::vector<Level>& levels, double exact, const OrderOptions& options) {
  OrderEstimate estimate;
  std::vector<Level> errors;  // above the floor, coarse first
  for (const Level& level : levels) {
    if (!(std::abs(level.value - exact) > options.floor)) break;
    errors.push_back({level.h, level.value - exact});
  }
  estimate.levels_used = static_cast<int>(errors.size());
  estimate.extrapolated = levels.back().value;
  if (errors.size() < 2) return estimate;
  std::vector<double> signed_errors;
  for (const Level& e : errors) signed_errors.push_back(e.value);
  for (std::size_t i = 1; i < errors.size(); ++i)
    estimate.pairwise.push_back(std::log(std::abs(errors[i - 1].value / errors[i].value)) /
                                std::log(errors[i - 1].h / errors[i].h));
  const bool oscillates = changes_sign(signed_errors);
  estimate.order = oscillates ? least_squares_order(errors) : estimate.pairwise.back();
  estimate.convergence = !(estimate.order > 0.0) ? Convergence::divergent
                         : oscillates            ? Convergence::oscillatory
                                                 : Convergence::monotone;
  extrapolate(levels[errors.size() - 1], levels[errors.size() - 2], options.safety, estimate);
  return estimate;
}

OrderEstimate order_of_differences(const std::vector<Level>& levels, const OrderOptions& options) {
  OrderEstimate estimate;
  std::vector<double> differences;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double difference = levels[i - 1].value - levels[i].value;
    if (!(std::abs(difference) > options.floor)) break;
    differences.push_back(difference);
  }
  estimate.levels_used = differences.empty() ? 0 : static_cast<int>(differences.size()) + 1;
  estimate.extrapolated = levels.back().value;
  if (differences.size() < 2) return estimate;
  for (std::size_t i = 2; i <= differences.size(); ++i)
    estimate.pairwise.push_back(triplet_order(levels[i], levels[i - 1], levels[i - 2]));
  estimate.order = estimate.pairwise.back();
  estimate.convergence = !(estimate.order > 0.0)     ? Convergence::divergent
                         : changes_sign(differences) ? Convergence::oscillatory
                                                     : Convergence::monotone;
  extrapolate(levels[differences.size()], levels[differences.size() - 1], options.safety, estimate);
  return estimate;
}

}  // namespace

std::string_view word(Convergence convergence) {
  switch (convergence) {
    case Convergence::monotone:
      return "monotone";
    case Convergence::oscillatory:
      return "oscillatory";
    case Convergence::divergent:
      return "divergent";
    case Convergence::at_floor:
      return "at round-off floor";
  }
  return "";
}

double triplet_order(const Level& fine, const Level& middle, const Level& coarse) {
  const double ratio = (coarse.value - middle.value) / (middle.value - fine.value);
  if (!std::isfinite(ratio) || ratio == 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double log_r21 = std::log(middle.h / fine.h), log_r32 = std::log(coarse.h / middle.h);
  // Both forms grow with p. expm1 keeps the monotone one exact through p = 0, where it tends to ln r_32 / ln r_21.
  const auto predicted = [&](double p) {
    if (ratio > 0.0) return p == 0.0 ? log_r32 / log_r21 : std::expm1(p * log_r32) / -std::expm1(-p * log_r21);
    return (std::exp(p * log_r32) + 1.0) / (1.0 + std::exp(-p * log_r21));
  };
  double low = least_order, high = greatest_order;
  for (int i = 0; i < 200 && high - low > 1e-14 * greatest_order; ++i) {
    const double p = 0.5 * (low + high);
    (predicted(p) < std::abs(ratio) ? low : high) = p;
  }
  return 0.5 * (low + high);
}

OrderEstimate observed_order(std::span<const Level> levels, const OrderOptions& options) {
  const std::vector<Level> sorted = coarse_first(levels);
  return options.exact ? order_of_errors(sorted, *options.exact, options) : order_of_differences(sorted, options);
}

}  // namespace sunder::verification
