#pragma once
/// Polygons round the vertices of a mesh of triangles and quadrilaterals: its dual.

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Polygon i lies round vertex i. Its vertices are the centroids of the cells there; on the boundary also the vertex
/// itself and the midpoints of its two boundary edges, so the body is covered exactly and named boundaries keep their
/// places. From a good triangulation the polygons are like hexagons, about 2.2 vertices each in all. At a sharp
/// re-entrant corner that a polygon could not see round (clearance < 0.05) it is cut from the corner into two or more;
/// the further ones stand behind all others. Materials: that of the cells with the most area at the vertex. Scaling
/// centres are chosen. Throws MeshError where a vertex is unsound (the body touches itself there) or a polygon is not
/// star-shaped. The mesh must pass check_topology() and hold no cracks (std::invalid_argument). O(edges).
PolygonMesh dual(const PolygonMesh& primal);

}  // namespace sunder::mesh
