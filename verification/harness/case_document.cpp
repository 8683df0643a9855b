/// The only code of the harness that knows TOML.
#include "verification/harness/case_document.hpp"

#include <algorithm>
#include <sstream>

#include <toml++/toml.h>

#include "verification/harness/case.hpp"

namespace sunder::verification {
namespace {

Node converted(const toml::node& node) {
  Node result;
  result.line = static_cast<int>(node.source().begin.line);
  if (const toml::table* table = node.as_table()) {
    std::vector<std::pair<toml::source_position, std::pair<std::string, Node>>> entries;
    for (const auto& [key, value] : *table)
      entries.push_back({key.source().begin, {std::string(key.str()), converted(value)}});
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [position, entry] : entries) result.table.push_back(std::move(entry));
    return result;
  }
  std::ostringstream notation;
  node.visit([&](const auto& value) { notation << value; });
  result.notation = notation.str();
  if (const toml::array* list = node.as_array()) {
    result.kind = Node::Kind::list;
    for (const toml::node& entry : *list) result.list.push_back(converted(entry));
  } else if (node.is_string()) {
    result.kind = Node::Kind::text;
    result.text = *node.value<std::string>();
    result.notation = "\"" + result.text + "\"";
  } else if (node.is_boolean()) {
    result.kind = Node::Kind::boolean;
    result.boolean = *node.value<bool>();
  } else if (node.is_number()) {
    result.kind = node.is_integer() ? Node::Kind::integer : Node::Kind::number;
    result.number = *node.value<double>();
    if (node.is_integer()) result.integer = *node.value<long long>();
  } else {
    result.kind = Node::Kind::date;
  }
  return result;
}

}  // namespace

Node::Node() = default;

const Node* Node::find(std::string_view key) const {
  for (const auto& [name, value] : table)
    if (name == key) return &value;
  return nullptr;
}

Node parse_case(const std::filesystem::path& file, const std::string& shown) {
  try {
    return converted(toml::parse_file(file.string()));
  } catch (const toml::parse_error& error) {
    throw CaseError(shown + ":" + std::to_string(error.source().begin.line) +
                    ": TOML: " + std::string(error.description()));
  }
}

}  // namespace sunder::verification
