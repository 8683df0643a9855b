#include "solver/mesh/segments.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::mesh {

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm();
}

double twice_area(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d, double tolerance) {
  if (std::max(a.x(), b.x()) + tolerance < std::min(c.x(), d.x()) ||
      std::max(c.x(), d.x()) + tolerance < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) + tolerance < std::min(c.y(), d.y()) ||
      std::max(c.y(), d.y()) + tolerance < std::min(a.y(), b.y())) {
    return false;
  }
  if (twice_area(c, d, a) * twice_area(c, d, b) < 0.0 && twice_area(a, b, c) * twice_area(a, b, d) < 0.0) return true;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)}) <= tolerance;
}

bool inside(const Point& p, const std::vector<Point>& line) {
  bool in = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
    const Point &a = line[i], &b = line[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      in = !in;
    }
  }
  return in;
}

}  // namespace sunder::mesh
