#pragma once
/// The results of a run as a short table for people.

#include <string>

#include "solver/results/run_summary.hpp"

namespace sunder::app {

/// One line a quantity, names in a column, numbers with six digits; a list of more than eight numbers by its count and
/// ends. The full digits are in summary.json.
[[nodiscard]] std::string quantity_table(const results::Quantity& quantities);

}  // namespace sunder::app
