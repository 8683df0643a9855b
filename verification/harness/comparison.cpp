#include "verification/harness/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace sunder::verification {
namespace {

constexpr int samples_per_segment = 32;

double distance_to_segment(double x, double y, const double* a, const double* b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0.0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

double distance_to_line(double x, double y, std::span<const double> line) {
  if (line.size() == 2) return std::hypot(x - line[0], y - line[1]);
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 3 < line.size(); i += 2)
    distance = std::min(distance, distance_to_segment(x, y, &line[i], &line[i + 2]));
  return distance;
}

double directed_distance(std::span<const double> from, std::span<const double> to) {
  double distance = distance_to_line(from[0], from[1], to);
  for (std::size_t i = 0; i + 3 < from.size(); i += 2)
    for (int k = 1; k <= samples_per_segment; ++k) {
      const double t = static_cast<double>(k) / samples_per_segment;
      distance = std::max(distance, distance_to_line(from[i] + t * (from[i + 2] - from[i]),
                                                     from[i + 1] + t * (from[i + 3] - from[i + 1]), to));
    }
  return distance;
}

/// The curve at the abscissae of the reference.
std::vector<double> at_abscissae(const Series& curve, std::span<const double> abscissae) {
  if (curve.abscissae.size() != curve.values.size())
    throw std::invalid_argument("the curve has " + std::to_string(curve.values.size()) + " values and " +
                                std::to_string(curve.abscissae.size()) + " abscissae");
  std::vector<double> result;
  for (const double x : abscissae) {
    const auto after = std::lower_bound(curve.abscissae.begin(), curve.abscissae.end(), x);
    if (after == curve.abscissae.end() || (after == curve.abscissae.begin() && *after != x))
      throw std::invalid_argument("the curve does not cover the reference at " + std::to_string(x));
    const auto i = static_cast<std::size_t>(after - curve.abscissae.begin());
    if (curve.abscissae[i] == x) {
      result.push_back(curve.values[i]);
    } else {
      const double t = (x - curve.abscissae[i - 1]) / (curve.abscissae[i] - curve.abscissae[i - 1]);
      result.push_back(curve.values[i - 1] + t * (curve.values[i] - curve.values[i - 1]));
    }
  }
  return result;
}

double integral(const Series& curve, bool of_magnitude) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.values.size(); ++i) {
    const double a = of_magnitude ? std::abs(curve.values[i - 1]) : curve.values[i - 1];
    const double b = of_magnitude ? std::abs(curve.values[i]) : curve.values[i];
    sum += 0.5 * (a + b) * (curve.abscissae[i] - curve.abscissae[i - 1]);
  }
  return sum;
}

/// The first abscissa at which the curve reaches the threshold, from whichever side it starts.
double first_crossing(const Series& curve, double threshold) {
  for (std::size_t i = 1; i < curve.values.size(); ++i) {
    const double before = curve.values[i - 1] - threshold, after = curve.values[i] - threshold;
    if (before == 0.0) return curve.abscissae[i - 1];
    if (before * after <= 0.0)
      return curve.abscissae[i - 1] + before / (before - after) * (curve.abscissae[i] - curve.abscissae[i - 1]);
  }
  throw std::invalid_argument("the curve never reaches " + std::to_string(threshold));
}

void need_curve(const Series& series, const char* whose) {
  if (series.values.size() < 2 || series.abscissae.size() != series.values.size())
    throw std::invalid_argument(std::string(whose) + " is no curve: " + std::to_string(series.values.size()) +
                                " values, " + std::to_string(series.abscissae.size()) + " abscissae");
}

Comparison number_by_number(std::span<const double> values, std::span<const double> reference,
                            const ComparisonOptions& options) {
  Comparison worst;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double r = reference[reference.size() == 1 ? 0 : i];
    double error = std::abs(values[i] - r);
    if (options.norm == Norm::relative) {
      const double scale = options.scale.value_or(std::abs(r));
      if (scale == 0.0) throw std::invalid_argument("a relative error of a reference of zero needs a scale");
      error /= scale;
    }
    if (i == 0 || !(error <= worst.error)) {  // not a number counts as worst
      worst.error = error;
      worst.value = values[i];
      worst.reference = r;
      if (std::isnan(error)) break;
    }
  }
  worst.compared = static_cast<int>(values.size());
  return worst;
}

Comparison over_all(std::span<const double> values, std::span<const double> reference, Norm norm) {
  Comparison result;
  double sum2 = 0.0, sum2_reference = 0.0, largest = 0.0, largest_reference = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double r = reference[reference.size() == 1 ? 0 : i];
    const double difference = std::abs(values[i] - r);
    sum2 += difference * difference;
    sum2_reference += r * r;
    largest_reference = std::max(largest_reference, std::abs(r));
    if (i == 0 || !(difference <= largest)) {
      largest = difference;
      result.value = values[i];
      result.reference = r;
      if (std::isnan(difference)) break;
    }
  }
  result.compared = static_cast<int>(values.size());
  const double scale = norm == Norm::l2 ? std::sqrt(sum2_reference) : largest_reference;
  if (scale == 0.0 && result.compared > 0) throw std::invalid_argument("the reference is zero throughout");
  result.error = result.compared == 0 ? 0.0 : (norm == Norm::l2 ? std::sqrt(sum2) : largest) / scale;
  return result;
}

}  // namespace

double hausdorff_distance(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2 || a.size() % 2 != 0 || b.size() % 2 != 0)
    throw std::invalid_argument("a path needs at least one point, two numbers each");
  return std::max(directed_distance(a, b), directed_distance(b, a));
}

Comparison compare(const Series& answer, const Series& reference, const ComparisonOptions& options) {
  if (reference.values.empty()) throw std::invalid_argument("the reference is empty");
  if (answer.values.empty()) return {};
  std::vector<double> interpolated;
  std::span<const double> values = answer.values;
  switch (options.norm) {
    case Norm::path_distance: {
      const double distance = hausdorff_distance(answer.values, reference.values);
      return {distance, distance, 0.0, static_cast<int>(answer.values.size() / 2)};
    }
    case Norm::area: {
      need_curve(answer, "the answer");
      need_curve(reference, "the reference");
      const double ours = integral(answer, false), theirs = integral(reference, false);
      return {std::abs(ours - theirs) / integral(reference, true), ours, theirs,
              static_cast<int>(answer.values.size())};
    }
    case Norm::event_time: {
      need_curve(answer, "the answer");
      const double ours = first_crossing(answer, options.threshold.value_or(0.0));
      const double theirs = reference.abscissae.empty() ? reference.values[0]
                                                        : first_crossing(reference, options.threshold.value_or(0.0));
      return {std::abs(ours - theirs), ours, theirs, 1};
    }
    case Norm::relative:
    case Norm::absolute:
    case Norm::l2:
    case Norm::maximum:
      break;
  }
  if (!reference.abscissae.empty()) {
    interpolated = at_abscissae(answer, reference.abscissae);
    values = interpolated;
  }
  if (reference.values.size() != 1 && reference.values.size() != values.size())
    throw std::invalid_argument(std::to_string(values.size()) + " values stand against " +
                                std::to_string(reference.values.size()) + " of the reference");
  return options.norm == Norm::relative || options.norm == Norm::absolute
             ? number_by_number(values, reference.values, options)
             : over_all(values, reference.values, options.norm);
}

}  // namespace sunder::verification
