#pragma once
/// Points, segments and closed lines in the plane: how they lie to each other.

#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// Twice the signed area of the triangle a b c [m²]: positive where c lies left of the line from a to b.
double twice_area(const Point& a, const Point& b, const Point& c);

/// Distance of a point to the segment a b, a != b [m].
double distance_to_segment(const Point& p, const Point& a, const Point& b);

/// True where the segments a b and c d cross, or come within the tolerance of each other [m].
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d, double tolerance);

/// True where the point lies inside the closed line (even-odd rule); on the line it may be either.
bool inside(const Point& p, const std::vector<Point>& line);

}  // namespace sunder::mesh
