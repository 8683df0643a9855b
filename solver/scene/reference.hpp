#pragma once
/// Every table and key of a scene with its unit, range and default: from the same descriptions that the reader obeys.

#include <string>
#include <vector>

namespace sunder::scene {

struct KeyReference {
  std::string name, type, unit, accepted, default_value, meaning;  ///< default_value: "required", "absent" or the value
};

struct TableReference {
  std::string name;     ///< "" for the keys above the first table; "mesh.refine" for a table inside a table
  std::string heading;  ///< as a scene writes it: "[mesh]", "[[crack]]", "mesh.refine = [{…}]"
  std::string meaning;
  std::vector<KeyReference> keys;
};

/// All tables in the order of the documentation.
[[nodiscard]] std::vector<TableReference> reference();

/// The reference as Markdown: a heading and a table of keys for each table.
[[nodiscard]] std::string reference_markdown();

}  // namespace sunder::scene
