#pragma once
/// The small formulas of case files: "tips[0].K_I / (1e6 * sqrt(pi * 0.5))".
///
/// Numbers, + - * / ^ and brackets, `pi`, functions of numbers (sqrt abs sin cos tan atan atan2 exp log log10 hypot min
/// max and the exact answers of verification/exact), reductions of lists (largest smallest sum mean rms span count),
/// and names such as tips[*].K_I that the caller looks up. Everything is a list of numbers; one number goes with any
/// list.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/results/quantity.hpp"

namespace sunder::verification {

using Values = std::vector<double>;
using Lookup = std::function<Values(std::string_view name)>;  ///< throws std::invalid_argument for an unknown name

/// Throws std::invalid_argument with the place in the text where it cannot be read, or for lists of unequal length.
[[nodiscard]] Values evaluate(std::string_view expression, const Lookup& lookup);

/// Every number below `path` of the quantities, lists in order: "tips[0].K_I", "tips[*].K_I", "frequencies".
/// Throws std::invalid_argument naming the first part of the path that leads nowhere and what there is instead.
[[nodiscard]] Values select(const results::Quantity& quantities, std::string_view path);

}  // namespace sunder::verification
