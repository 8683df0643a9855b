#pragma once
/// The text of a case as a tree of values that know their line. Private to the reader of cases.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::verification {

struct Node {
  enum class Kind { table, list, text, integer, number, boolean, date };

  Kind kind = Kind::table;
  int line = 1;          ///< of the value; of a table: its heading
  std::string notation;  ///< as TOML writes it; empty for tables
  std::string text;
  double number = 0.0;  ///< also of an integer
  long long integer = 0;
  bool boolean = false;
  std::vector<Node> list;
  std::vector<std::pair<std::string, Node>> table;  ///< in the order of the file

  Node();  // elsewhere: to say here that it is implicit asks for a whole Node inside of itself
  const Node* find(std::string_view key) const;
  bool is_number() const { return kind == Kind::number || kind == Kind::integer; }
};

/// Parses a TOML file; `shown` stands for it in messages. Throws CaseError with the line of the first fault.
[[nodiscard]] Node parse_case(const std::filesystem::path& file, const std::string& shown);

}  // namespace sunder::verification
