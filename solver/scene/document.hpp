#pragma once
/// A scene's text as a tree of values that know where they stand. Private to this module.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/scene/reader.hpp"

namespace sunder::scene {

/// Where a value comes from: a place in the file, or an override.
struct Origin {
  int line = 0, column = 0;  ///< counted from 1; 0 where it comes from an override
  int override_index = -1;   ///< index into the overrides; -1: from the file
};

struct Node {
  enum class Kind { table, list, text, integer, number, boolean, date };
  using Entries = std::vector<std::pair<std::string, Node>>;

  Kind kind = Kind::table;
  Origin origin;      ///< of the value; of a table: its heading
  Origin key_origin;  ///< of the key before it; a list's elements repeat `origin`
  std::string text;
  double number = 0.0;  ///< also of an integer
  long long integer = 0;
  bool boolean = false;
  std::vector<Node> list;
  Entries table;  ///< in the order of the file

  Node();  // elsewhere: to say here that it is implicit asks for a whole Node inside of itself
  const Node* find(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }
};

/// Parses TOML. Throws SceneError with line and column of the first fault.
[[nodiscard]] Node parse_document(std::string_view text, const std::string& name);

/// Puts the overrides into the document, in their order. Throws SceneError naming the override that cannot be applied.
void apply_overrides(Node& document, std::span<const Override> overrides);

/// The value as a message shows it: as TOML would write it, long ones shortened.
[[nodiscard]] std::string shown(const Node& node);
[[nodiscard]] std::string shown(double value);

/// "a list", "a text", …: what kind of value it is, for messages.
[[nodiscard]] std::string_view kind_name(Node::Kind kind);

}  // namespace sunder::scene
