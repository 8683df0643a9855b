#pragma once
/// The tables of a scene, each with the member of Scene that it fills. Private to this module.

#include <functional>
#include <string>
#include <vector>

#include "solver/scene/table.hpp"

namespace sunder::scene {

struct Part {
  std::string name;  ///< the table's, e.g. "mesh"
  bool list;         ///< [[name]], any number, instead of [name]
  std::function<void(const Node&, Scene&, Findings&)> read;
  std::vector<TableReference> references;  ///< the table and those inside it
};

/// [geometry] [mesh] [material] [[region]] [[crack]] [[support]] [[load]] [gravity] [modal]
std::vector<Part> body_parts();
/// [contact] [crack_water] [propagation] [crack_line]
std::vector<Part> crack_face_parts();
/// [reservoir] [foundation] [ground_motion] [dynamics] [response] [output]
std::vector<Part> shaking_parts();

/// All of them, in the order of the documentation; made once.
const std::vector<Part>& parts();

/// `name` and `analysis`.
const Table<Scene>& head_table();

/// What each part's reader records for later messages.
inline Location location_of(const Node& node) {
  return {node.origin.line, node.origin.column};
}

/// A part of which a scene has one or none. `member` leads to a T or a std::optional<T>.
template <class T, class Member>
Part one_part(Member Scene::*member, Table<T> table, std::vector<TableReference> inner = {}) {
  std::vector<TableReference> references{reference_of(table)};
  references.insert(references.end(), inner.begin(), inner.end());
  return {table.name, false,
          [member, table](const Node& node, Scene& scene, Findings& findings) {
            if (node.kind == Node::Kind::list)
              return findings.add(node.origin, table.name, "is a list of tables; accepted: one table " + table.heading);
            T value{};
            read_table(node, table, value, table.name, findings);
            scene.*member = std::move(value);
            scene.locations[table.name] = location_of(node);
          },
          std::move(references)};
}

/// A part of which a scene may have several.
template <class T>
Part list_part(std::vector<T> Scene::*member, Table<T> table) {
  return {table.name,
          true,
          [member, table](const Node& node, Scene& scene, Findings& findings) {
            if (node.kind != Node::Kind::list)
              return findings.add(node.origin, table.name,
                                  "is one table; accepted: " + table.heading + " (two brackets), any number of them");
            for (std::size_t i = 0; i < node.list.size(); ++i) {
              const std::string path = table.name + "[" + std::to_string(i) + "]";
              read_table(node.list[i], table, (scene.*member).emplace_back(), path, findings);
              scene.locations[path] = location_of(node.list[i]);
            }
          },
          {reference_of(table)}};
}

}  // namespace sunder::scene
