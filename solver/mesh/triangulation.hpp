#pragma once
/// Triangles inside an outline, by gmsh (Frontal-Delaunay), with vertices along crack paths.

#include <vector>

#include "solver/mesh/outline.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/mesh/size_field.hpp"

namespace sunder::mesh {

struct TriangulationOptions {
  SizeField size;                              ///< target edge length of the triangles [m]
  std::vector<std::vector<Point>> paths = {};  ///< lines that triangle edges follow: crack paths, >= 2 points each [m]
  std::vector<Point> points = {};              ///< single places that become vertices [m]
  long max_polygons = 2'000'000;               ///< vertices allowed: each becomes a polygon of the dual
};

/// The number of vertices to expect: ∫ 2 / (√3 h²) dA + ½ ∮ ds / h with the size field h, within about 20 %
/// (a strip one triangle wide: 40 %).
double estimated_vertices(const Outline& outline, const SizeField& size);

/// The triangles as polygons, scaling centres at their centroids, boundaries named as in the outline. Vertices of the
/// outline, of the paths and the points are vertices at exactly these places; all vertices on an edge lie on it to
/// round-off. A path may start and end on the outline, else lies strictly inside; it may share end points with others.
/// gmsh sees the body shifted to the origin and scaled to size 1, so units and position do not matter.
/// Throws MeshError where the outline is unsound (check_outline), a path or point lies outside the body or paths cross
/// each other, the estimate exceeds `max_polygons` (before meshing), or gmsh fails.
PolygonMesh triangulate(const Outline& outline, const TriangulationOptions& options);

/// triangulate() with the triangles as the polygons of the mesh, checked; `max_polygons` counts triangles.
PolygonMesh triangle_mesh(const Outline& outline, const TriangulationOptions& options);

/// Edge length of the triangles over the size of the polygons. A hexagon of the dual is as wide as the triangles' edges
/// are long, but polygons on the boundary are halves: with 1.06 the mean polygon of a body of some hundred polygons has
/// the area of a hexagon as wide as the size asked for. A constant, so that sizes halve when asked to.
inline constexpr double edge_per_polygon_size = 1.06;

/// triangulate() and the dual (dual.hpp), checked; `size` is the size of the polygons. Polygon i lies round the
/// triangles' vertex i.
PolygonMesh dual_mesh(const Outline& outline, const TriangulationOptions& options);

}  // namespace sunder::mesh
