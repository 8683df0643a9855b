#include "solver/app/quantity_table.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace sunder::app {
namespace {

using results::Quantity;
using Lines = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t longest_list = 8;

std::string text_of(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value);
  return digits;
}

bool flat(const Quantity::List& list) {
  return std::all_of(list.begin(), list.end(), [](const Quantity& value) { return value.number() != nullptr; });
}

std::string text_of(const Quantity::List& numbers) {
  if (numbers.size() > longest_list)
    return std::to_string(numbers.size()) + " values, " + text_of(*numbers.front().number()) + " … " +
           text_of(*numbers.back().number());
  std::string text;
  for (const Quantity& value : numbers) text += (text.empty() ? "" : ", ") + text_of(*value.number());
  return "[" + text + "]";
}

void collect(const Quantity& quantity, const std::string& name, Lines& lines) {
  if (const double* number = quantity.number()) {
    lines.emplace_back(name, text_of(*number));
  } else if (const std::string* text = quantity.text()) {
    lines.emplace_back(name, *text);
  } else if (const Quantity::List* list = quantity.list()) {
    if (flat(*list)) return lines.emplace_back(name, text_of(*list)), void();
    for (std::size_t i = 0; i < list->size(); ++i) collect((*list)[i], name + "[" + std::to_string(i) + "]", lines);
  } else {
    for (const auto& [key, value] : *quantity.table()) collect(value, name.empty() ? key : name + "." + key, lines);
  }
}

}  // namespace

std::string quantity_table(const Quantity& quantities) {
  Lines lines;
  collect(quantities, "", lines);
  std::size_t width = 0;
  for (const auto& [name, value] : lines) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, value] : lines)
    text += "  " + name + std::string(width - name.size() + 2, ' ') + value + "\n";
  return text;
}

}  // namespace sunder::app
