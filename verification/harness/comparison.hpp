#pragma once
/// How far an answer is from its reference, in the norm that the case names.

#include <optional>
#include <span>

#include "verification/harness/case.hpp"

namespace sunder::verification {

/// A list of numbers, with the abscissa of each where it is a curve.
struct Series {
  std::span<const double> values;
  std::span<const double> abscissae;  ///< empty, or as many, increasing
};

struct Comparison {
  double error = 0.0;      ///< in the measure of the norm; not a number where an operand is none
  double value = 0.0;      ///< at the worst place
  double reference = 0.0;  ///< there
  int compared = 0;        ///< numbers that were compared
};

struct ComparisonOptions {
  Norm norm = Norm::relative;
  std::optional<double> scale = {};      ///< relative: instead of |reference|
  std::optional<double> threshold = {};  ///< event_time
};

/// One reference goes with any number of values. A curve is interpolated linearly at the abscissae of its reference.
/// Throws std::invalid_argument where the two do not go together: different lengths, a reference of zero without a
/// scale, a curve that does not cover its reference, a threshold that is never reached.
[[nodiscard]] Comparison compare(const Series& answer, const Series& reference, const ComparisonOptions& options);

/// Largest distance from a point of one polyline to the other line [m]; points one after the other (x0, y0, x1, y1, …).
/// Segments are sampled at 1/32 of their length.
[[nodiscard]] double hausdorff_distance(std::span<const double> a, std::span<const double> b);

}  // namespace sunder::verification
