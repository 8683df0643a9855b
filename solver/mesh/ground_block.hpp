#pragma once
/// A block of polygons below a body that stands on level ground: the near field of its foundation.

#include <string>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct GroundBlock {
  double width = 0.0;             ///< of the block beside the base, on either side [m], > 0
  double depth = 0.0;             ///< [m], > 0
  double size = 0.0;              ///< of its polygons away from the base [m], > 0
  int material = 0;               ///< of its polygons
  long max_polygons = 2'000'000;  ///< of the block
};

/// The name of the boundary that append_block() adds: the block's sides and bottom, from the upper left corner to the
/// upper right one, counter-clockwise. What lies beyond is the unbounded rock.
inline constexpr const char* block_interface = "foundation: interface";

/// Where the base lies: its two ends, left and right [m].
struct LevelBase {
  Point left, right;
  Point middle() const { return 0.5 * (left + right); }
  double length() const { return right.x() - left.x(); }
};

/// The extent of a named boundary that is one level line with the body above it. Throws MeshError with the place where
/// it is not level, has a gap, or the body reaches below it.
LevelBase level_base(const PolygonMesh& mesh, const std::string& boundary);

/// Adds the block below the boundary: polygons (the dual of triangles) that share all vertices on the base with the
/// body; a vertex that only one side has is added to the other side's polygon. Their number grows from the body's size
/// to `size`. The boundary itself is inside afterwards and loses its name; block_interface is new. The ground beside
/// the base stays free. Throws MeshError as level_base() and dual_mesh(), std::invalid_argument where a size is not >
/// 0.
void append_block(PolygonMesh& mesh, const std::string& boundary, const GroundBlock& block);

/// The block alone, below a strip -half_width … half_width of the surface y = 0, which becomes the boundary "strip".
/// Polygons have the size `strip_size` [m] below the strip and `end_size` at its two ends, where stresses of a rigid
/// strip are singular. Throws as append_block().
PolygonMesh block_below_strip(double half_width, const GroundBlock& block, double strip_size, double end_size);

}  // namespace sunder::mesh
