#include "solver/mesh/sources.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/edge_table.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// Name of every edge of the outline, empty where it has none.
std::vector<std::string> edge_names(const Outline& outline) {
  std::vector<std::string> names(outline.edge_count());
  for (const auto& [name, edges] : outline.boundaries) {
    for (const int e : edges) names[e] = name;
  }
  return names;
}

/// The four corners of a rectangle by their number in the outline, from the first on.
std::array<int, 4> rectangle_corners(const std::vector<Point>& p) {
  const int n = static_cast<int>(p.size());
  std::vector<int> corners;
  for (int i = 0; i < n; ++i) {
    const Point before = (p[i] - p[(i + n - 1) % n]).normalized(), after = (p[(i + 1) % n] - p[i]).normalized();
    if (std::abs(before.dot(after)) <= 1e-9) {
      corners.push_back(i);
    } else if (before.dot(after) < 1.0 - 1e-9) {
      throw MeshError("cells = \"squares\" needs a rectangular outline; its vertex " + std::to_string(i) + " at " +
                      place(p[i]) + " is not a right angle");
    }
  }
  if (corners.size() != 4) {
    throw MeshError("cells = \"squares\" needs a rectangular outline; this one has " + std::to_string(corners.size()) +
                    " right angles");
  }
  return {corners[0], corners[1], corners[2], corners[3]};
}

/// Numbers of the grid points along the four sides of an nx · ny grid, counter-clockwise, last = first.
std::vector<int> rim(int nx, int ny) {
  std::vector<int> line;
  const auto index = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int i = 0; i < nx; ++i) line.push_back(index(i, 0));
  for (int j = 0; j < ny; ++j) line.push_back(index(nx, j));
  for (int i = nx; i > 0; --i) line.push_back(index(i, ny));
  for (int j = ny; j >= 0; --j) line.push_back(index(0, j));
  return line;
}

/// Hands the names of the outline's edges to the grid edges on them, walking both round in step.
void name_rim(PolygonMesh& mesh, const Outline& outline, int first_corner, const std::vector<int>& line) {
  const std::vector<std::string> names = edge_names(outline);
  const std::vector<Point>& p = outline.vertices;
  const int n = static_cast<int>(p.size());
  const double tolerance = 1e-9 * extent(p);
  std::size_t at = 0;
  for (int k = 0; k < n; ++k) {
    const int edge = (first_corner + k) % n;
    const Point end = p[(edge + 1) % n];
    const double length = (end - p[edge]).norm();
    double walked = 0.0;
    while (walked < length - tolerance && at + 1 < line.size()) {
      const Edge e{line[at], line[at + 1]};
      walked += (mesh.vertices[e[1]] - mesh.vertices[e[0]]).norm();
      if (!names[edge].empty()) mesh.boundaries[names[edge]].push_back(e);
      ++at;
    }
    if ((mesh.vertices[line[at]] - end).norm() > tolerance) {
      throw MeshError("vertex " + std::to_string((edge + 1) % n) + " of the outline at " + place(end) +
                      " is not a point of the grid, whose nearest is at " + place(mesh.vertices[line[at]]) +
                      "; choose a size that divides the sides there");
    }
  }
}

}  // namespace

PolygonMesh listed_polygons(std::vector<Point> vertices, std::vector<std::vector<int>> polygons,
                            std::map<std::string, std::vector<Edge>> boundaries) {
  PolygonMesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.boundaries = std::move(boundaries);
  for (std::vector<int>& p : polygons) mesh.polygons.push_back({.vertices = std::move(p)});
  check_topology(mesh);
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    mesh.polygons[i].scaling_centre = chosen_centre(mesh, i);
  }
  orient_boundaries(mesh);
  check_mesh(mesh);
  return mesh;
}

PolygonMesh square_grid(const Outline& outline, double size, long max_polygons) {
  if (!(size > 0.0)) throw std::invalid_argument("size is " + number(size) + ", must be > 0");
  check_outline(outline);
  if (!outline.holes.empty())
    throw MeshError("cells = \"squares\" takes no holes; the outline has " + std::to_string(outline.holes.size()));
  const std::vector<Point>& p = outline.vertices;
  const std::array<int, 4> corner = rectangle_corners(p);
  const Point origin = p[corner[0]], along = p[corner[1]] - origin, up = p[corner[3]] - origin;
  const double columns = std::max(1.0, std::round(along.norm() / size)),
               rows = std::max(1.0, std::round(up.norm() / size));
  if (columns * rows > static_cast<double>(max_polygons)) {
    throw MeshError("a grid of " + number(columns) + " x " + number(rows) + " squares exceeds max_polygons = " +
                    std::to_string(max_polygons) + "; choose a larger size than " + number(size));
  }
  const int nx = static_cast<int>(columns), ny = static_cast<int>(rows);
  PolygonMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(nx + 1) * (ny + 1));
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) {
      mesh.vertices.push_back(origin + along * (static_cast<double>(i) / nx) + up * (static_cast<double>(j) / ny));
    }
  }
  mesh.polygons.reserve(static_cast<std::size_t>(nx) * ny);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int v = j * (nx + 1) + i;
      const Point centre = origin + along * ((i + 0.5) / nx) + up * ((j + 0.5) / ny);
      mesh.polygons.push_back({.vertices = {v, v + 1, v + nx + 2, v + nx + 1}, .scaling_centre = centre});
    }
  }
  name_rim(mesh, outline, corner[0], rim(nx, ny));
  check_mesh(mesh);
  return mesh;
}

PolygonMesh one_polygon(const Outline& outline, const SizeField& edge_size, const std::vector<CornerLayers>& corners) {
  edge_size.check();
  check_outline(outline);
  if (!outline.holes.empty())
    throw MeshError("one polygon cannot have holes; the outline has " + std::to_string(outline.holes.size()));
  const std::vector<Point>& p = outline.vertices;
  const std::vector<std::string> names = edge_names(outline);
  const double tolerance = 1e-9 * extent(p);
  std::vector<int> layers(p.size(), 0);
  std::vector<double> ratio(p.size(), 0.5);
  for (const CornerLayers& c : corners) {
    if (c.layers < 1 || !(c.ratio > 0.0 && c.ratio < 1.0)) {
      throw std::invalid_argument("corner layers: " + std::to_string(c.layers) + " of ratio " + number(c.ratio) +
                                  "; at least 1 and a ratio in 0 … 1 are accepted");
    }
    const auto at =
        std::find_if(p.begin(), p.end(), [&](const Point& q) { return (q - c.corner).norm() <= tolerance; });
    if (at == p.end()) throw MeshError("corner " + place(c.corner) + " is not a vertex of the outline");
    layers[at - p.begin()] = c.layers;
    ratio[at - p.begin()] = c.ratio;
  }

  PolygonMesh mesh;
  std::vector<std::string> name_after;  // name of the edge behind each vertex
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    std::vector<double> t = division(p[i], p[next], edge_size);
    const double first = t.empty() ? 1.0 : t.front(), last = t.empty() ? 1.0 : 1.0 - t.back();
    // Where the whole edge is one piece both ends grade inside it: each takes the half next to it.
    const bool shared = t.empty() && layers[i] > 0 && layers[next] > 0;
    for (int k = 1; k <= layers[i]; ++k) t.push_back((shared ? 0.5 : 1.0) * first * std::pow(ratio[i], k));
    for (int k = 1; k <= layers[next]; ++k) t.push_back(1.0 - (shared ? 0.5 : 1.0) * last * std::pow(ratio[next], k));
    if (shared) t.push_back(0.5);
    std::sort(t.begin(), t.end());
    mesh.vertices.push_back(p[i]);
    name_after.push_back(names[i]);
    for (const double s : t) {
      mesh.vertices.push_back((1.0 - s) * p[i] + s * p[next]);
      name_after.push_back(names[i]);
    }
  }
  const int count = static_cast<int>(mesh.vertices.size());
  mesh.polygons.push_back({.vertices = {}});
  for (int v = 0; v < count; ++v) {
    mesh.polygons[0].vertices.push_back(v);
    if (!name_after[v].empty()) mesh.boundaries[name_after[v]].push_back({v, (v + 1) % count});
  }
  mesh.polygons[0].scaling_centre = chosen_centre(mesh, 0);
  check_mesh(mesh);
  return mesh;
}

}  // namespace sunder::mesh
