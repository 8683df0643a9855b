#pragma once
/// Search along the outer boundary of a mesh for places that nearly or wrongly meet.

#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Throws MeshError where two vertices of the boundary lie at one place, a vertex lies inside an edge that does not
/// list it, or two edges cross. `boundary` are the edges of one polygon only. Vertices paired by a crack's faces may
/// coincide. About O(edges), by a grid of buckets.
void check_boundary_places(const PolygonMesh& mesh, const std::vector<Edge>& boundary);

}  // namespace sunder::mesh
