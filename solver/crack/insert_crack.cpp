#include "solver/crack/insert_crack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crack/body.hpp"
#include "solver/crack/chord.hpp"
#include "solver/crack/repair.hpp"
#include "solver/crack/tip_polygon.hpp"
#include "solver/crack/walk.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crack {
namespace {

using numerics::planted_fault;

/// Names of the boundaries that an edge belongs to.
std::vector<std::string> names_of(const mesh::PolygonMesh& mesh, const mesh::Edge& edge) {
  std::vector<std::string> names;
  for (const auto& [name, edges] : mesh.boundaries) {
    if (std::find(edges.begin(), edges.end(), edge) != edges.end()) names.push_back(name);
  }
  return names;
}

/// The vertex of the mouth: one that is there, or one that divides a boundary edge.
Front mouth_front(Cutter& cutter, const Point& mouth) {
  FaceEdge edge;
  double nearest = std::numeric_limits<double>::infinity();
  for (const FaceEdge& e : face_edges(cutter.mesh())) {
    const double d = distance_to_segment(mouth, e.from, e.to);
    if (e.crack < 0 && d < nearest) {
      nearest = d;
      edge = e;
    }
  }
  const auto [a, b] = edge.vertices;
  const Point along = edge.to - edge.from;
  const double t = along.dot(mouth - edge.from) / along.squaredNorm();
  const double reach = 1e-9 * along.norm();
  if (t * along.norm() < reach) return {a, cutter.owner(a, b)};
  if ((1.0 - t) * along.norm() < reach) return {b, cutter.owner(a, b)};
  const Point place = edge.from + t * along;
  const int polygon = cutter.owner(a, b);
  // A vertex near by slides along a straight, equally named boundary instead of leaving a short edge behind.
  for (const int v : {a, b}) {
    const Fan fan = cutter.fan(v, polygon);
    const int last = fan.polygons.back(), first = fan.polygons.front();
    const int before = cutter.previous(last, v), after = cutter.next(first, v);
    const Point u = cutter.at(v) - cutter.at(before), w = cutter.at(after) - cutter.at(v);
    if ((cutter.at(v) - place).norm() > cutter.options().snap * std::min(u.norm(), w.norm())) continue;
    if (std::abs(cross(u, w)) > 1e-9 * u.norm() * w.norm() || u.dot(w) <= 0.0) continue;
    if (names_of(cutter.mesh(), {before, v}) != names_of(cutter.mesh(), {v, after})) continue;
    cutter.slide(v, place, polygon);
    return {v, polygon};
  }
  const int x = cutter.split_edge(a, b, place);
  return {x, polygon};
}

LegEnd run_path(Cutter& cutter, int crack, Front front, std::span<const Point> targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const LegEnd end = run_leg(cutter, crack, front, {.target = targets[i], .tip = i + 1 == targets.size()});
    if (end != LegEnd::arrived) return end;
  }
  return LegEnd::arrived;
}

/// A vertex at an inner place, with at least two polygons round it on different sides of the line along `direction`.
Front middle_front(Cutter& cutter, const Point& middle, const Point& direction) {
  const int polygon = polygon_at(cutter.mesh(), middle);
  if (cutter.mesh().polygons[polygon].open) throw CutFailure("it begins in the polygon of another crack's tip");
  const std::vector<int> loop = cutter.loop(polygon);
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double d = (cutter.at(loop[k]) - middle).norm();
    if (d <= cutter.options().snap * cutter.shortest_edge(loop[k], polygon) &&
        cutter.try_move(loop[k], middle, polygon, -1)) {
      return {loop[k], polygon};
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    const int a = loop[k], b = loop[(k + 1) % n];
    const Point along = cutter.at(b) - cutter.at(a), w = middle - cutter.at(a);
    if (std::abs(cross(along, w)) > cutter.options().snap * along.squaredNorm()) continue;
    const double t = along.dot(w) / along.squaredNorm();
    if (t <= 0.0 || t >= 1.0 || cutter.owner(b, a) < 0) continue;
    const int x = cutter.split_edge(a, b, cutter.at(a) + t * along);
    if (cutter.try_move(x, middle, polygon, -1)) return {x, polygon};
  }
  // The polygon is divided by a line through the middle across the crack.
  const std::vector<Point> points = cutter.points(polygon);
  const Point across(-direction.y(), direction.x());
  struct Hit {
    int a = -1, b = -1;  ///< the edge
    Point place = Point::Zero();
    int vertex = -1;  ///< an end of the edge that does as well, being not far
  };
  const auto hit = [&](const Point& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    Hit found;
    for (std::size_t k = 0; k < n; ++k) {
      const Point a = points[k] - middle, b = points[(k + 1) % n] - middle;
      const double sa = cross(ray, a), sb = cross(ray, b);
      if ((sa > 0.0) == (sb > 0.0)) continue;
      const Point x = a + sa / (sa - sb) * (b - a);
      if (x.dot(ray) <= 0.0 || x.dot(ray) >= nearest) continue;
      nearest = x.dot(ray);
      const double reach = 0.25 * (b - a).norm();
      found = {loop[k], loop[(k + 1) % n], middle + x, -1};
      if ((x - a).norm() < reach) found.vertex = found.a;
      if ((x - b).norm() < reach) found.vertex = found.b;
    }
    if (found.a < 0) throw CutFailure("no line across the crack divides its polygon");
    return found;
  };
  Hit one = hit(across), two = hit(-across);
  const auto distance = std::abs(cutter.index_of(polygon, one.vertex < 0 ? one.a : one.vertex) -
                                 cutter.index_of(polygon, two.vertex < 0 ? two.a : two.vertex));
  if (one.vertex >= 0 && two.vertex >= 0 && (distance <= 1 || distance == static_cast<int>(n) - 1)) {
    one.vertex = two.vertex = -1;  // a corner of the polygon is cut off: its edge is no chord
  }
  const auto vertex_at = [&](const Hit& h) { return h.vertex >= 0 ? h.vertex : cutter.split_edge(h.a, h.b, h.place); };
  const int x = vertex_at(one), y = vertex_at(two);
  cutter.split_polygon(polygon, x, y);
  const int c = cutter.split_edge(x, y, middle);
  return {c, cutter.owner(c, y)};
}

/// Opens the crack at the middle of an inner crack in both directions. The two fronts are returned; a front of which
/// the target lies in the first polygon is not made: that tip is set.
void open_middle(Cutter& cutter, const Front& middle, int first, int last, std::span<const Point> to_first,
                 std::span<const Point> to_last) {
  const int c = middle.vertex;
  const auto leg = [](std::span<const Point> targets) { return Leg{.target = targets[0], .tip = targets.size() == 1}; };
  const Leg legs[2] = {leg(to_first), leg(to_last)};
  // Both ways are prepared before anything is opened. Dividing a polygon for one leaves the other's polygon whole or
  // divided beside it, so the second is looked up afterwards.
  const Step one = next_step(cutter, middle, legs[0]);
  Front again{c, one.vertex >= 0 ? cutter.owner(c, one.vertex) : one.polygon};
  const Step two = next_step(cutter, again, legs[1]);
  if (one.on_face || two.on_face) throw CutFailure("an inner crack meets a face");
  if (one.vertex < 0 && two.vertex < 0 && one.polygon == two.polygon) {
    throw CutFailure("both halves of an inner crack begin in one polygon");
  }
  // Polygons on the left of the way to the first tip, from that way round to the other: they get the new vertex.
  std::vector<int> round;
  int p = one.vertex >= 0 ? cutter.owner(c, one.vertex) : cutter.owner(c, cutter.previous(one.polygon, c));
  const bool none = one.vertex < 0 && two.vertex >= 0 && cutter.previous(one.polygon, c) == two.vertex;
  while (!none) {
    if (two.vertex < 0 && p == two.polygon) break;
    round.push_back(p);
    if (two.vertex >= 0 && cutter.previous(p, c) == two.vertex) break;
    p = cutter.owner(c, cutter.previous(p, c));
    if (p < 0 || round.size() > cutter.mesh().polygons.size()) throw CutFailure("an inner crack meets a face");
  }
  const int twin = cutter.double_vertex(c, round);
  cutter.faces(first).lower.push_back(c);
  cutter.faces(first).upper.push_back(twin);
  cutter.faces(last).lower.push_back(twin);
  cutter.faces(last).upper.push_back(c);
  Front front_one{one.vertex, -1}, front_two{two.vertex, -1};
  if (one.vertex < 0) {
    front_one = {cutter.add_spike(one.polygon, c, legs[0].target, twin, c), one.polygon};
  } else {
    front_one.polygon = cutter.owner(one.vertex, c);
  }
  if (two.vertex < 0) {
    front_two = {cutter.add_spike(two.polygon, c, legs[1].target, c, twin), two.polygon};
  } else {
    front_two.polygon = cutter.owner(two.vertex, twin);
  }
  const auto go_on = [&](int crack, const Step& step, const Front& front, std::span<const Point> targets) {
    const bool there = step.vertex < 0 || step.at_target;
    if (there && targets.size() == 1) {
      cutter.set_tip(crack, front.vertex);
      return;
    }
    if (run_path(cutter, crack, front, there ? targets.subspan(1) : targets) != LegEnd::arrived) {
      throw CutFailure("an inner crack meets a face");
    }
  };
  go_on(first, one, front_one, to_first);
  go_on(last, two, front_two, to_last);
}

void cut_inner(Cutter& cutter, const CrackPath& path) {
  const std::vector<Point>& p = path.points;
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) length += (p[i + 1] - p[i]).norm();
  std::size_t i = 0;
  double before = 0.0;
  while (i + 2 < p.size() && before + (p[i + 1] - p[i]).norm() < 0.5 * length) before += (p[i + 1] - p[i]).norm(), ++i;
  const Point d = (p[i + 1] - p[i]).normalized();
  const Point middle = p[i] + (0.5 * length - before) * d;
  std::vector<Point> to_first(p.begin(), p.begin() + i + 1), to_last(p.begin() + i + 1, p.end());
  std::reverse(to_first.begin(), to_first.end());
  // A kink in the middle is the middle.
  if ((middle - to_last.front()).norm() < 1e-9 * length && to_last.size() > 1) to_last.erase(to_last.begin());
  if ((middle - to_first.front()).norm() < 1e-9 * length && to_first.size() > 1) to_first.erase(to_first.begin());
  const Front front = middle_front(cutter, middle, d);
  const int first = cutter.add_crack(), last = cutter.add_crack();
  open_middle(cutter, front, first, last, to_first, to_last);
}

void cut_path(Cutter& cutter, const CrackPath& path) {
  if (path.inner) {
    cut_inner(cutter, path);
  } else {
    const Front front = mouth_front(cutter, path.points.front());
    const int crack = cutter.add_crack();
    if (run_path(cutter, crack, front, std::span(path.points).subspan(1)) != LegEnd::arrived) {
      throw CutFailure("it meets a face on its way");
    }
  }
  for (int c = 0; c < static_cast<int>(cutter.mesh().cracks.size()); ++c) {
    if (cutter.tip_vertex(c) >= 0) shape_tip(cutter, c);
  }
  repair_pieces(cutter);
}

}  // namespace

CutReport insert_crack(mesh::PolygonMesh& mesh, const CrackPath& path, int number, const CutOptions& options) {
  check_path(mesh, path, number);
  std::string reason;
  for (const double factor : clearance_attempts) {
    mesh::PolygonMesh result = mesh;
    CutOptions attempt = options;
    attempt.tip_clearance *= factor;
    try {
      Cutter cutter(result, attempt);
      cut_path(cutter, path);
      CutReport report = cutter.finish();
      if (planted_fault("crack/faces-swapped")) {
        for (std::size_t c = mesh.cracks.size(); c < result.cracks.size(); ++c) {
          std::swap(result.cracks[c].lower, result.cracks[c].upper);
        }
      }
      mesh = std::move(result);
      return report;
    } catch (const CutFailure& failure) {
      if (reason.empty()) reason = failure.what();
    }
  }
  throw CrackError("crack " + std::to_string(number + 1) + ": cannot be cut into this mesh: " + reason);
}

}  // namespace sunder::crack
