#pragma once
/// Every edge of a polygon mesh once: which polygons lie on its two sides, and which edge of which polygon it is.

#include <array>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Edges are numbered in the order in which the polygons, taken one after another, first show them.
struct EdgeTable {
  std::vector<int> first;                  ///< (polygons + 1): polygon i's edges stand at first[i] … first[i + 1] - 1
  std::vector<int> edge;                   ///< (polygon edges): number of the mesh edge
  std::vector<Edge> ends;                  ///< (edges): vertices, in the sense of the first polygon that shows it
  std::vector<std::array<int, 2>> owners;  ///< (edges): the first two polygons; second -1 on the boundary of the body
  std::vector<int> uses;                   ///< (edges): how many polygons show it; 1 or 2 in a sound mesh

  int count() const { return static_cast<int>(ends.size()); }
};

/// O(edges) for meshes whose vertices have bounded valence. An edge is its pair of vertices: the two faces of a crack
/// have vertices of their own and are two edges. Throws std::invalid_argument where a vertex index is out of range.
EdgeTable edge_table(const PolygonMesh& mesh);

}  // namespace sunder::mesh
