#pragma once
/// Polygon meshes that need no mesh generator: polygons written out, a grid of squares, the whole outline as one
/// polygon.
///
/// All return a mesh with scaling centres chosen and checked by check_mesh(), and throw MeshError where the input
/// cannot be used. Polygons get material 0.

#include <map>
#include <string>
#include <vector>

#include "solver/mesh/outline.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/mesh/size_field.hpp"

namespace sunder::mesh {

/// Polygons by their vertex indices, counter-clockwise; the edges of `boundaries` in either sense. A polygon without
/// any point that sees its whole boundary is refused, not divided: how to divide it is the writer's choice.
PolygonMesh listed_polygons(std::vector<Point> vertices, std::vector<std::vector<int>> polygons,
                            std::map<std::string, std::vector<Edge>> boundaries);

/// Equal rectangles on a rectangular outline (in any position; it may have further vertices on its sides, which then
/// have to be grid points): round(side / size) of them along each side, at least one, so squares where the sides allow
/// it. Vertices and polygons are numbered along the first side of the outline, row by row.
PolygonMesh square_grid(const Outline& outline, double size, long max_polygons = 2'000'000);

/// Ever shorter edges towards a point: the edges that end there are divided at length · ratio^k from it, k = 1 …
/// layers.
struct CornerLayers {
  Point corner;         ///< a vertex of the outline [m]
  int layers = 0;       ///< >= 1
  double ratio = 0.15;  ///< 0 … 1
};

/// The outline as one polygon. Its edges are divided by the size field (none: not at all), then towards the corners.
/// Holes are refused, and so is an outline that is not star-shaped.
PolygonMesh one_polygon(const Outline& outline, const SizeField& edge_size = {},
                        const std::vector<CornerLayers>& corners = {});

}  // namespace sunder::mesh
