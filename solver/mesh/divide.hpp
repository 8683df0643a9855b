#pragma once
/// More vertices on the edges of a mesh, kept consistent: both polygons of an edge, named boundaries, both faces of a
/// crack.
///
/// New vertices get the next numbers, edge after edge; polygons and old vertices keep theirs. The shape does not
/// change, so scaling centres stay.

#include <functional>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"
#include "solver/mesh/size_field.hpp"

namespace sunder::mesh {

/// Places on the edge from a to b as ascending fractions 0 < t < 1 of its length; empty: leave the edge whole.
using EdgeDivision = std::function<std::vector<double>(const Point& a, const Point& b)>;

/// Asks once for every edge, in the order of the edge table. Of two edges that face each other across a crack both take
/// the division with more pieces. Throws std::invalid_argument where the fractions are not ascending inside 0 … 1.
void divide_edges(PolygonMesh& mesh, const EdgeDivision& division);

/// No edge is longer than the size field asks for at its place (sizes [m]).
void divide_long_edges(PolygonMesh& mesh, const SizeField& size);

/// Divides edges of one polygon equally until it has at least `edges` of them, always the edge whose pieces are seen
/// largest from the scaling centre. For crack polygons, whose stress intensity factors depend on it.
void divide_polygon(PolygonMesh& mesh, int polygon, int edges);

}  // namespace sunder::mesh
