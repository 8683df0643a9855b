#include "solver/results/history.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace sunder::results {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (char letter : text) out += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return out + "\"";
}

}  // namespace

void History::add_row(std::span<const double> values) {
  if (values.size() != columns_.size())
    throw std::invalid_argument("history: " + std::to_string(values.size()) + " values for " +
                                std::to_string(columns_.size()) + " columns");
  values_.insert(values_.end(), values.begin(), values.end());
}

std::string to_csv(const History& history) {
  std::string text;
  for (const Column& column : history.columns())
    text += (text.empty() ? "" : ",") + quoted(column.name + " [" + column.unit + "]");
  text += '\n';
  for (std::size_t row = 0; row < history.rows(); ++row) {
    for (std::size_t column = 0; column < history.columns().size(); ++column) {
      if (column > 0) text += ',';
      const double value = history.at(row, column);
      if (!std::isfinite(value)) continue;
      char digits[32];
      text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    }
    text += '\n';
  }
  return text;
}

std::vector<std::string> not_finite(const History& history) {
  std::vector<std::string> found;
  for (std::size_t column = 0; column < history.columns().size(); ++column)
    for (std::size_t row = 0; row < history.rows(); ++row)
      if (!std::isfinite(history.at(row, column))) {
        found.push_back(history.columns()[column].name + " (row " + std::to_string(row + 1) + ")");
        break;
      }
  return found;
}

}  // namespace sunder::results
