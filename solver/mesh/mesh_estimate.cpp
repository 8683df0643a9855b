#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::mesh {
namespace {

using Line = std::vector<Point>;

/// The part of a closed line's inside where sign · (coordinate - value) >= 0. Of a concave line it keeps bridges along
/// the cut, whose area is zero.
Line half(const Line& line, int axis, double value, double sign) {
  Line kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point &a = line[i], &b = line[(i + 1) % line.size()];
    const double da = sign * (a[axis] - value), db = sign * (b[axis] - value);
    if (da >= 0.0) kept.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) kept.push_back(a + da / (da - db) * (b - a));
  }
  return kept;
}

std::vector<Line> cut(const std::vector<Line>& lines, int axis, double value, double sign) {
  std::vector<Line> kept;
  for (const Line& line : lines) {
    Line part = half(line, axis, value, sign);
    if (part.size() >= 3) kept.push_back(std::move(part));
  }
  return kept;
}

double signed_area(const std::vector<Line>& lines) {
  double area = 0.0;
  for (const Line& line : lines) area += moments(line).area;
  return area;
}

/// The body inside a box, and between which bounds ∫ dA / h² lies there.
struct Box {
  std::vector<Line> lines;
  Point low, high;
  double least, most;

  Box(std::vector<Line> body, const Point& low_corner, const Point& high_corner, const SizeField& size)
      : lines(std::move(body)), low(low_corner), high(high_corner) {
    const double area = std::max(0.0, signed_area(lines)), reach = 0.5 * (high - low).norm();
    const Point centre = 0.5 * (low + high);
    least = area / std::pow(size.at(centre, reach), 2);
    most = area / std::pow(size.at(centre, -reach), 2);
  }
  bool operator<(const Box& other) const { return most - least < other.most - other.least; }
};

/// ∫ dA / h² over the body: halves the box that is least certain until the whole is known to a third.
double density(const std::vector<Line>& lines, const SizeField& size, const Point& low, const Point& high) {
  std::vector<Box> boxes{Box(lines, low, high, size)};  // a heap
  for (;;) {
    // Summed anew: the first bounds may be many powers of ten above the last, and would leave their round-off behind.
    double least = 0.0, most = 0.0;
    for (const Box& box : boxes) {
      least += box.least;
      most += box.most;
    }
    if (most <= 1.33 * least || boxes.size() > 20000) return std::sqrt(least * most);
    for (std::size_t halvings = 1 + boxes.size() / 16; halvings > 0; --halvings) {
      std::pop_heap(boxes.begin(), boxes.end());
      const Box box = std::move(boxes.back());
      boxes.pop_back();
      const int axis = box.high.x() - box.low.x() >= box.high.y() - box.low.y() ? 0 : 1;
      const double middle = 0.5 * (box.low[axis] + box.high[axis]);
      Point below = box.high, above = box.low;
      below[axis] = above[axis] = middle;
      boxes.emplace_back(cut(box.lines, axis, middle, -1.0), box.low, below, size);
      std::push_heap(boxes.begin(), boxes.end());
      boxes.emplace_back(cut(box.lines, axis, middle, 1.0), above, box.high, size);
      std::push_heap(boxes.begin(), boxes.end());
    }
  }
}

}  // namespace

double estimated_vertices(const Outline& outline, const SizeField& size) {
  std::vector<Line> lines{outline.vertices};
  for (const Line& hole : outline.holes) {
    lines.push_back(hole);
    if (moments(hole).area > 0.0) std::reverse(lines.back().begin(), lines.back().end());
  }
  Point low = outline.vertices[0], high = low;
  for (const Point& p : outline.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  double rim = 0.0;
  for (int e = 0; e < outline.edge_count(); ++e) {
    const auto [a, b] = outline.edge(e);
    rim += pieces(a, b, size);
  }
  // A strip one triangle wide has no vertices but those of its rim.
  return std::max(rim, 2.0 / std::numbers::sqrt3 * density(lines, size, low, high) + 0.5 * rim);
}

}  // namespace sunder::mesh
