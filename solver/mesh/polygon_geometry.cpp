#include "solver/mesh/polygon_geometry.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/words.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::mesh {
namespace {

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A half-plane normal·x >= offset, normal of unit length.
struct HalfPlane {
  Point normal;
  double offset;

  double distance(const Point& x) const { return normal.dot(x) - offset; }
};

/// The polygon in the frame where its second moments are those of the unit disc (area π, second moments π/4):
/// x = origin + rotation · lower · y with lower lowerᵀ = 4 second / area in axes along the longest edge.
struct NormalFrame {
  Point origin;
  Eigen::Matrix2d rotation, lower;
  std::vector<HalfPlane> sides;
  bool sound = false;  ///< false: no area, or no finite numbers

  Point to(const Point& x) const {
    return lower.triangularView<Eigen::Lower>().solve(rotation.transpose() * (x - origin));
  }
  Point from(const Point& y) const { return origin + rotation * (lower * y); }
};

/// The lines of the first `edges` edges are the sides; the others (the faces of a crack) only enclose the area.
NormalFrame normal_frame(std::span<const Point> points, std::size_t edges) {
  NormalFrame f;
  const std::size_t n = points.size();
  Point longest = Point::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Point along = points[(i + 1) % n] - points[i];
    if (along.squaredNorm() > longest.squaredNorm()) longest = along;
  }
  if (!(longest.norm() > 0.0) || !longest.allFinite()) return f;
  longest.normalize();
  // The thin direction of a sliver has to be an axis before its moments are formed, or they drown in the long one's.
  f.rotation << longest.x(), -longest.y(), longest.y(), longest.x();
  std::vector<Point> mapped(n);
  for (std::size_t i = 0; i < n; ++i) mapped[i] = f.rotation.transpose() * (points[i] - points[0]);
  const Moments m = moments(mapped);
  if (!(m.area > 0.0)) return f;
  const Eigen::LLT<Eigen::Matrix2d> factor(4.0 / m.area * m.second);
  if (factor.info() != Eigen::Success) return f;
  f.lower = factor.matrixL();
  f.origin = points[0] + f.rotation * m.centroid;
  for (Point& p : mapped) p = f.lower.triangularView<Eigen::Lower>().solve(p - m.centroid);
  f.sides.reserve(edges);
  for (std::size_t i = 0; i < edges; ++i) {
    const Point& a = mapped[i];
    const Point along = mapped[(i + 1) % n] - a;
    const double length = along.norm();
    if (!(length > 0.0)) return f;
    const Point normal(-along.y() / length, along.x() / length);
    f.sides.push_back({normal, normal.dot(a)});
  }
  f.sound = f.lower.allFinite() && f.origin.allFinite();
  return f;
}

/// Cuts off what lies on the wrong side. `region` is convex and counter-clockwise.
void clip(std::vector<Point>& region, std::vector<Point>& scratch, const HalfPlane& half, double shift) {
  scratch.clear();
  const std::size_t n = region.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = region[i], &b = region[(i + 1) % n];
    const double da = half.distance(a) - shift, db = half.distance(b) - shift;
    if (da >= 0.0) scratch.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) scratch.push_back(a + da / (da - db) * (b - a));
  }
  region.swap(scratch);
}

/// Points at least `shift` inside every side.
std::vector<Point> inset(const NormalFrame& f, double shift) {
  // From a point of the kernel the polygon holds the whole cone over itself, so a kernel far from the origin would need
  // more than the unit disc's area: 64 radii are out of reach.
  constexpr double reach = 64.0;
  std::vector<Point> region = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, scratch;
  for (const HalfPlane& side : f.sides) {
    clip(region, scratch, side, shift);
    if (region.empty()) break;
  }
  return region;
}

double clearance_in(const NormalFrame& f, const Point& y) {
  double least = std::numeric_limits<double>::infinity();
  for (const HalfPlane& side : f.sides) least = std::min(least, side.distance(y));
  return least;
}

Point mean(const std::vector<Point>& points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

Moments moments(std::span<const Point> points) {
  Moments m{0.0, Point::Zero(), Eigen::Matrix2d::Zero()};
  if (points.empty()) return m;
  Point first = Point::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  const Point o = points[0];
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Point a = points[i] - o, b = points[i + 1] - o;
    const double twice = cross(a, b);
    m.area += 0.5 * twice;
    first += twice / 6.0 * (a + b);
    second += twice / 24.0 * (a * a.transpose() + b * b.transpose() + (a + b) * (a + b).transpose());
  }
  if (m.area == 0.0) {
    m.centroid = mean({points.begin(), points.end()});
    return m;
  }
  const Point c = first / m.area;
  m.centroid = o + c;
  m.second = second - m.area * c * c.transpose();
  return m;
}

std::vector<Point> closed_line(const PolygonMesh& mesh, int polygon) {
  const Polygon& p = mesh.polygons[polygon];
  std::vector<Point> line;
  line.reserve(p.vertices.size() + 1);
  for (const int v : p.vertices) line.push_back(mesh.vertices[v]);
  if (p.open) line.push_back(p.scaling_centre);
  return line;
}

std::vector<Point> kernel(std::span<const Point> points) {
  const NormalFrame f = normal_frame(points, points.size());
  if (!f.sound) return {};
  std::vector<Point> region = inset(f, 0.0);
  for (Point& y : region) y = f.from(y);
  return region;
}

double clearance(std::span<const Point> points, const Point& centre, bool open) {
  std::vector<Point> line(points.begin(), points.end());
  if (open) line.push_back(centre);
  const NormalFrame f = normal_frame(line, open ? line.size() - 2 : line.size());
  return f.sound && centre.allFinite() ? clearance_in(f, f.to(centre)) : 0.0;
}

ScalingCentre scaling_centre(std::span<const Point> points, double enough) {
  const NormalFrame f = normal_frame(points, points.size());
  if (!f.sound) return {points.empty() ? Point::Zero() : points[0], 0.0};
  const double at_centroid = clearance_in(f, Point::Zero());
  if (at_centroid >= enough || numerics::planted_fault("mesh/scaling-centre-outside")) return {f.origin, at_centroid};

  // The largest inset that is not empty, by bisection: needs no pivoting rule, and a whole segment of best points (a
  // long trapezium) shrinks to its middle.
  if (inset(f, 0.0).empty()) return {f.origin, std::min(at_centroid, 0.0)};
  double low = 0.0, high = 1.0;  // no clearance exceeds the disc's
  for (int i = 0; i < 44; ++i) {
    const double middle = 0.5 * (low + high);
    (inset(f, middle).empty() ? high : low) = middle;
  }
  const Point best = mean(inset(f, low));
  return {f.from(best), clearance_in(f, best)};
}

Point chosen_centre(const PolygonMesh& mesh, int polygon) {
  const std::vector<Point> line = closed_line(mesh, polygon);
  const ScalingCentre centre = line.size() < 3 ? ScalingCentre{} : scaling_centre(line);
  if (centre.clearance > smallest_clearance || numerics::planted_fault("mesh/scaling-centre-outside")) {
    return centre.point;
  }
  const std::string name =
      "polygon " + std::to_string(polygon) +
      (line.empty() ? std::string()
                    : " with vertex " + std::to_string(mesh.polygons[polygon].vertices[0]) + " at " + place(line[0]));
  if (line.size() < 3)
    throw MeshError(name + " has " + std::to_string(line.size()) + " vertices; at least 3 are needed");
  const double area = moments(line).area;
  if (area < 0.0) throw MeshError(name + " runs clockwise; write its vertices counter-clockwise");
  if (!(area > 0.0)) throw MeshError(name + " has the area " + number(area) + " m²; it must be positive");
  throw MeshError(name +
                  " is not star-shaped: no point inside sees its whole boundary; divide it into polygons that are");
}

}  // namespace sunder::mesh
