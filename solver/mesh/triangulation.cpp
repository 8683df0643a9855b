#include "solver/mesh/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/dual.hpp"
#include "solver/mesh/gmsh_mesher.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/segments.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// A straight curve of the gmsh model between two of its points.
struct Curve {
  int from, to;           ///< indices into Layout::places
  int outline_edge = -1;  ///< -1: part of a path
};

/// What gmsh is given: distinct places, curves between them, closed loops of curves, and what lies inside.
struct Layout {
  std::vector<Point> places;
  std::vector<Curve> curves;
  std::vector<std::vector<int>> loops;  ///< curve numbers of the outline, then of each hole
  std::vector<int> inner_points;        ///< places that no curve touches
  double tolerance = 0.0;

  int place_of(const Point& x) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((places[i] - x).norm() <= tolerance) return static_cast<int>(i);
    }
    places.push_back(x);
    return static_cast<int>(places.size()) - 1;
  }
};

/// Path vertices and points that lie on an edge of the outline, in order along it: the edge is divided there.
std::vector<Point> stops_on(const Point& a, const Point& b, const std::vector<Point>& candidates, double tolerance) {
  std::vector<Point> stops;
  for (const Point& p : candidates) {
    if (distance_to_segment(p, a, b) <= tolerance && (p - a).norm() > tolerance && (p - b).norm() > tolerance) {
      stops.push_back(p);
    }
  }
  std::sort(stops.begin(), stops.end(),
            [&](const Point& p, const Point& q) { return (p - a).squaredNorm() < (q - a).squaredNorm(); });
  return stops;
}

void check_inner(const Outline& outline, const Point& p, double tolerance, const std::string& name) {
  bool on_line = false, in_body = inside(p, outline.vertices);
  for (const auto& hole : outline.holes) in_body = in_body && !inside(p, hole);
  for (int e = 0; e < outline.edge_count(); ++e) {
    const auto [a, b] = outline.edge(e);
    on_line = on_line || distance_to_segment(p, a, b) <= tolerance;
  }
  if (!in_body && !on_line) throw MeshError(name + " at " + place(p) + " lies outside the body");
}

/// Paths lie in the body and meet the outline with their ends only.
void check_paths(const Outline& outline, const TriangulationOptions& options, double tolerance) {
  const auto& paths = options.paths;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::string name = "path " + std::to_string(k);
    if (paths[k].size() < 2)
      throw MeshError(name + " has " + std::to_string(paths[k].size()) + " points; at least 2 are needed");
    for (std::size_t i = 0; i < paths[k].size(); ++i) {
      if (!paths[k][i].allFinite())
        throw MeshError(name + ": point " + std::to_string(i) + " is " + place(paths[k][i]));
      check_inner(outline, paths[k][i], tolerance, name + ": point " + std::to_string(i));
    }
    for (std::size_t i = 0; i + 1 < paths[k].size(); ++i) {
      const Point &c = paths[k][i], &d = paths[k][i + 1];
      if ((d - c).norm() <= tolerance) throw MeshError(name + " repeats its point at " + place(c));
      for (int e = 0; e < outline.edge_count(); ++e) {
        const auto [a, b] = outline.edge(e);
        if (!segments_meet(a, b, c, d, tolerance)) continue;
        const bool starts = i == 0 && distance_to_segment(c, a, b) <= tolerance;
        const bool ends = i + 2 == paths[k].size() && distance_to_segment(d, a, b) <= tolerance;
        if (starts == ends) {  // it crosses, or runs along the edge
          throw MeshError(name + " from " + place(c) + " to " + place(d) + " meets edge " + std::to_string(e) +
                          " of the outline, " + place(a) + " to " + place(b) +
                          "; only its ends may lie on the outline");
        }
      }
      for (std::size_t m = 0; m <= k; ++m) {
        for (std::size_t j = 0; j + 1 < paths[m].size() && (m < k || j < i); ++j) {
          const Point &p = paths[m][j], &q = paths[m][j + 1];
          if (!segments_meet(c, d, p, q, tolerance)) continue;
          const auto same = [&](const Point& x, const Point& y) { return (x - y).norm() <= tolerance; };
          const bool joined = same(c, p) || same(c, q) || same(d, p) || same(d, q);
          if (joined) continue;
          throw MeshError(name + " from " + place(c) + " to " + place(d) + " meets path " + std::to_string(m) +
                          " from " + place(p) + " to " + place(q) + "; paths may share end points only");
        }
      }
    }
  }
  for (std::size_t i = 0; i < options.points.size(); ++i) {
    check_inner(outline, options.points[i], tolerance, "point " + std::to_string(i));
  }
}

Layout layout_of(const Outline& outline, const TriangulationOptions& options) {
  Layout layout;
  layout.tolerance = std::max(1e-9 * extent(outline.vertices), place_tolerance(outline.vertices));
  check_paths(outline, options, layout.tolerance);
  std::vector<Point> candidates = options.points;
  for (const auto& path : options.paths) candidates.insert(candidates.end(), path.begin(), path.end());

  int edge = 0;
  const auto add_loop = [&](const std::vector<Point>& line) {
    layout.loops.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i, ++edge) {
      const Point &a = line[i], &b = line[(i + 1) % line.size()];
      std::vector<Point> stops = stops_on(a, b, candidates, layout.tolerance);
      stops.push_back(b);
      int from = layout.place_of(a);
      for (const Point& stop : stops) {
        const int to = layout.place_of(stop);
        if (to == from) continue;  // two paths start here
        layout.loops.back().push_back(static_cast<int>(layout.curves.size()));
        layout.curves.push_back({from, to, edge});
        from = to;
      }
    }
  };
  add_loop(outline.vertices);
  for (const auto& hole : outline.holes) add_loop(hole);
  for (const auto& path : options.paths) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const int from = layout.place_of(path[i]), to = layout.place_of(path[i + 1]);
      layout.curves.push_back({from, to, -1});
    }
  }
  const std::size_t used = layout.places.size();
  for (const Point& p : options.points) {
    if (const int at = layout.place_of(p); at >= static_cast<int>(used)) layout.inner_points.push_back(at);
  }
  return layout;
}

/// Body shifted to the origin and scaled to a size of 1 … 2: gmsh's tolerances are absolute.
struct Normal {
  Point low;
  double factor;

  explicit Normal(const std::vector<Point>& points) : low(points[0]) {
    for (const Point& p : points) low = low.cwiseMin(p);
    factor = std::ldexp(1.0, -std::ilogb(extent(points)));
  }
  Point to(const Point& x) const { return factor * (x - low); }
  Point from(const Point& y) const { return low + y / factor; }
};

PlaneModel model_of(const Layout& layout, const Normal& normal) {
  PlaneModel model;
  for (const Point& x : layout.places) model.points.push_back(normal.to(x));
  for (const Curve& c : layout.curves) model.curves.push_back({c.from, c.to, c.outline_edge < 0});
  model.loops = layout.loops;
  model.inner_points = layout.inner_points;
  return model;
}

/// The body's own places: those of the layout exactly, those on its curves on the straight line.
std::vector<Point> places_of(const PlaneTriangles& triangles, const Layout& layout, const Normal& normal) {
  std::vector<Point> places;
  places.reserve(triangles.places.size());
  for (const Point& y : triangles.places) places.push_back(normal.from(y));
  for (std::size_t c = 0; c < layout.curves.size(); ++c) {
    const Point a = layout.places[layout.curves[c].from], b = layout.places[layout.curves[c].to];
    for (const int node : triangles.curve_nodes[c]) {
      const double t = (places[node] - a).dot(b - a) / (b - a).squaredNorm();
      places[node] = (1.0 - t) * a + t * b;
    }
  }
  for (std::size_t p = 0; p < layout.places.size(); ++p) {
    for (const int node : triangles.point_nodes[p]) places[node] = layout.places[p];
  }
  return places;
}

PolygonMesh mesh_of(const PlaneTriangles& triangles, const Outline& outline, const Layout& layout,
                    const Normal& normal) {
  PolygonMesh mesh;
  mesh.vertices = places_of(triangles, layout, normal);
  const std::vector<Point>& x = mesh.vertices;
  mesh.polygons.reserve(triangles.triangles.size());
  for (const auto& [a, b, c] : triangles.triangles) {
    std::vector<int> v{a, b, c};
    if (twice_area(x[a], x[b], x[c]) < 0.0) std::swap(v[1], v[2]);
    mesh.polygons.push_back({.vertices = std::move(v), .scaling_centre = (x[a] + x[b] + x[c]) / 3.0});
  }
  std::vector<std::string> name(outline.edge_count());
  for (const auto& [boundary, edges] : outline.boundaries) {
    mesh.boundaries[boundary];
    for (const int e : edges) name[e] = boundary;
  }
  for (std::size_t c = 0; c < layout.curves.size(); ++c) {
    const int edge = layout.curves[c].outline_edge;
    if (edge < 0 || name[edge].empty()) continue;
    std::vector<Edge>& named = mesh.boundaries[name[edge]];
    named.insert(named.end(), triangles.curve_edges[c].begin(), triangles.curve_edges[c].end());
  }
  orient_boundaries(mesh);
  return mesh;
}

}  // namespace

PolygonMesh triangulate(const Outline& outline, const TriangulationOptions& options) {
  options.size.check();
  check_outline(outline);
  const Layout layout = layout_of(outline, options);
  const double estimate = estimated_vertices(outline, options.size);
  if (!(estimate <= static_cast<double>(options.max_polygons))) {
    throw MeshError("about " + number(std::round(estimate)) +
                    " polygons are to be expected, more than max_polygons = " + std::to_string(options.max_polygons) +
                    "; choose larger sizes or raise it");
  }
  const Normal normal(outline.vertices);
  const PlaneTriangles triangles = triangulate_plane(
      model_of(layout, normal), [&](const Point& y) { return options.size.at(normal.from(y)) * normal.factor; });
  if (triangles.triangles.empty()) {
    throw MeshError("gmsh made no triangles of the outline from " + place(outline.vertices[0]));
  }
  return mesh_of(triangles, outline, layout, normal);
}

PolygonMesh triangle_mesh(const Outline& outline, const TriangulationOptions& options) {
  TriangulationOptions vertices = options;
  vertices.max_polygons = options.max_polygons / 2;  // two triangles a vertex
  PolygonMesh mesh = triangulate(outline, vertices);
  check_mesh(mesh);
  return mesh;
}

PolygonMesh dual_mesh(const Outline& outline, const TriangulationOptions& options) {
  TriangulationOptions edges = options;
  edges.size = scaled(options.size, edge_per_polygon_size);
  PolygonMesh mesh = dual(triangulate(outline, edges));
  check_mesh(mesh);
  return mesh;
}

}  // namespace sunder::mesh
