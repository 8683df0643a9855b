// The one place that includes toml++, and against its compiled library: 0.7 s of compilation instead of 4 s
// header-only.
#include "solver/scene/document.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace sunder::scene {
namespace {

Origin origin_of(const toml::source_region& region, int override_index) {
  if (override_index >= 0) return {0, 0, override_index};
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), -1};
}

Node node_of(const toml::node& value, int override_index);

Node::Entries entries_of(const toml::table& table, int override_index) {
  Node::Entries entries;
  for (const auto& [key, value] : table) {
    entries.emplace_back(std::string(key.str()), node_of(value, override_index));
    entries.back().second.key_origin = origin_of(key.source(), override_index);
  }
  // toml++ sorts by name; messages and lists of parts follow the file.
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    const Origin &p = a.second.key_origin, &q = b.second.key_origin;
    return std::pair(p.line, p.column) < std::pair(q.line, q.column);
  });
  return entries;
}

Node node_of(const toml::node& value, int override_index) {
  Node node;
  node.origin = node.key_origin = origin_of(value.source(), override_index);
  switch (value.type()) {
    case toml::node_type::table:
      node.kind = Node::Kind::table;
      node.table = entries_of(*value.as_table(), override_index);
      break;
    case toml::node_type::array:
      node.kind = Node::Kind::list;
      node.list.reserve(value.as_array()->size());
      for (const toml::node& element : *value.as_array()) node.list.push_back(node_of(element, override_index));
      break;
    case toml::node_type::string:
      node.kind = Node::Kind::text;
      node.text = value.as_string()->get();
      break;
    case toml::node_type::integer:
      node.kind = Node::Kind::integer;
      node.integer = value.as_integer()->get();
      node.number = static_cast<double>(node.integer);
      break;
    case toml::node_type::floating_point:
      node.kind = Node::Kind::number;
      node.number = value.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      node.kind = Node::Kind::boolean;
      node.boolean = value.as_boolean()->get();
      break;
    case toml::node_type::none:
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
      node.kind = Node::Kind::date;
      break;
  }
  return node;
}

struct Step {
  std::string key;
  std::optional<std::size_t> index;
};

/// "crack[0].path" -> {crack}, {0}, {path}; nothing where the path is not of that form.
std::vector<Step> steps_of(std::string_view path) {
  std::vector<Step> steps;
  while (!path.empty()) {
    if (path.front() == '[') {
      const std::size_t end = path.find(']');
      std::size_t index = 0;
      if (steps.empty() || end == std::string_view::npos) return {};
      const auto [last, error] = std::from_chars(path.data() + 1, path.data() + end, index);
      if (error != std::errc() || last != path.data() + end) return {};
      steps.push_back({{}, index});
      path.remove_prefix(end + 1);
    } else {
      if (!steps.empty()) {
        if (path.front() != '.') return {};
        path.remove_prefix(1);
      }
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      if (end == 0) return {};
      steps.push_back({std::string(path.substr(0, end)), std::nullopt});
      path.remove_prefix(end);
    }
  }
  return steps;
}

[[noreturn]] void refuse(const Override& given, const std::string& reason) {
  throw SceneError("override " + given.key + " = " + given.value + ": " + reason);
}

/// The node that one step leads to, made where it is missing: a table's entry, or the element one past a list's end.
Node& descend(Node& from, const Step& step, bool list_follows, const Override& given, const Origin& origin) {
  Node made;
  made.kind = list_follows ? Node::Kind::list : Node::Kind::table;
  made.origin = made.key_origin = origin;
  if (step.index) {
    if (from.kind != Node::Kind::list)
      refuse(given,
             "[" + std::to_string(*step.index) + "] asks for an element of " + std::string(kind_name(from.kind)));
    if (*step.index > from.list.size())
      refuse(given, "the list has " + std::to_string(from.list.size()) + " elements, counted from 0");
    if (*step.index == from.list.size()) from.list.push_back(made);
    return from.list[*step.index];
  }
  if (from.kind != Node::Kind::table)
    refuse(given, "`" + step.key + "` asks for a key of " + std::string(kind_name(from.kind)));
  for (auto& [key, value] : from.table)
    if (key == step.key) return value;
  return from.table.emplace_back(step.key, made).second;
}

}  // namespace

Node::Node() = default;

const Node* Node::find(std::string_view key) const {
  for (const auto& [name, value] : table)
    if (name == key) return &value;
  return nullptr;
}

Node parse_document(std::string_view text, const std::string& name) {
  try {
    const toml::table parsed = toml::parse(text, std::string_view(name));
    Node document;
    document.table = entries_of(parsed, -1);
    document.origin = {1, 1, -1};
    return document;
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw SceneError(name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                     ": not TOML: " + std::string(error.description()));
  }
}

void apply_overrides(Node& document, std::span<const Override> overrides) {
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const Override& given = overrides[i];
    const Origin origin{0, 0, static_cast<int>(i)};
    const std::vector<Step> steps = steps_of(given.key);
    if (steps.empty()) refuse(given, "the key is not of the form table.key or list[0].key");
    Node value;
    try {
      const toml::table parsed = toml::parse("value = " + given.value + "\n");
      // A value such as "3\nother = 4" would smuggle in further keys.
      if (parsed.size() != 1) refuse(given, "more than one value");
      value = node_of(*parsed.get("value"), origin.override_index);
    } catch (const toml::parse_error& error) {
      refuse(given, "the value is not TOML (a text needs quotes): " + std::string(error.description()));
    }
    Node* target = &document;
    for (std::size_t k = 0; k < steps.size(); ++k)
      target = &descend(*target, steps[k], k + 1 < steps.size() && steps[k + 1].index.has_value(), given, origin);
    value.origin = value.key_origin = origin;
    *target = std::move(value);
  }
}

std::string shown(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  return std::string(digits, error == std::errc() ? end : digits);
}

std::string shown(const Node& node) {
  constexpr std::size_t longest = 60;
  const auto shortened = [](std::string text) {
    if (text.size() <= longest) return text;
    std::size_t cut = longest - 3;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;  // not inside a UTF-8 character
    return text.substr(0, cut) + "...";
  };
  switch (node.kind) {
    case Node::Kind::text:
      return shortened("\"" + node.text + "\"");
    case Node::Kind::integer:
      return std::to_string(node.integer);
    case Node::Kind::number:
      return shown(node.number);
    case Node::Kind::boolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::date:
      return "a date or time";
    case Node::Kind::list: {
      std::string text = "[";
      for (std::size_t i = 0; i < node.list.size() && text.size() <= longest; ++i)
        text += (i > 0 ? ", " : "") + shown(node.list[i]);
      return shortened(text + "]");
    }
    case Node::Kind::table:
      return "a table";
  }
  return {};
}

std::string_view kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::table:
      return "a table";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::text:
      return "a text";
    case Node::Kind::integer:
      return "a whole number";
    case Node::Kind::number:
      return "a number";
    case Node::Kind::boolean:
      return "true or false";
    case Node::Kind::date:
      return "a date or time";
  }
  return {};
}

}  // namespace sunder::scene
