#pragma once
/// The line that a crack follows, and whether a body with its mesh can hold such a crack.
///
/// A crack from a face of the body runs from its mouth, on the boundary, to its one tip. An inner crack has two tips
/// and no mouth.

#include <stdexcept>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::crack {

using mesh::Point;

/// what() names the crack by its number in the scene (from 1), the place, and what is accepted.
class CrackError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CrackPath {
  std::vector<Point> points;  ///< from the mouth to the tip; inner: from the first tip to the last [m]; >= 2 points
  bool inner = false;
};

/// Throws CrackError unless
///   - there are at least two points, all finite, and no segment is shorter than 1e-9 of the body's size;
///   - the mouth lies on the boundary (within 1e-6 of the body's size), not on a corner of it and not on another crack;
///   - the path stays inside the body and touches neither the boundary nor an inserted crack nor itself;
///   - each tip keeps `smallest_tip_distance` · √(area of the polygon it lies in) from every face.
/// `number` counts the cracks of the scene from 0. O(edges of the mesh · segments).
void check_path(const mesh::PolygonMesh& mesh, const CrackPath& path, int number);

inline constexpr double smallest_tip_distance = 1e-3;  ///< [-], see check_path

}  // namespace sunder::crack
