#pragma once
/// Reads one value of a scene into one member, with its type and range checked; a fault is a finding and leaves the
/// member as it was. Private to this module.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/scene/key.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::scene {

void read_value(const Node&, double&, const Reading&);
void read_value(const Node&, int&, const Reading&);
void read_value(const Node&, long&, const Reading&);
void read_value(const Node&, bool&, const Reading&);
void read_value(const Node&, std::string&, const Reading&);
void read_value(const Node&, std::filesystem::path&, const Reading&);
void read_value(const Node&, Point&, const Reading&);
void read_value(const Node&, std::vector<double>&, const Reading&);  ///< a plain number is a list of one

template <class T>
void read_value(const Node& node, std::optional<T>& out, const Reading& reading) {
  T value{};
  read_value(node, value, reading);
  out = std::move(value);
}

template <class T, std::size_t N>
void read_value(const Node& node, std::array<T, N>& out, const Reading& reading) {
  if (node.kind != Node::Kind::list || node.list.size() != N)
    return reading.wrong(node, "a list of " + std::to_string(N) + " numbers");
  for (std::size_t i = 0; i < N; ++i) read_value(node.list[i], out[i], reading.element(i));
}

template <class T>
void read_value(const Node& node, std::vector<T>& out, const Reading& reading) {
  if (node.kind != Node::Kind::list) return reading.wrong(node, "a list");
  std::vector<T> values(node.list.size());
  for (std::size_t i = 0; i < values.size(); ++i) read_value(node.list[i], values[i], reading.element(i));
  out = std::move(values);
}

template <class T>
void read_value(const Node& node, std::map<std::string, T>& out, const Reading& reading) {
  if (node.kind != Node::Kind::table) return reading.wrong(node, "a table of names, { base = […], … }");
  for (const auto& [name, value] : node.table)
    read_value(value, out[name], {reading.facts, reading.path + "." + name, reading.findings});
}

/// What the reference calls the type of a member.
inline std::string type_text(const double*) {
  return "number";
}
inline std::string type_text(const int*) {
  return "whole number";
}
inline std::string type_text(const long*) {
  return "whole number";
}
inline std::string type_text(const bool*) {
  return "true or false";
}
inline std::string type_text(const std::string*) {
  return "text";
}
inline std::string type_text(const std::filesystem::path*) {
  return "path";
}
inline std::string type_text(const Point*) {
  return "[x, y]";
}
inline std::string type_text(const std::vector<double>*) {
  return "number or list of numbers";
}
inline std::string type_text(const std::vector<int>*) {
  return "list of whole numbers";
}
inline std::string type_text(const std::vector<Point>*) {
  return "list of [x, y]";
}
inline std::string type_text(const std::vector<std::vector<Point>>*) {
  return "list of lists of [x, y]";
}
inline std::string type_text(const std::vector<std::vector<int>>*) {
  return "list of lists of whole numbers";
}
inline std::string type_text(const std::array<double, 2>*) {
  return "[x, y]";
}
inline std::string type_text(const std::map<std::string, std::vector<int>>*) {
  return "{ name = [edge, …] }";
}
inline std::string type_text(const std::map<std::string, std::vector<mesh::Edge>>*) {
  return "{ name = [[vertex, vertex], …] }";
}
template <class T>
std::string type_text(const std::optional<T>*) {
  return type_text(static_cast<const T*>(nullptr));
}

/// How the reference shows a default.
inline std::string default_text(double value) {
  return shown(value);
}
inline std::string default_text(int value) {
  return std::to_string(value);
}
inline std::string default_text(long value) {
  return std::to_string(value);
}
inline std::string default_text(bool value) {
  return value ? "true" : "false";
}
inline std::string default_text(const std::string&) {
  return "absent";
}
inline std::string default_text(const std::filesystem::path&) {
  return "absent";
}
template <class T>
std::string default_text(const std::optional<T>&) {
  return "absent";
}
template <class T>
std::string default_text(const std::map<std::string, T>&) {
  return "absent";
}
template <class List>
std::string default_text(const List& list) requires requires {
  list.begin()[0];
} &&(!std::is_same_v<List, std::string>) {
  std::string text;
  if constexpr (std::is_arithmetic_v<typename List::value_type>)
    for (const auto& value : list) text += (text.empty() ? "" : ", ") + default_text(value);
  return text.empty() ? "absent" : "[" + text + "]";
}

}  // namespace sunder::scene
