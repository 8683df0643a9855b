#include "solver/results/quantity.hpp"

#include <charconv>
#include <stdexcept>

namespace sunder::results {

Quantity& Quantity::operator[](std::string_view name) {
  Table* entries = std::get_if<Table>(&value_);
  if (entries == nullptr)
    throw std::invalid_argument("quantity: \"" + std::string(name) + "\" asked of what is no table");
  for (auto& [key, value] : *entries)
    if (key == name) return value;
  return entries->emplace_back(std::string(name), Quantity()).second;
}

const Quantity* Quantity::find(std::string_view path) const {
  const Quantity* at = this;
  bool first = true;
  while (!path.empty() && at != nullptr) {
    if (path.front() == '[') {
      const std::size_t end = path.find(']');
      const List* entries = at->list();
      std::size_t index = 0;
      if (end == std::string_view::npos || entries == nullptr) return nullptr;
      const auto [last, error] = std::from_chars(path.data() + 1, path.data() + end, index);
      if (error != std::errc() || last != path.data() + end || index >= entries->size()) return nullptr;
      at = &(*entries)[index];
      path.remove_prefix(end + 1);
    } else {
      if (!first) {
        if (path.front() != '.') return nullptr;
        path.remove_prefix(1);
      }
      const std::string_view name = path.substr(0, path.find_first_of(".["));
      const Table* entries = at->table();
      at = nullptr;
      if (entries != nullptr)
        for (const auto& [key, value] : *entries)
          if (key == name) at = &value;
      path.remove_prefix(name.size());
    }
    first = false;
  }
  return at;
}

}  // namespace sunder::results
