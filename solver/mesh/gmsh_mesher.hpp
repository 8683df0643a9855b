#pragma once
/// What this module asks of gmsh, in gmsh's terms: points, straight curves, one plane surface.
///
/// gmsh keeps one state for the whole program: each call here starts it, silent, on one thread, with a model of its own
/// and without the user's configuration, and ends it again. Calls exclude each other; the interrupt handler of the
/// program is put back. Not for programs that use gmsh themselves. What gmsh throws comes out as MeshError.

#include <array>
#include <functional>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct PlaneModel {
  struct Curve {
    int from, to;   ///< indices into points
    bool embedded;  ///< inside the surface: a line that triangle edges follow
  };
  std::vector<Point> points;  ///< of a body of size 1 … 2: gmsh's tolerances are absolute [-]
  std::vector<Curve> curves;
  std::vector<std::vector<int>> loops;  ///< curves round the outline, then round each hole
  std::vector<int> inner_points;        ///< points on no curve
};

struct PlaneTriangles {
  std::vector<Point> places;                   ///< (nodes)
  std::vector<std::array<int, 3>> triangles;   ///< nodes, in gmsh's sense
  std::vector<std::vector<Edge>> curve_edges;  ///< (curves): edges along each
  std::vector<std::vector<int>> curve_nodes;   ///< (curves): nodes inside each
  std::vector<std::vector<int>> point_nodes;   ///< (points): the node at each
};

/// Frontal-Delaunay triangles with edges about size(place) long: the most regular triangles, so the most regular dual.
PlaneTriangles triangulate_plane(const PlaneModel& model, const std::function<double(const Point&)>& size);

}  // namespace sunder::mesh
