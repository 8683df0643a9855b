#pragma once
/// Bodies and questions that several mesh tests share.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/outline.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Message of the MeshError that `action` throws; a test failure and "" where it throws none.
inline std::string mesh_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const MeshError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no MeshError was thrown";
  return "";
}

inline void expect_words(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "message: " << message << "\nlacks: " << part;
}

inline Outline rectangle(double width, double height, Point origin = Point::Zero()) {
  return {.vertices = {origin, origin + Point(width, 0), origin + Point(width, height), origin + Point(0, height)},

          .boundaries = {{"bottom", {0}}, {"right", {1}}, {"top", {2}}, {"left", {3}}}};
}

/// A square that a crack from the middle of its left side has opened: vertices 4 (lower face) and 5 (upper face).
inline PolygonMesh cracked_square() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {0, 1}};
  mesh.polygons = {{.vertices = {4, 0, 1, 2, 3, 5}, .scaling_centre = {1, 1}, .open = true}};
  mesh.cracks = {{.lower = {4}, .upper = {5}, .tip_polygon = 0}};
  return mesh;
}

/// The non-overflow section of Koyna dam [m].
inline Outline koyna() {
  return {.vertices = {{0, 0}, {70, 0}, {19.25, 66.5}, {14.8, 103}, {0, 103}},

          .boundaries = {{"base", {0}}, {"downstream", {1, 2}}, {"crest", {3}}, {"upstream", {4}}}};
}

inline double total_area(const PolygonMesh& mesh) {
  double area = 0.0;
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) area += moments(closed_line(mesh, i)).area;
  return area;
}

inline double boundary_length(const PolygonMesh& mesh, const std::string& name) {
  double length = 0.0;
  for (const Edge& e : mesh.boundaries.at(name)) length += (mesh.vertices[e[1]] - mesh.vertices[e[0]]).norm();
  return length;
}

}  // namespace sunder::mesh
