#pragma once
/// How one key of a scene is described, once: its name, unit, range, default and meaning, and the member that it fills.
/// The reader, the suggestions and the reference all follow from it. Private to this module.

#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/scene/findings.hpp"
#include "solver/scene/reference.hpp"

namespace sunder::scene {

/// The numbers that a key accepts; each number of a list alike.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool holds(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

constexpr Range positive() {
  return {.low = 0.0, .low_open = true};
}
constexpr Range at_least(double low) {
  return {.low = low};
}
constexpr Range between(double low, double high) {
  return {.low = low, .high = high};
}

struct KeyFacts {
  std::string name;
  std::string unit = "";
  Range range = {};
  bool required = false;
  std::string meaning;
  std::string default_value = "";  ///< filled from the struct's own default where left empty
};

/// What a value is read with: where it stands in the scene ("mesh.refine[0].size"), what it must satisfy, where to
/// complain.
struct Reading {
  const KeyFacts& facts;
  std::string path;
  Findings& findings;

  void wrong(const Node& node, const std::string& accepted) const;
  void complain(const Node& node, const std::string& what) const { findings.add(node.origin, path, what); }
  Reading element(std::size_t i) const { return {facts, path + "[" + std::to_string(i) + "]", findings}; }
};

/// "> 0", ">= 0, < 0.5", "1 … 64"; empty where every number is accepted.
[[nodiscard]] std::string text_of(const Range& range);

/// "a number > 0 [m] (target polygon size)"
[[nodiscard]] std::string accepted_text(const std::string& what, const KeyFacts& facts);

template <class T>
struct Key {
  KeyFacts facts;
  std::string type;
  std::function<void(const Node&, T&, const Reading&)> read;

  KeyReference reference() const {
    return {facts.name,   type, facts.unit, text_of(facts.range), facts.required ? "required" : facts.default_value,
            facts.meaning};
  }
};

}  // namespace sunder::scene
