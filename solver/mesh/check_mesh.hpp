#pragma once
/// Is this mesh sound? Every check that a solver relies on, with the polygon, edge or vertex and its place in the
/// message.

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Throws MeshError unless vertex indices exist, polygons have >= 3 vertices (open: >= 2) and none twice, every edge
/// belongs to one polygon or to two in opposite senses, every vertex belongs to a polygon, and the faces of each crack
/// are paired and end at its open polygon. Looks at no coordinates. O(edges).
void check_topology(const PolygonMesh& mesh);

/// check_topology; every named edge is an edge of the outer boundary in the sense of its polygon; and the places: all
/// finite; no edge without length; polygons counter-clockwise, with an area, and seen from their scaling centres
/// (clearance > smallest_clearance, polygon_geometry.hpp); no vertex in the middle of an edge that does not list it; no
/// two vertices at one place unless a crack's faces pair them; polygons meet round every inner vertex without overlap;
/// the boundary does not cross itself. With these the polygons cover the body exactly once. Places closer than 1e-10 of
/// the body's size count as one, unless an edge joins them.
void check_mesh(const PolygonMesh& mesh);

/// Turns named edges that are written against the sense of their polygon.
void orient_boundaries(PolygonMesh& mesh);

}  // namespace sunder::mesh
