#include "solver/crack/body.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "solver/crack/cutter.hpp"
#include "solver/mesh/polygon_geometry.hpp"

namespace sunder::crack {
namespace {

std::uint64_t key(int a, int b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

}  // namespace

std::vector<FaceEdge> face_edges(const mesh::PolygonMesh& mesh) {
  std::unordered_set<std::uint64_t> edges;
  edges.reserve(8 * mesh.polygons.size());
  for (const mesh::Polygon& p : mesh.polygons) {
    for (int i = 0; i < p.edge_count(); ++i) edges.insert(key(p.edge(i)[0], p.edge(i)[1]));
  }
  std::unordered_map<std::uint64_t, int> of_crack;
  for (std::size_t c = 0; c < mesh.cracks.size(); ++c) {
    const mesh::CrackFaces& f = mesh.cracks[c];
    for (std::size_t i = 0; i + 1 < f.lower.size(); ++i) {
      of_crack[key(f.lower[i + 1], f.lower[i])] = static_cast<int>(c);
      of_crack[key(f.upper[i], f.upper[i + 1])] = static_cast<int>(c);
    }
  }
  std::vector<FaceEdge> faces;
  for (const mesh::Polygon& p : mesh.polygons) {
    for (int i = 0; i < p.edge_count(); ++i) {
      const mesh::Edge e = p.edge(i);
      if (edges.contains(key(e[1], e[0]))) continue;
      const auto crack = of_crack.find(key(e[0], e[1]));
      faces.push_back({mesh.vertices[e[0]], mesh.vertices[e[1]], e, crack == of_crack.end() ? -1 : crack->second});
    }
  }
  for (std::size_t c = 0; c < mesh.cracks.size(); ++c) {
    const mesh::CrackFaces& f = mesh.cracks[c];
    if (f.tip_polygon < 0) continue;
    const Point tip = mesh.polygons[f.tip_polygon].scaling_centre;
    faces.push_back({mesh.vertices[f.upper.back()], tip, {f.upper.back(), -1}, static_cast<int>(c)});
    faces.push_back({tip, mesh.vertices[f.lower.back()], {-1, f.lower.back()}, static_cast<int>(c)});
  }
  return faces;
}

double body_size(const mesh::PolygonMesh& mesh) {
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Point& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

bool inside(const std::vector<FaceEdge>& faces, const Point& point) {
  bool in = false;
  for (const FaceEdge& e : faces) {
    if (e.crack >= 0) continue;
    const Point a = e.from - point, b = e.to - point;
    if ((a.y() > 0.0) == (b.y() > 0.0)) continue;
    if (a.x() + a.y() / (a.y() - b.y()) * (b.x() - a.x()) > 0.0) in = !in;
  }
  return in;
}

int polygon_at(const mesh::PolygonMesh& mesh, const Point& point) {
  int best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    const std::vector<Point> line = mesh::closed_line(mesh, i);
    bool in = false;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Point &p = line[k], &q = line[(k + 1) % line.size()];
      distance = std::min(distance, distance_to_segment(point, p, q));
      const Point a = p - point, b = q - point;
      if ((a.y() > 0.0) != (b.y() > 0.0) && a.x() + a.y() / (a.y() - b.y()) * (b.x() - a.x()) > 0.0) in = !in;
    }
    if (in) distance = -distance;
    if (distance < nearest) {
      nearest = distance;
      best = i;
    }
  }
  return best;
}

double distance_to_segment(const Point& point, const Point& a, const Point& b) {
  const Point d = b - a;
  const double length = d.squaredNorm();
  const double t = length > 0.0 ? std::clamp((point - a).dot(d) / length, 0.0, 1.0) : 0.0;
  return (point - a - t * d).norm();
}

bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b, double reach) {
  const Point d = q - p, e = b - a;
  const double sa = cross(d, a - p), sb = cross(d, b - p), sp = cross(e, p - a), sq = cross(e, q - a);
  if ((sa > 0.0) != (sb > 0.0) && (sp > 0.0) != (sq > 0.0)) return true;
  return std::min({distance_to_segment(a, p, q), distance_to_segment(b, p, q), distance_to_segment(p, a, b),
                   distance_to_segment(q, a, b)}) <= reach;
}

}  // namespace sunder::crack
