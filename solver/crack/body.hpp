#pragma once
/// The faces of a body as its mesh has them: the outer boundary and the faces of the cracks, and what lies inside.

#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::crack {

using mesh::Point;

/// An edge without a polygon on its right. The stretch of a crack inside its tip polygon counts as two such edges.
struct FaceEdge {
  Point from = Point::Zero(), to = Point::Zero();  ///< the body lies on the left [m]
  mesh::Edge vertices{-1, -1};                     ///< -1 for a tip, which has no vertex
  int crack = -1;                                  ///< index into mesh.cracks; -1: the outer boundary
};

std::vector<FaceEdge> face_edges(const mesh::PolygonMesh& mesh);  ///< O(edges)

/// Length of the diagonal of the body's bounding box [m].
double body_size(const mesh::PolygonMesh& mesh);

/// True inside the body (even-odd rule over the outer boundary, holes counted).
bool inside(const std::vector<FaceEdge>& faces, const Point& point);

/// A polygon that holds the point or is nearest to it; open polygons count with their tip.
int polygon_at(const mesh::PolygonMesh& mesh, const Point& point);

double distance_to_segment(const Point& point, const Point& a, const Point& b);

/// True where segments p-q and a-b come nearer than `reach` [m].
bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b, double reach);

}  // namespace sunder::crack
