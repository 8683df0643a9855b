#include "solver/crack/crack_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "solver/crack/body.hpp"
#include "solver/crack/cutter.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crack {
namespace {

std::string number_words(double x) {
  std::ostringstream text;
  text.precision(6);
  text << x;
  return text.str();
}

struct Check {
  const mesh::PolygonMesh& mesh;
  const CrackPath& path;
  const std::vector<FaceEdge> body;
  const double size;
  const std::string name;

  [[noreturn]] void refuse(const std::string& what) const { throw CrackError(name + ": " + what); }
  std::string words(const Point& p) const {
    std::ostringstream text;
    text.precision(9);
    const auto shown = [&](double x) { return std::abs(x) < 1e-12 * size ? 0.0 : x; };
    text << '(' << shown(p.x()) << ", " << shown(p.y()) << ')';
    return text.str();
  }

  void points() const {
    if (path.points.size() < 2) {
      refuse("the path has " + std::to_string(path.points.size()) + " points; at least 2 are needed");
    }
    for (const Point& p : path.points) {
      if (!p.allFinite()) refuse("the path has a point that is no finite number");
    }
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
      const double length = (path.points[i + 1] - path.points[i]).norm();
      if (!(length > 1e-9 * size)) {
        refuse("the segment from " + words(path.points[i]) + " to " + words(path.points[i + 1]) + " has the length " +
               number_words(length) + " m; it must be longer than " + number_words(1e-9 * size) + " m");
      }
    }
  }

  void mouth() const {
    const Point& m = path.points.front();
    const double reach = 1e-6 * size;
    const FaceEdge* edge = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const FaceEdge& e : body) {
      const double d = distance_to_segment(m, e.from, e.to);
      if (d < nearest) {
        nearest = d;
        edge = &e;
      }
    }
    if (edge == nullptr || nearest > reach) {
      const bool in = inside(body, m);
      refuse("the mouth " + words(m) + " lies " + std::string(in ? "inside" : "outside") + " the body, " +
             number_words(nearest) + " m from its boundary; it must lie on the boundary" +
             (in ? " (an inner crack says so: both its ends are tips)" : ""));
    }
    if (edge->crack >= 0) {
      refuse("the mouth " + words(m) + " lies on a face of another crack; it must lie on the outer boundary");
    }
    for (const FaceEdge& e : body) {
      if ((e.to - m).norm() > reach) continue;
      for (const FaceEdge& after : body) {
        if (after.vertices[0] != e.vertices[1]) continue;
        const Point u = e.to - e.from, v = after.to - after.from;
        if (std::abs(cross(u, v)) > 1e-6 * u.norm() * v.norm() || u.dot(v) < 0.0) {
          refuse("the mouth " + words(m) +
                 " lies on a corner of the body; it must lie on a straight part of the boundary");
        }
      }
    }
  }

  /// Segment i against the boundary and the cracks.
  void segment_inside(std::size_t i) const {
    const Point &p = path.points[i], &q = path.points[i + 1];
    const bool from_mouth = i == 0 && !path.inner;
    const double reach = 1e-9 * size;
    // The mouth may stand off the boundary by what mouth() allows: the path is looked at from there on.
    const double length = (q - p).norm();
    const double start = from_mouth ? std::min(2e-6 * size / length, 0.5) : 0.0;
    const Point begin = p + start * (q - p);
    for (const FaceEdge& e : body) {
      if (!segments_meet(begin, q, e.from, e.to, reach)) continue;
      const Point d = q - p, u = e.to - e.from;
      const double parallel = cross(d, u);
      const Point place =
          std::abs(parallel) > 1e-12 * d.norm() * u.norm() ? Point(p + cross(e.from - p, u) / parallel * d) : q;
      if (e.crack >= 0) {
        refuse("the segment from " + words(p) + " to " + words(q) + " meets crack " + std::to_string(e.crack + 1) +
               " of the mesh at " + words(place) + "; cracks must not touch");
      }
      refuse("the segment from " + words(p) + " to " + words(q) + " meets the boundary of the body at " + words(place) +
             "; the crack must stay inside");
    }
    if (!inside(body, 0.5 * (begin + q))) {
      refuse("the segment from " + words(p) + " to " + words(q) + " runs outside the body; the crack must stay inside");
    }
  }

  void self() const {
    const auto& p = path.points;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      if (i + 2 < p.size()) {
        const Point u = p[i + 1] - p[i], v = p[i + 2] - p[i + 1];
        if (u.dot(v) < 0.0 && std::abs(cross(u, v)) <= 1e-6 * u.norm() * v.norm()) {
          refuse("the path turns back on itself at " + words(p[i + 1]));
        }
      }
      for (std::size_t k = i + 2; k + 1 < p.size(); ++k) {
        if (segments_meet(p[i], p[i + 1], p[k], p[k + 1], 1e-9 * size)) {
          refuse("the segment from " + words(p[k]) + " to " + words(p[k + 1]) + " meets the one from " + words(p[i]) +
                 " to " + words(p[i + 1]) + "; a crack must not cross itself");
        }
      }
    }
  }

  void tip(const Point& t) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const FaceEdge& e : body) nearest = std::min(nearest, distance_to_segment(t, e.from, e.to));
    if (!inside(body, t)) refuse("the tip " + words(t) + " lies outside the body; it must lie inside");
    const int polygon = polygon_at(mesh, t);
    const double least = smallest_tip_distance * std::sqrt(mesh::moments(mesh::closed_line(mesh, polygon)).area);
    if (!(nearest > least)) {
      refuse("the tip " + words(t) + " is " + number_words(nearest) + " m from a face; it must be more than " +
             number_words(least) + " m away, " + number_words(smallest_tip_distance) + " of the polygon there");
    }
  }
};

}  // namespace

void check_path(const mesh::PolygonMesh& mesh, const CrackPath& path, int number) {
  if (numerics::planted_fault("crack/path-believed")) return;
  const Check check{mesh, path, face_edges(mesh), body_size(mesh), "crack " + std::to_string(number + 1)};
  check.points();
  if (!path.inner) check.mouth();
  check.self();
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) check.segment_inside(i);
  if (path.inner) check.tip(path.points.front());
  check.tip(path.points.back());
}

}  // namespace sunder::crack
