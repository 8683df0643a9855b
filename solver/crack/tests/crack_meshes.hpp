#pragma once
/// Meshes for the tests of cutting, and the invariants that every cut mesh keeps.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/sources.hpp"

namespace sunder::crack::testing {

using mesh::Point;

inline mesh::Outline rectangle(double width, double height) {
  return {.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}},
          .boundaries = {{"base", {0}}, {"right", {1}}, {"crest", {2}}, {"left", {3}}}};
}

inline mesh::PolygonMesh grid(double side, double size) {
  return mesh::square_grid(rectangle(side, side), size);
}

/// Bricks in rows, every other row shifted by half a brick, corners moved at random: six-sided polygons as a dual mesh
/// has them. The body is columns × rows [m].
inline mesh::PolygonMesh brick_mesh(int columns, int rows, double disorder, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-disorder, disorder);
  const int half = 2 * columns + 1;  // vertices of a line between rows, every half brick
  std::vector<Point> vertices;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < half; ++i) {
      Point p(0.5 * i, j);
      if (i > 0 && i < half - 1) p.x() += 0.5 * shift(random);
      if (j > 0 && j < rows) p.y() += shift(random);
      vertices.push_back(p);
    }
  }
  std::vector<std::vector<int>> polygons;
  for (int j = 0; j < rows; ++j) {
    for (int i = j % 2 == 0 ? 0 : -1; i < half - 1; i += 2) {
      const int first = std::max(i, 0), last = std::min(i + 2, half - 1);
      std::vector<int> loop;
      for (int k = first; k <= last; ++k) loop.push_back(j * half + k);
      for (int k = last; k >= first; --k) loop.push_back((j + 1) * half + k);
      polygons.push_back(loop);
    }
  }
  std::map<std::string, std::vector<mesh::Edge>> boundaries;
  for (int i = 0; i + 1 < half; ++i) boundaries["base"].push_back({i, i + 1});
  for (int j = 0; j < rows; ++j) boundaries["left"].push_back({(j + 1) * half, j * half});
  return mesh::listed_polygons(vertices, polygons, boundaries);
}

inline double area(const mesh::PolygonMesh& mesh) {
  double sum = 0.0;
  for (int p = 0; p < static_cast<int>(mesh.polygons.size()); ++p)
    sum += mesh::moments(mesh::closed_line(mesh, p)).area;
  return sum;
}

inline double boundary_length(const mesh::PolygonMesh& mesh, const std::string& name) {
  double sum = 0.0;
  for (const mesh::Edge& e : mesh.boundaries.at(name)) sum += (mesh.vertices[e[1]] - mesh.vertices[e[0]]).norm();
  return sum;
}

/// Conforming, watertight, star-shaped, faces paired (check_mesh); area as before; every named boundary as long as
/// before.
inline ::testing::AssertionResult is_sound(const mesh::PolygonMesh& mesh, const mesh::PolygonMesh& before) {
  try {
    mesh::check_mesh(mesh);
  } catch (const mesh::MeshError& error) {
    return ::testing::AssertionFailure() << error.what();
  }
  // Sums of some hundred areas, each with a few units of round-off of the largest.
  const double expected = area(before);
  if (!(std::abs(area(mesh) - expected) <= 1e-13 * expected)) {
    return ::testing::AssertionFailure() << "area " << area(mesh) << ", was " << expected;
  }
  for (const auto& [name, edges] : before.boundaries) {
    const double length = boundary_length(before, name);
    if (!(std::abs(boundary_length(mesh, name) - length) <= 1e-12 * length)) {
      return ::testing::AssertionFailure()
             << "boundary " << name << " is " << boundary_length(mesh, name) << " long, was " << length;
    }
  }
  for (const mesh::CrackFaces& crack : mesh.cracks) {
    for (std::size_t i = 0; i < crack.lower.size(); ++i) {
      if (mesh.vertices[crack.lower[i]] != mesh.vertices[crack.upper[i]]) {
        return ::testing::AssertionFailure() << "pair " << i << " of a crack is not at one place";
      }
      if (crack.lower[i] == crack.upper[i]) return ::testing::AssertionFailure() << "pair " << i << " is not doubled";
    }
  }
  return ::testing::AssertionSuccess();
}

inline Point tip_of(const mesh::PolygonMesh& mesh, int crack) {
  return mesh.polygons[mesh.cracks[crack].tip_polygon].scaling_centre;
}

}  // namespace sunder::crack::testing
