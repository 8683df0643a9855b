#pragma once
/// The faults that the solver's sources plant, read from the sources themselves: none may be left without a case.

#include <filesystem>
#include <string>
#include <vector>

namespace sunder::verification {

/// The names in `planted_fault("…")` below the folder, each once, sorted.
[[nodiscard]] std::vector<std::string> fault_names(const std::filesystem::path& folder);

}  // namespace sunder::verification
