#pragma once
/// How a table of a scene is described and read. Private to this module.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "solver/scene/values.hpp"

namespace sunder::scene {

template <class T>
struct Table {
  std::string name;     ///< with the tables around it: "mesh", "mesh.refine"
  std::string heading;  ///< as a scene writes it
  std::string meaning;
  std::vector<Key<T>> keys;
  /// What single keys cannot tell; called once they are read without a fault. May be empty.
  std::function<void(const Node&, T&, const std::string& path, Findings&)> check = {};

  std::vector<std::string> key_names() const {
    std::vector<std::string> names;
    for (const Key<T>& key : keys) names.push_back(key.facts.name);
    return names;
  }
};

/// A key whose member `accessor(T&)` returns; with a default, unless required, as the struct has it.
template <class T, class Accessor>
Key<T> key_at(Accessor accessor, KeyFacts facts) {
  using Member = std::remove_cvref_t<std::invoke_result_t<Accessor&, T&>>;
  if (!facts.required && facts.default_value.empty()) {
    T owner{};
    facts.default_value = default_text(std::invoke(accessor, owner));
  }
  return {std::move(facts), type_text(static_cast<const Member*>(nullptr)),
          [accessor](const Node& node, T& owner, const Reading& reading) {
            read_value(node, std::invoke(accessor, owner), reading);
          }};
}

template <class T, class Member>
Key<T> key(Member T::*member, KeyFacts facts) {
  return key_at<T>(member, std::move(facts));
}

/// A key that takes one of several words.
template <class T, class Member, class Value>
Key<T> choice(Member T::*member, std::vector<std::pair<std::string, Value>> choices, KeyFacts facts) {
  std::string words;
  T owner{};
  for (const auto& [word, value] : choices) {
    words += (words.empty() ? "\"" : " | \"") + word + "\"";
    if (!facts.required && facts.default_value.empty() && owner.*member == value)
      facts.default_value = "\"" + word + "\"";
  }
  return {std::move(facts), words, [member, choices, words](const Node& node, T& target, const Reading& reading) {
            std::vector<std::string> known;
            for (const auto& [word, value] : choices) {
              if (node.kind == Node::Kind::text && node.text == word) {
                target.*member = value;
                return;
              }
              known.push_back(word);
            }
            const std::string suggestion = node.kind == Node::Kind::text ? nearest(node.text, known) : "";
            reading.complain(node, shown(node) + " is not known" +
                                       (suggestion.empty() ? "" : ", did you mean \"" + suggestion + "\"?") +
                                       "; accepted: " + words);
          }};
}

/// Complains about `key`, which the table at `path` does not have; `names` are those that it has.
void refuse_unknown_key(const Node& value, const std::string& key, const std::string& path,
                        const std::vector<std::string>& names, Findings& findings);

template <class T>
void read_table(const Node& node, const Table<T>& table, T& out, const std::string& path, Findings& findings) {
  if (node.kind != Node::Kind::table)
    return findings.add(
        node.origin, path,
        shown(node) + " is " + std::string(kind_name(node.kind)) + "; accepted: the table " + table.heading);
  const std::size_t faults = findings.count();
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const auto& [name, value] : node.table) {
    const Key<T>* known = nullptr;
    for (const Key<T>& key : table.keys)
      if (key.facts.name == name) known = &key;
    if (known != nullptr)
      known->read(value, out, {known->facts, prefix + name, findings});
    else
      refuse_unknown_key(value, name, path, table.key_names(), findings);
  }
  for (const Key<T>& key : table.keys)
    if (key.facts.required && !node.has(key.facts.name))
      findings.add(node.origin, prefix + key.facts.name, "is missing; accepted: " + accepted_text(key.type, key.facts));
  if (table.check && findings.count() == faults) table.check(node, out, path, findings);
}

/// A key that holds a list of tables, or one table.
template <class T, class Inner>
Key<T> tables_key(std::vector<Inner> T::*member, std::shared_ptr<const Table<Inner>> inner, KeyFacts facts) {
  facts.default_value = "absent";
  return {std::move(facts), "list of tables", [member, inner](const Node& node, T& owner, const Reading& reading) {
            if (node.kind != Node::Kind::list) return reading.wrong(node, "a list of tables " + inner->heading);
            for (std::size_t i = 0; i < node.list.size(); ++i)
              read_table(node.list[i], *inner, (owner.*member).emplace_back(), reading.element(i).path,
                         reading.findings);
          }};
}

template <class T, class Inner>
Key<T> table_key(std::optional<Inner> T::*member, std::shared_ptr<const Table<Inner>> inner, KeyFacts facts) {
  facts.default_value = "absent";
  return {std::move(facts), "table", [member, inner](const Node& node, T& owner, const Reading& reading) {
            read_table(node, *inner, (owner.*member).emplace(), reading.path, reading.findings);
          }};
}

template <class T>
TableReference reference_of(const Table<T>& table) {
  TableReference reference{table.name, table.heading, table.meaning, {}};
  for (const Key<T>& key : table.keys) reference.keys.push_back(key.reference());
  return reference;
}

}  // namespace sunder::scene
