#pragma once
/// Small meshes for the tests of formation and assembly.

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::sbfem::testing {

/// `columns` × `rows` hexagons, slightly crooked so that no two are alike. Polygon i has material i modulo `materials`.
inline mesh::PolygonMesh honeycomb(int columns, int rows, int materials = 1) {
  mesh::PolygonMesh result;
  std::map<std::pair<int, int>, int> known;  // by place on a grid of half a side by half a height
  const double height = std::sqrt(3.0) / 2.0;
  const auto vertex = [&](int i, int j) {
    const auto [found, added] = known.try_emplace({i, j}, static_cast<int>(result.vertices.size()));
    if (added) {
      const double crooked = 0.05 * std::sin(3.0 * i + 5.0 * j);
      result.vertices.emplace_back(0.5 * i + crooked, height * j - crooked);
    }
    return found->second;
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int i = 3 * column, j = 2 * row + column % 2;  // centre of the hexagon
      mesh::Polygon polygon;
      polygon.vertices = {vertex(i - 1, j - 1), vertex(i + 1, j - 1), vertex(i + 2, j),
                          vertex(i + 1, j + 1), vertex(i - 1, j + 1), vertex(i - 2, j)};
      polygon.scaling_centre = {0.5 * i, height * j};
      polygon.material = (row * columns + column) % materials;
      result.polygons.push_back(polygon);
    }
  }
  return result;
}

}  // namespace sunder::sbfem::testing
