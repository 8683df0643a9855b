#include "solver/crack/walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::crack {
namespace {

using numerics::planted_fault;

/// Vertices this close to the path, as a fraction of their shortest edge, are taken to lie on it.
constexpr double on_path = 1e-9;

/// Angle from a to b, counter-clockwise, in [0, 2π).
double turn(const Point& a, const Point& b) {
  const double angle = std::atan2(cross(a, b), a.dot(b));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// How far inside the corner of `polygon` at the front's vertex the direction points [rad]; negative: outside.
double depth(const Cutter& cutter, int polygon, int vertex, const Point& direction) {
  constexpr double full = 2.0 * std::numbers::pi;
  const Point after = cutter.at(cutter.next(polygon, vertex)) - cutter.at(vertex);
  const Point before = cutter.at(cutter.previous(polygon, vertex)) - cutter.at(vertex);
  double corner = turn(after, before);
  if (corner < 1e-9) corner = full;  // a spike: both faces leave in one direction
  const double angle = turn(after, direction);
  return angle <= corner ? std::min(angle, corner - angle) : -std::min(angle - corner, full - angle);
}

int polygon_towards(const Cutter& cutter, const Front& front, const Point& direction) {
  int best = -1;
  double deepest = -1e-9;  // along an edge, round-off may put the direction outside on both its sides
  for (const int p : cutter.fan(front.vertex, front.polygon).polygons) {
    const double d = depth(cutter, p, front.vertex, direction);
    if (d > deepest) {
      deepest = d;
      best = p;
    }
  }
  if (best < 0) throw CutFailure("the crack does not lead into the body");
  return best;
}

struct Exit {
  double distance = std::numeric_limits<double>::infinity();
  int a = -1, b = -1;  ///< the edge crossed
  Point place = Point::Zero();
};

/// Where the ray from the front leaves the polygon.
Exit exit_of(const Cutter& cutter, int polygon, int vertex, const Point& direction) {
  const std::vector<int>& v = cutter.loop(polygon);
  const int n = static_cast<int>(v.size());
  const Point from = cutter.at(vertex);
  Exit exit;
  for (int k = 0; k < n; ++k) {
    const int a = v[k], b = v[(k + 1) % n];
    if (a == vertex || b == vertex) continue;
    const Point wa = cutter.at(a) - from, wb = cutter.at(b) - from;
    const double sa = cross(direction, wa), sb = cross(direction, wb);
    if ((sa > 0.0) == (sb > 0.0)) continue;
    const Point place = wa + sa / (sa - sb) * (wb - wa);
    const double distance = place.dot(direction);
    if (distance > 0.0 && distance < exit.distance) exit = {distance, a, b, from + place};
  }
  return exit;
}

struct NearVertex {
  int vertex = -1;
  double distance = std::numeric_limits<double>::infinity();  ///< along the leg
  bool on_face = false;
  bool at_target = false;
};

/// The first vertex on the leg, moved onto it where it was only near.
NearVertex vertex_on_way(Cutter& cutter, int polygon, int front, const Leg& leg, const Exit& exit) {
  const Point from = cutter.at(front), way = leg.target - from;
  const double length = way.norm();
  const Point direction = way / length;
  struct Candidate {
    double distance, aside, tolerance;
    int vertex;
  };
  std::vector<Candidate> candidates;
  for (const int v : cutter.loop(polygon)) {
    if (v == front) continue;
    const Point w = cutter.at(v) - from;
    const double distance = w.dot(direction), aside = std::abs(cross(direction, w));
    const bool exit_end = v == exit.a || v == exit.b;
    if (distance <= 0.0 || (distance > exit.distance && !exit_end)) continue;
    if (aside > cutter.options().snap * w.norm()) continue;  // well aside, seen from the front
    const double tolerance = cutter.options().snap * cutter.shortest_edge(v, polygon);
    if (aside > tolerance) continue;
    if (leg.tip ? distance > length - tolerance : distance > length + tolerance) continue;
    candidates.push_back({distance, aside, tolerance, v});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& x, const Candidate& y) { return x.distance < y.distance; });
  for (const Candidate& c : candidates) {
    const bool inner = cutter.fan(c.vertex, polygon).closed;
    const bool at_target = !leg.tip && std::abs(c.distance - length) <= c.tolerance;
    const Point place = at_target ? leg.target : Point(from + c.distance * direction);
    if (inner && cutter.try_move(c.vertex, place, polygon, polygon)) {
      return {c.vertex, c.distance, false, at_target};
    }
    // A vertex that has to stay: the path goes over it only where it lies on the path anyway.
    if (c.aside > on_path / cutter.options().snap * c.tolerance) continue;
    return {c.vertex, c.distance, !inner, false};
  }
  return {};
}

/// Vertex for the place where the leg comes out at a face: an end of that edge where it is near, else a new vertex.
int face_vertex(Cutter& cutter, const Exit& exit) {
  const double reach = cutter.options().snap * (cutter.at(exit.b) - cutter.at(exit.a)).norm();
  if ((exit.place - cutter.at(exit.a)).norm() < reach) return exit.a;
  if ((exit.place - cutter.at(exit.b)).norm() < reach) return exit.b;
  return cutter.split_edge(exit.a, exit.b, exit.place);
}

/// A kink close to an edge of the polygon is put on it. Returns the new vertex, -1 where there is no such edge or it
/// cannot be bent that far.
int kink_on_edge(Cutter& cutter, int polygon, const Exit& exit, const Point& from, const Point& kink) {
  const std::vector<int> loop = cutter.loop(polygon);
  const bool beyond = (kink - from).norm() > exit.distance;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int a = loop[k], b = loop[(k + 1) % loop.size()];
    if (cutter.owner(b, a) < 0 || (beyond && a != exit.a)) continue;
    const Point edge = cutter.at(b) - cutter.at(a), w = kink - cutter.at(a);
    const double along = edge.dot(w) / edge.squaredNorm();
    if (std::abs(cross(edge, w)) > cutter.options().snap * edge.squaredNorm() || along <= 0.0 || along >= 1.0) continue;
    const int x = cutter.split_edge(a, b, cutter.at(a) + along * edge);
    if (cutter.try_move(x, kink, polygon, polygon)) return x;
    cutter.remove_vertex(cutter.owner(x, a), x);
    cutter.remove_vertex(polygon, x);
  }
  return -1;
}

bool straight_on(const Cutter& cutter, const mesh::CrackFaces& faces, int vertex, const Point& to) {
  if (faces.lower.empty()) return false;
  const Point back = cutter.at(vertex) - cutter.at(faces.lower.back()), ahead = to - cutter.at(vertex);
  return back.dot(ahead) > 0.0 && std::abs(cross(back, ahead)) <= 1e-9 * back.norm() * ahead.norm();
}

bool is_spike(const Cutter& cutter, const mesh::CrackFaces& faces, const Front& front) {
  return !faces.lower.empty() && cutter.owner(front.vertex, faces.lower.back()) >= 0 &&
         cutter.owner(front.vertex, faces.lower.back()) == cutter.owner(faces.upper.back(), front.vertex);
}

void push_pair(mesh::CrackFaces& faces, int lower, int upper) {
  faces.lower.push_back(lower);
  faces.upper.push_back(upper);
}

/// Polygons round `vertex` from `left` on, turning away from the crack's path.
std::vector<int> behind(const Cutter& cutter, int vertex, int left) {
  std::vector<int> polygons{left};
  for (int p = cutter.owner(vertex, cutter.previous(left, vertex)); p >= 0;
       p = cutter.owner(vertex, cutter.previous(p, vertex))) {
    if (p == left) throw CutFailure("the crack meets its own path");
    polygons.push_back(p);
  }
  return polygons;
}

std::vector<int> ahead(const Cutter& cutter, int vertex, int left) {
  std::vector<int> polygons{left};
  for (int p = cutter.owner(cutter.next(left, vertex), vertex); p >= 0;
       p = cutter.owner(cutter.next(p, vertex), vertex)) {
    if (p == left) throw CutFailure("the crack meets its own path");
    polygons.push_back(p);
  }
  return polygons;
}

/// Opens the crack along the edge from the front to `to`.
void open_edge(Cutter& cutter, int crack, Front& front, int to, bool from_spike) {
  const int f = front.vertex;
  const int left = cutter.owner(f, to), right = cutter.owner(to, f);
  if (left < 0 || right < 0) throw CutFailure("the crack runs along a face");
  mesh::CrackFaces& faces = cutter.faces(crack);
  const bool needless = from_spike && straight_on(cutter, faces, f, cutter.at(to));
  if (faces.lower.empty() && planted_fault("crack/mouth-not-doubled")) {
    push_pair(faces, f, f);
  } else {
    const int twin = cutter.double_vertex(f, behind(cutter, f, left));
    if (needless) {  // a former tip on a straight crack: its polygon is now divided without it
      cutter.remove_vertex(left, twin);
      cutter.remove_vertex(right, f);
    } else {
      push_pair(cutter.faces(crack), f, twin);
    }
  }
  front = {to, right};
}

/// Opens the crack into the polygon, up to `to`.
void open_inside(Cutter& cutter, int crack, Front& front, int polygon, const Point& to) {
  mesh::CrackFaces& faces = cutter.faces(crack);
  const int f = front.vertex;
  if (is_spike(cutter, faces, front) && straight_on(cutter, faces, f, to)) {
    cutter.move_tip(f, to);
    return;
  }
  int twin = f;
  if (!(faces.lower.empty() && planted_fault("crack/mouth-not-doubled"))) {
    std::vector<int> others = behind(cutter, f, polygon);
    others.erase(others.begin());
    // A boundary edge of the polygon itself is renamed by add_spike.
    twin = cutter.double_vertex(f, others);
  }
  push_pair(faces, f, twin);
  const int tip = cutter.add_spike(polygon, f, to, twin, f);
  front = {tip, polygon};
}

}  // namespace

Step next_step(Cutter& cutter, const Front& front, const Leg& leg) {
  const Point from = cutter.at(front.vertex), way = leg.target - from;
  const double length = way.norm();
  const Point direction = way / length;
  const int polygon = polygon_towards(cutter, front, direction);
  if (cutter.mesh().polygons[polygon].open) {
    for (int c = 0; c < static_cast<int>(cutter.mesh().cracks.size()); ++c) {
      if (cutter.mesh().cracks[c].tip_polygon == polygon) cutter.reopen(c);
    }
  }
  const Exit exit = exit_of(cutter, polygon, front.vertex, direction);
  Step step{.polygon = polygon};
  const NearVertex near = vertex_on_way(cutter, polygon, front.vertex, leg, exit);
  if (near.vertex >= 0) {
    step.vertex = near.vertex;
    step.at_target = near.at_target;
    step.on_face = near.on_face;
    if (step.on_face) {
      const int v = near.vertex;
      step.face_crack = std::max(cutter.crack_of_edge(v, cutter.next(polygon, v)),
                                 cutter.crack_of_edge(cutter.previous(polygon, v), v));
    }
  } else if (exit.a < 0) {
    // The leg runs along an edge, so that round-off sees no crossing, and ends before that edge does.
    if (leg.tip) return step;
    step.vertex = kink_on_edge(cutter, polygon, exit, from, leg.target);
    step.at_target = true;
    if (step.vertex < 0) throw CutFailure("the crack does not leave a polygon it has entered");
  } else {
    const bool face_ahead = cutter.owner(exit.b, exit.a) < 0;
    // A tip just beyond an edge needs no cut through it where shape_tip() may join the polygon there.
    const int beyond = cutter.owner(exit.b, exit.a);
    const auto& polygons = cutter.mesh().polygons;
    const bool one_body =
        beyond >= 0 && !polygons[beyond].open && polygons[beyond].material == polygons[polygon].material;
    const double slack = one_body ? cutter.options().snap * (cutter.at(exit.b) - cutter.at(exit.a)).norm() : 0.0;
    const double ending = leg.end_clearance * std::sqrt(std::abs(cutter.area(polygon)));
    if (leg.tip && length <= exit.distance + (face_ahead ? -ending : slack)) return step;
    if (!leg.tip) {
      step.vertex = kink_on_edge(cutter, polygon, exit, from, leg.target);
      step.at_target = step.vertex >= 0;
    }
    if (!step.at_target) {
      if (!leg.tip && length < exit.distance) return step;
      step.on_face = face_ahead;
      if (face_ahead) step.face_crack = cutter.crack_of_edge(exit.a, exit.b);
      step.vertex = face_ahead ? face_vertex(cutter, exit) : cutter.split_edge(exit.a, exit.b, exit.place);
    }
  }
  const int v = step.vertex;
  if (cutter.next(polygon, front.vertex) != v && cutter.previous(polygon, front.vertex) != v) {
    cutter.split_polygon(polygon, front.vertex, v);
  }
  return step;
}

LegEnd run_leg(Cutter& cutter, int crack, Front& front, const Leg& leg) {
  const std::size_t most_steps = 16 * cutter.mesh().vertices.size() + 64;
  for (std::size_t count = 0; count < most_steps; ++count) {
    const bool from_spike = is_spike(cutter, cutter.faces(crack), front);  // before its polygon is divided
    const Step step = next_step(cutter, front, leg);
    if (step.vertex < 0) {
      open_inside(cutter, crack, front, step.polygon, leg.target);
      if (leg.tip) cutter.set_tip(crack, front.vertex);
      return LegEnd::arrived;
    }
    open_edge(cutter, crack, front, step.vertex, from_spike);
    if (step.on_face) {
      const mesh::CrackFaces& faces = cutter.faces(crack);
      const int left = cutter.owner(faces.upper.back(), front.vertex);
      const int twin = cutter.double_vertex(front.vertex, ahead(cutter, front.vertex, left));
      push_pair(cutter.faces(crack), front.vertex, twin);
      return step.face_crack < 0 ? LegEnd::reached_boundary : LegEnd::reached_crack;
    }
    if (step.at_target) return LegEnd::arrived;
  }
  throw CutFailure("the crack does not arrive");
}

}  // namespace sunder::crack
