#pragma once
/// summary.json: everything a run leaves behind besides its history, as text.

#include <string>
#include <vector>

#include "solver/results/run_summary.hpp"

namespace sunder::results {

/// Paths of the numbers that are NaN or infinite, e.g. "tips[0].K_I".
[[nodiscard]] std::vector<std::string> not_finite(const Quantity& quantity);

/// Turns a summary with numbers that are NaN or infinite, in its quantities or its history, into a stopped one: the
/// status says so, a warning names each. The numbers stay as they are.
void stop_if_not_finite(RunSummary& summary);

/// The summary as JSON. Every double is written with as many digits as reading it back exactly needs. NaN and infinity
/// become null, and the text's status and warnings are those of `stop_if_not_finite`.
[[nodiscard]] std::string to_json(const RunSummary& summary);

}  // namespace sunder::results
