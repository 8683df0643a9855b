#include "solver/scene/reference.hpp"

#include <algorithm>

#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

using AnalysisWords = std::vector<std::pair<std::string, Analysis>>;

Table<Scene> make_head_table() {
  return {"",
          "(above the first table)",
          "what the scene is",
          {key(&Scene::name, {.name = "name", .required = true, .meaning = "of the scene, in every result"}),
           choice(&Scene::analysis,
                  AnalysisWords{{"static", Analysis::static_},
                                {"modal", Analysis::modal},
                                {"dynamic", Analysis::dynamic},
                                {"crack-water", Analysis::crack_water},
                                {"response", Analysis::response}},
                  {.name = "analysis", .required = true, .meaning = "what is asked"})}};
}

std::vector<Part> make_parts() {
  std::vector<Part> all = body_parts();
  for (std::vector<Part> more : {shaking_parts(), crack_face_parts()})
    std::move(more.begin(), more.end(), std::back_inserter(all));
  return all;
}

/// A vertical bar ends a cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

}  // namespace

const Table<Scene>& head_table() {
  static const Table<Scene> table = make_head_table();
  return table;
}

const std::vector<Part>& parts() {
  static const std::vector<Part> all = make_parts();
  return all;
}

void refuse_unknown_key(const Node& value, const std::string& key, const std::string& path,
                        const std::vector<std::string>& names, Findings& findings) {
  const std::string subject = path.empty() ? key : path + "." + key;
  const bool list_of_tables =
      value.kind == Node::Kind::list && !value.list.empty() && value.list.front().kind == Node::Kind::table;
  const bool table = path.empty() && (value.kind == Node::Kind::table || list_of_tables);
  std::string what = table ? "there is no such table" : "there is no such key";
  if (const std::string suggestion = nearest(key, names); !suggestion.empty()) {
    what += ", did you mean `" + suggestion + "`?";
  } else {
    for (const TableReference& other : reference())
      for (const KeyReference& known : other.keys)
        if (known.name == key && other.name != path) {
          findings.add(value.key_origin, subject,
                       what + "; `" + key + "` belongs to " + other.heading + "; accepted here: " + listed(names));
          return;
        }
  }
  findings.add(value.key_origin, subject, what + "; accepted: " + listed(names));
}

std::vector<TableReference> reference() {
  std::vector<TableReference> all{reference_of(head_table())};
  for (const Part& part : parts()) {
    all.insert(all.end(), part.references.begin(), part.references.end());
  }
  return all;
}

std::string reference_markdown() {
  std::string text;
  for (const TableReference& table : reference()) {
    text += "### `" + table.heading + "`\n\n" + table.meaning + "\n\n";
    text += "| key | type | unit | accepted | default | meaning |\n|---|---|---|---|---|---|\n";
    for (const KeyReference& key : table.keys)
      text += "| `" + key.name + "` | " + cell(key.type) + " | " + key.unit + " | " + key.accepted + " | " +
              cell(key.default_value) + " | " + cell(key.meaning) + " |\n";
    text += "\n";
  }
  return text;
}

}  // namespace sunder::scene
