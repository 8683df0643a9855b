#pragma once
/// history.csv: one header row with the name and unit of every column, then one row of numbers an instant.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sunder::results {

struct Column {
  std::string name;  ///< a field's standard word: "time", "crest_displacement"
  std::string unit;  ///< "s", "m", "kN/m"; "-" where it has none
};

class History {
 public:
  explicit History(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Room for so many rows, so that a step loop that adds them does not allocate.
  void reserve(std::size_t rows) { values_.reserve(rows * columns_.size()); }

  /// Throws std::invalid_argument where there is not one value a column.
  void add_row(std::span<const double> values);

  const std::vector<Column>& columns() const { return columns_; }
  std::size_t rows() const { return columns_.empty() ? 0 : values_.size() / columns_.size(); }
  double at(std::size_t row, std::size_t column) const { return values_[row * columns_.size() + column]; }

 private:
  std::vector<Column> columns_;
  std::vector<double> values_;  ///< row by row
};

/// "time [s],crest_displacement [m]\n0,0\n…": every double with the fewest digits that read back exactly. A number that
/// is not finite is an empty cell. A name with a comma or a quote is quoted.
[[nodiscard]] std::string to_csv(const History& history);

/// "crest_displacement (row 12)" for the first number of each column that is NaN or infinite.
[[nodiscard]] std::vector<std::string> not_finite(const History& history);

}  // namespace sunder::results
