#pragma once
/// Area, centroid and second moments of a polygon, and where its scaling centre may lie.
///
/// The scaling centre must see the whole boundary: it lies in the polygon's *kernel*, the intersection of the
/// half-planes left of its edges. How well it sees is measured by the *clearance*: the smallest distance from the point
/// to the line of an edge, in the affine frame in which the polygon's second moments are those of the unit disc. So
/// clearance is 1 for a disc's centre and 0.866 for a square's or any parallelogram's, however thin or skew it is; it
/// is <= 0 where an edge is not seen from inside (J_b <= 0).

#include <Eigen/Core>
#include <span>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

struct Moments {
  double area = 0.0;       ///< [m²], positive where counter-clockwise
  Point centroid;          ///< [m]
  Eigen::Matrix2d second;  ///< ∫ (x - c)(x - c)ᵀ dA about the centroid [m⁴]
};

/// Moments of the region inside a closed line of points, (n >= 3). Computed relative to the first point, so a shift of
/// the origin costs no digits. Area 0: the centroid is the mean of the points and `second` is 0.
Moments moments(std::span<const Point> points);

/// The closed line around a polygon: its vertices, and behind them the scaling centre where it is open.
std::vector<Point> closed_line(const PolygonMesh& mesh, int polygon);

/// The kernel as a convex polygon, counter-clockwise; empty where no point sees the whole boundary. O(n²).
std::vector<Point> kernel(std::span<const Point> points);

/// Clearance of a point (above), [-]; <= 0 where it does not see the whole boundary from inside. With `open` the line
/// from the last point over the centre to the first is the two faces of a crack: part of the outline, but no edge to be
/// seen.
double clearance(std::span<const Point> points, const Point& centre, bool open = false);

struct ScalingCentre {
  Point point;             ///< [m]
  double clearance = 0.0;  ///< [-]; <= `smallest_clearance` where there is none
};

/// A centre with less clearance than this counts as not seeing the boundary: J_b would be round-off.
inline constexpr double smallest_clearance = 1e-9;

/// The centroid where its clearance is at least `enough`, otherwise the point of the kernel with the largest clearance
/// (the middle of them where there are many). Points counter-clockwise, n >= 3.
ScalingCentre scaling_centre(std::span<const Point> points, double enough = 0.3);

/// Scaling centre of a closed polygon of the mesh. Throws MeshError with the polygon's number and place where it runs
/// clockwise, has no area, or no point sees its whole boundary.
Point chosen_centre(const PolygonMesh& mesh, int polygon);

}  // namespace sunder::mesh
