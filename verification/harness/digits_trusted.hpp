#pragma once
/// How many decimal digits of each quantity of a run stay where its input moves by one unit in the last place.

#include <random>

#include "solver/results/quantity.hpp"

namespace sunder::verification {

/// The number one step of the floating-point grid down, as it is, or one step up, drawn from the generator's own bits
/// and so the same everywhere. Zero stays: its neighbour is no round-off of it.
[[nodiscard]] double jittered(double value, std::mt19937_64& generator);

/// −log10 of a relative spread, 0 … 15.95: what lies below half the machine's precision cannot be told apart.
[[nodiscard]] double decimal_digits(double relative_spread);

/// Of a plain run and others with jittered input.
class DigitsTrusted {
 public:
  explicit DigitsTrusted(results::Quantity plain) : plain_(std::move(plain)), spread_(zero_spread(plain_)) {}

  /// False where the quantities of `run` are not those of the plain run: names, or lengths of lists.
  [[nodiscard]] bool add(const results::Quantity& run);

  /// Largest |q − q_plain|, in the unit of the quantity, in the shape of the quantities without their texts; a list of
  /// numbers has one, that of its worst entry.
  const results::Quantity& spread() const { return spread_; }

  /// Digits of the spread over |q_plain|, of a list over its largest entry; in the same shape.
  [[nodiscard]] results::Quantity digits() const;

 private:
  static results::Quantity zero_spread(const results::Quantity& plain);
  results::Quantity plain_, spread_;
};

}  // namespace sunder::verification
