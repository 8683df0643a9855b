#pragma once
/// The outline of the body: a straight-edged closed line, holes, and the names of its edges.

#include <map>
#include <string>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct Outline {
  std::vector<Point> vertices;                 ///< counter-clockwise [m], >= 3, no closing repetition
  std::vector<std::vector<Point>> holes = {};  ///< each >= 3 vertices [m], in either sense
  std::map<std::string, std::vector<int>> boundaries =
      {};  ///< edge i runs from vertex i to i + 1; holes' edges count on

  int edge_count() const;                  ///< of the outline and all holes
  std::array<Point, 2> edge(int i) const;  ///< its two ends as they were written
};

/// Throws MeshError, with the vertex or edge numbers and coordinates and what is accepted, unless: every line has at
/// least three vertices, all finite and none repeated; no line touches or crosses itself or another; the outline runs
/// counter-clockwise (it is not turned round silently: the edge numbers in `boundaries` would name other edges); the
/// holes lie inside the outline and not inside each other; the named edges exist and none has two names. O(n²).
void check_outline(const Outline& outline);

/// The longest side of the box around the points [m]; every tolerance of this module is relative to it.
double extent(const std::vector<Point>& points);

/// What round-off may do to a place: 1e-12 of the body, or 8 units in the last place of its coordinates if it lies far
/// from the origin [m].
double place_tolerance(const std::vector<Point>& points);

}  // namespace sunder::mesh
