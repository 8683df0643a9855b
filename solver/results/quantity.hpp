#pragma once
/// A result with a name: a number, a text, a list or a table of further quantities. What summary.json holds under
/// `quantities`, and what a verification case asks for by path ("tips[0].K_I").

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::results {

class Quantity {
 public:
  using List = std::vector<Quantity>;
  using Table = std::vector<std::pair<std::string, Quantity>>;  ///< in the order of writing

  Quantity() : value_(Table{}) {}
  Quantity(double value) : value_(value) {}
  Quantity(int value) : value_(static_cast<double>(value)) {}
  Quantity(std::string value) : value_(std::move(value)) {}
  Quantity(const char* value) : value_(std::string(value)) {}
  Quantity(List value) : value_(std::move(value)) {}
  Quantity(Table value) : value_(std::move(value)) {}
  explicit Quantity(const std::vector<double>& values) : value_(List(values.begin(), values.end())) {}

  const double* number() const { return std::get_if<double>(&value_); }
  const std::string* text() const { return std::get_if<std::string>(&value_); }
  const List* list() const { return std::get_if<List>(&value_); }
  const Table* table() const { return std::get_if<Table>(&value_); }

  /// The entry of this name; made, empty, where there is none. Only for a table.
  Quantity& operator[](std::string_view name);

  /// What `path` leads to, e.g. "tips[0].K_I"; nullptr where there is nothing.
  const Quantity* find(std::string_view path) const;

 private:
  std::variant<double, std::string, List, Table> value_;
};

}  // namespace sunder::results
