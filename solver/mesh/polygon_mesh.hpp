#pragma once
/// A body divided into polygons: the topology, straight edges between vertices, before any order is chosen.
///
/// Everything that cuts, merges or refines works on this value. Nodes of higher order are placed afterwards, once
/// (mesh/nodal_mesh.hpp).

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace sunder::mesh {

using Point = Eigen::Vector2d;  ///< (x, y) [m]

/// An edge by its two vertices, in the counter-clockwise sense of the polygon that owns it.
using Edge = std::array<int, 2>;

struct Polygon {
  std::vector<int> vertices;  ///< counter-clockwise; open: from the lower crack face's vertex to the upper one's
  Point scaling_centre = Point::Zero();  ///< sees the whole boundary (J_b > 0); at the crack tip where open
  bool open = false;  ///< a crack polygon: its boundary is not closed, the faces run from both ends to the centre
  int material = 0;   ///< index into the scene's materials

  int edge_count() const { return static_cast<int>(vertices.size()) - (open ? 1 : 0); }
  Edge edge(int i) const { return {vertices[i], vertices[(i + 1) % vertices.size()]}; }
};

/// The two faces of one crack after cutting, from the mouth to the tip. Pair i of vertices starts at the same place;
/// `lower` is on the right of the path, `upper` on its left, seen from mouth to tip. The last pair are the ends of the
/// tip polygon's open boundary; the rest of the faces are its two side faces, which need no vertices.
struct CrackFaces {
  std::vector<int> lower, upper;  ///< vertex indices, same length >= 1
  int tip_polygon = -1;  ///< index of the open polygon that holds the tip; -1: has come out at a face, no tip left
};

struct PolygonMesh {
  std::vector<Point> vertices;
  std::vector<Polygon> polygons;
  std::map<std::string, std::vector<Edge>> boundaries;  ///< named parts of the outer boundary
  std::vector<CrackFaces> cracks;                       ///< one entry a tip, in the order of the scene
};

}  // namespace sunder::mesh
