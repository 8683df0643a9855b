#pragma once
/// Columns of numbers from the project's reference data: comma-separated, a header row, lines that begin with #
/// skipped.

#include <filesystem>
#include <string>
#include <vector>

namespace sunder::verification {

struct Csv {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< one a name, all of the same length; an empty field is not a number

  /// nullptr where there is no such column.
  const std::vector<double>* column(const std::string& name) const;
};

/// Throws std::runtime_error with file, line and what is wrong.
[[nodiscard]] Csv read_csv(const std::filesystem::path& file);

}  // namespace sunder::verification
