#include "solver/crack/chord.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/mesh/polygon_geometry.hpp"

namespace sunder::crack {
namespace {

/// True where the direction points into the polygon's corner at loop[k], by more than about 0.5 degrees.
bool points_inside(std::span<const Point> loop, int k, const Point& direction) {
  constexpr double full = 2.0 * std::numbers::pi, margin = 0.01;
  const int n = static_cast<int>(loop.size());
  const Point after = loop[(k + 1) % n] - loop[k], before = loop[(k + n - 1) % n] - loop[k];
  const auto turn = [&](const Point& b) {
    const double angle = std::atan2(cross(after, b), after.dot(b));
    return angle < 0.0 ? angle + full : angle;
  };
  double corner = turn(before);
  if (corner < 1e-9) corner = full;  // a spike's tip
  const double angle = turn(direction);
  return angle > margin && angle < corner - margin;
}

/// True where segments p-q and a-b meet, the ends of a-b included with a margin, but not where a or b is p or q in
/// place.
bool meet(const Point& p, const Point& q, const Point& a, const Point& b) {
  const Point d = q - p;
  const double scale = d.norm(), tolerance = 1e-9 * scale;
  const double sa = cross(d, a - p) / scale, sb = cross(d, b - p) / scale;
  if ((sa > tolerance && sb > tolerance) || (sa < -tolerance && sb < -tolerance)) return false;
  const auto between = [&](const Point& x) {
    const double t = (x - p).dot(d) / scale;
    return t > tolerance && t < scale - tolerance;
  };
  if (std::abs(sa) <= tolerance && between(a)) return true;
  if (std::abs(sb) <= tolerance && between(b)) return true;
  if (std::abs(sa) <= tolerance || std::abs(sb) <= tolerance) return false;
  return between(a + sa / (sa - sb) * (b - a));
}

bool is_free(std::span<const Point> loop, int from, const Point& to, int to_edge, int to_vertex) {
  const int n = static_cast<int>(loop.size());
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    if (k == from || l == from || k == to_edge || k == to_vertex || l == to_vertex) continue;
    if (meet(loop[from], to, loop[k], loop[l])) return false;
  }
  return true;
}

}  // namespace

std::vector<Chord> chords_from(std::span<const Point> loop, int from) {
  std::vector<Chord> chords;
  const int n = static_cast<int>(loop.size());
  for (int k = 0; k < n; ++k) {
    const Point way = loop[k] - loop[from];
    const bool neighbour = k == from || (k + 1) % n == from || (from + 1) % n == k;
    if (!neighbour && way.squaredNorm() > 0.0 && points_inside(loop, from, way) && points_inside(loop, k, -way) &&
        is_free(loop, from, loop[k], -1, k)) {
      chords.push_back({from, k, 0.0});
    }
    if (k == from || (k + 1) % n == from) continue;
    const Point middle = 0.5 * (loop[k] + loop[(k + 1) % n]);
    if (points_inside(loop, from, middle - loop[from]) && is_free(loop, from, middle, k, -1)) {
      chords.push_back({from, k, 0.5});
    }
  }
  return chords;
}

std::vector<Chord> chords_along(std::span<const Point> loop, int from, std::span<const Point> directions) {
  std::vector<Chord> chords;
  const int n = static_cast<int>(loop.size());
  for (const Point& direction : directions) {
    if (!points_inside(loop, from, direction)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    Chord chord;
    for (int k = 0; k < n; ++k) {
      const int l = (k + 1) % n;
      if (k == from || l == from) continue;
      const Point a = loop[k] - loop[from], b = loop[l] - loop[from];
      const double sa = cross(direction, a), sb = cross(direction, b);
      if ((sa > 0.0) == (sb > 0.0)) continue;
      const double along = sa / (sa - sb), distance = (a + along * (b - a)).dot(direction);
      if (distance <= 0.0 || distance >= nearest) continue;
      nearest = distance;
      chord = {from, k, along};
    }
    // Near the end of an edge there is a vertex, to which chords_from() goes.
    if (chord.from >= 0 && chord.along > 0.1 && chord.along < 0.9) chords.push_back(chord);
  }
  return chords;
}

Point end_of(std::span<const Point> loop, const Chord& chord) {
  return loop[chord.to] + chord.along * (loop[(chord.to + 1) % loop.size()] - loop[chord.to]);
}

std::array<std::vector<Point>, 2> parts(std::span<const Point> loop, const Chord& chord) {
  const int n = static_cast<int>(loop.size());
  std::vector<Point> left, right;
  const Point end = end_of(loop, chord);
  left.push_back(loop[chord.from]);
  left.push_back(end);
  for (int k = (chord.to + 1) % n; k != chord.from; k = (k + 1) % n) left.push_back(loop[k]);
  for (int k = chord.from; k != chord.to; k = (k + 1) % n) right.push_back(loop[k]);
  if (chord.along > 0.0) right.push_back(loop[chord.to]);
  right.push_back(end);
  return {std::move(left), std::move(right)};
}

double thickness(std::span<const Point> loop) {
  // The width in the widest of eight directions is the diameter to 2 %.
  double diameter = 0.0;
  for (int k = 0; k < 8; ++k) {
    const Point direction(std::cos(k * std::numbers::pi / 8), std::sin(k * std::numbers::pi / 8));
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& p : loop) {
      const double x = direction.dot(p - loop[0]);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    diameter = std::max(diameter, high - low);
  }
  return diameter > 0.0 ? mesh::moments(loop).area / diameter : 0.0;
}

double shape_quality(std::span<const Point> loop, double at_least) {
  if (loop.size() < 3) return 0.0;
  const double area = mesh::moments(loop).area;
  if (!(area > 0.0)) return 0.0;
  const double t = thickness(loop), fullness = std::min(2.0 * t * t / area, 1.0);
  if (fullness <= at_least) return 0.0;
  return std::clamp(mesh::scaling_centre(loop, 0.15).clearance, 0.0, fullness);
}

int cut(Cutter& cutter, int polygon, const Chord& chord) {
  const std::vector<int> v = cutter.loop(polygon);
  const int a = v[chord.to], b = v[(chord.to + 1) % v.size()];
  const int end =
      chord.along > 0.0 ? cutter.split_edge(a, b, cutter.at(a) + chord.along * (cutter.at(b) - cutter.at(a))) : a;
  return cutter.split_polygon(polygon, v[chord.from], end);
}

}  // namespace sunder::crack
