#pragma once
/// How a crack is cut into polygons, and what the cut did to the mesh.

#include <vector>

namespace sunder::crack {

struct CutOptions {
  /// A vertex nearer to the path than this fraction of its shortest edge is moved onto the path instead of being passed
  /// by, so that no short edge arises; 0 … 0.25. Vertices of the outer boundary, of cracks and of material interfaces
  /// stay.
  double snap = 0.05;
  /// The tip polygon takes in all polygons nearer to the tip than this fraction of √(area) of the one that holds the
  /// tip.
  double tip_clearance = 0.2;
  /// Least number of edges of a tip polygon: edges that look longest from the tip are halved until it is reached.
  int tip_edges = 16;
  /// An edge of a tip polygon is halved while its length exceeds this multiple of its distance from the tip; > 0.5.
  /// Grades the edges where the crack has a kink close to its tip.
  double tip_edge_ratio = 4.0;
  /// An edge whose line is nearer to the tip than this fraction of the edge's own distance is seen too flatly (the
  /// SBFEM's J_b along it is that small): it is joined away or cut off. A body that shall stay one polygon bears much
  /// flatter ones.
  double flattest_edge = 0.04;
  /// A piece thinner than this fraction of a neighbour (area over diameter) is joined to it where the union is
  /// star-shaped.
  double sliver = 0.1;
};

/// Where no sound tip polygon comes out, the cut is tried again with tip_clearance times these.
inline constexpr double clearance_attempts[] = {1.0, 0.5, 2.0, 0.25, 4.0, 0.05};

/// Which polygons and vertices of the mesh are still those of before. Modes of the polygons named in `polygon_from` may
/// be kept: shape, scaling centre, and order of vertices are the same bit for bit (the numbers of the vertices may
/// differ).
struct CutReport {
  std::vector<int> polygon_from;  ///< (polygons): its index before the cut where nothing changed, -1 elsewhere
  std::vector<int>
      vertex_from;           ///< (vertices): the vertex of before at the same place (a doubled one: for both), or -1
  std::vector<int> changed;  ///< polygons with polygon_from = -1, ascending
};

}  // namespace sunder::crack
