#pragma once
/// The observed order of accuracy of a sweep, how trustworthy it is, and what the answer at h = 0 would be.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::verification {

struct Level {
  double h;      ///< size of the mesh or of the step, > 0
  double value;  ///< the quantity there
};

enum class Convergence {
  monotone,     ///< the differences keep their sign and shrink
  oscillatory,  ///< they shrink and change their sign
  divergent,    ///< they grow
  at_floor,     ///< too few levels stand above round-off to speak of an order
};
std::string_view word(Convergence convergence);

struct OrderOptions {
  std::optional<double> exact = {};  ///< the answer; absent: the order of the differences between levels
  double floor = 0.0;                ///< errors |value - exact|, or differences, up to this are round-off
  double safety = 1.25;              ///< F_s of the grid convergence index, for three levels or more [Roache 1994]
};

struct OrderEstimate {
  Convergence convergence = Convergence::at_floor;
  double order = 0.0;              ///< p: of the finest levels above the floor where monotone; least squares else
  std::vector<double> pairwise;    ///< between neighbouring levels (or triplets, without an exact answer), coarse first
  double extrapolated = 0.0;       ///< Richardson's value at h = 0 from the finest levels above the floor
  double convergence_index = 0.0;  ///< GCI of the finest of them: F_s |ε| / (r^p - 1), relative to the value there
  int levels_used = 0;             ///< that stand above the floor
};

/// Levels in any order of h; at least three, all h different; std::invalid_argument otherwise.
[[nodiscard]] OrderEstimate observed_order(std::span<const Level> levels, const OrderOptions& options = {});

/// Observed order p of one triplet h_1 < h_2 < h_3 with any refinement ratios: the root of
///     ε_32 / ε_21 = (h_3^p - s h_2^p) / (h_2^p - s h_1^p),   ε_ij = f_i - f_j,   s = sign(ε_32 / ε_21),
/// which is [Celik 2008] without the absolute value, so that a diverging triplet has p < 0; found by
/// bisection in -20 … 40. Not a number where two neighbouring values agree.
[[nodiscard]] double triplet_order(const Level& fine, const Level& middle, const Level& coarse);

}  // namespace sunder::verification
