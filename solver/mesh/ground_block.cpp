#include "solver/mesh/ground_block.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/outline.hpp"
#include "solver/mesh/triangulation.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// Vertices of the boundary from left to right.
std::vector<int> line_of(const PolygonMesh& mesh, const std::string& boundary) {
  std::vector<int> line;
  for (const Edge& edge : mesh.boundaries.at(boundary)) line.insert(line.end(), edge.begin(), edge.end());
  std::sort(line.begin(), line.end(), [&](int a, int b) {
    return mesh.vertices[a].x() != mesh.vertices[b].x() ? mesh.vertices[a].x() < mesh.vertices[b].x() : a < b;
  });
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

/// The dual puts a vertex into the middle of every triangle's edge: on a base where every second vertex is one, the
/// block's triangles need the others only.
std::vector<int> without_midpoints(const PolygonMesh& mesh, const std::vector<int>& line) {
  if (line.size() < 3 || line.size() % 2 == 0) return line;
  std::vector<int> kept{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); i += 2) {
    const double a = mesh.vertices[line[i - 1]].x(), m = mesh.vertices[line[i]].x(), b = mesh.vertices[line[i + 1]].x();
    if (std::abs(m - 0.5 * (a + b)) > 1e-9 * (b - a)) return line;
    kept.push_back(line[i + 1]);
  }
  return kept;
}

PolygonMesh block_mesh(const PolygonMesh& mesh, const std::vector<int>& line, const LevelBase& base,
                       const GroundBlock& block) {
  const std::vector<int> fixed = without_midpoints(mesh, line);
  const double y = base.left.y();
  Outline outline;
  outline.vertices = {{base.left.x() - block.width, y},
                      {base.left.x() - block.width, y - block.depth},
                      {base.right.x() + block.width, y - block.depth},
                      {base.right.x() + block.width, y}};
  outline.boundaries = {{block_interface, {0, 1, 2}}};
  SizeField size{.size = block.size};
  for (std::size_t i = fixed.size(); i-- > 0;) {
    outline.vertices.emplace_back(mesh.vertices[fixed[i]].x(), y);
    if (i == 0) break;
    const double length = mesh.vertices[fixed[i]].x() - mesh.vertices[fixed[i - 1]].x();
    // A little longer than the piece, so that gmsh leaves it whole.
    size.lines.push_back({.path = {outline.vertices.back(), {mesh.vertices[fixed[i - 1]].x(), y}},
                          .radius = 0.0,
                          .size = std::min(1.1 * length / edge_per_polygon_size, block.size)});
  }
  return dual_mesh(outline, {.size = size, .max_polygons = block.max_polygons});
}

/// Puts `vertex` between the two ends of an edge of a polygon; false where the polygon does not have the edge.
bool insert_between(Polygon& polygon, const Edge& edge, int vertex) {
  for (int e = 0; e < polygon.edge_count(); ++e) {
    if (polygon.edge(e) != edge) continue;
    polygon.vertices.insert(polygon.vertices.begin() + e + 1, vertex);
    return true;
  }
  return false;
}

/// Gives polygons first … last - 1 every vertex of `all` (ascending in x) that lies inside one of their edges along the
/// base; `own` are the vertices that they have. `leftward`: their edges run in -x.
void add_missing(PolygonMesh& mesh, std::size_t first, std::size_t last, const std::vector<int>& all,
                 std::vector<int> own, bool leftward) {
  for (const int vertex : all) {
    if (std::find(own.begin(), own.end(), vertex) != own.end()) continue;
    const double x = mesh.vertices[vertex].x();
    const auto after = std::find_if(own.begin(), own.end(), [&](int other) { return mesh.vertices[other].x() > x; });
    if (after == own.begin() || after == own.end()) continue;  // beside the base
    const Edge edge = leftward ? Edge{*after, *(after - 1)} : Edge{*(after - 1), *after};
    for (std::size_t p = first; p < last && !insert_between(mesh.polygons[p], edge, vertex); ++p) {
    }
    own.insert(after, vertex);
  }
}

void check(const GroundBlock& block) {
  if (block.width > 0.0 && block.depth > 0.0 && block.size > 0.0) return;
  throw std::invalid_argument("near field: width, depth and size = " + number(block.width) + ", " +
                              number(block.depth) + ", " + number(block.size) + ", accepted is > 0");
}

}  // namespace

LevelBase level_base(const PolygonMesh& mesh, const std::string& boundary) {
  const auto found = mesh.boundaries.find(boundary);
  if (found == mesh.boundaries.end() || found->second.empty()) {
    throw MeshError("there is no boundary \"" + boundary + "\" to found on");
  }
  const double tolerance = 1e-9 * extent(mesh.vertices);
  const std::vector<int> line = line_of(mesh, boundary);
  const LevelBase base{mesh.vertices[line.front()], mesh.vertices[line.back()]};
  const auto refuse = [&](int vertex, const std::string& what) {
    throw MeshError("boundary \"" + boundary + "\" " + what + " at " + place(mesh.vertices[vertex]) +
                    "; a foundation accepts one level line with the body above it");
  };
  for (const int vertex : line) {
    if (std::abs(mesh.vertices[vertex].y() - base.left.y()) > tolerance) refuse(vertex, "is not level");
  }
  double covered = 0.0;
  for (const Edge& edge : found->second) covered += (mesh.vertices[edge[1]] - mesh.vertices[edge[0]]).norm();
  if (std::abs(covered - base.length()) > tolerance) refuse(line.front(), "has a gap or lies twice, counted");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].y() < base.left.y() - tolerance) refuse(static_cast<int>(i), "lies above a part of the body");
  }
  return base;
}

void append_block(PolygonMesh& mesh, const std::string& boundary, const GroundBlock& block) {
  check(block);
  const LevelBase base = level_base(mesh, boundary);
  const std::vector<int> above = line_of(mesh, boundary);
  const PolygonMesh below = block_mesh(mesh, above, base, block);
  const double tolerance = 1e-9 * extent(mesh.vertices);

  std::vector<int> number_of(below.vertices.size());
  std::vector<int> all = above, shared;
  for (std::size_t i = 0; i < below.vertices.size(); ++i) {
    const Point& x = below.vertices[i];
    const bool on_line = std::abs(x.y() - base.left.y()) <= tolerance && x.x() >= base.left.x() - tolerance &&
                         x.x() <= base.right.x() + tolerance;
    const auto same = std::find_if(above.begin(), above.end(), [&](int vertex) {
      return on_line && std::abs(mesh.vertices[vertex].x() - x.x()) <= tolerance;
    });
    number_of[i] = same != above.end() ? *same : static_cast<int>(mesh.vertices.size());
    if (same == above.end()) mesh.vertices.push_back(x);
    if (on_line) shared.push_back(number_of[i]);
  }
  const auto ascending = [&](int a, int b) { return mesh.vertices[a].x() < mesh.vertices[b].x(); };
  std::sort(shared.begin(), shared.end(), ascending);
  for (const int vertex : shared) {
    if (std::find(above.begin(), above.end(), vertex) == above.end()) all.push_back(vertex);
  }
  std::sort(all.begin(), all.end(), ascending);

  const std::size_t bodies = mesh.polygons.size();
  for (Polygon polygon : below.polygons) {
    for (int& vertex : polygon.vertices) vertex = number_of[vertex];
    polygon.material = block.material;
    mesh.polygons.push_back(std::move(polygon));
  }
  add_missing(mesh, 0, bodies, all, above, false);
  add_missing(mesh, bodies, mesh.polygons.size(), all, shared, true);

  mesh.boundaries.erase(boundary);
  std::vector<Edge>& interface = mesh.boundaries[block_interface];
  for (Edge edge : below.boundaries.at(block_interface)) interface.push_back({number_of[edge[0]], number_of[edge[1]]});
  check_mesh(mesh);
}

PolygonMesh block_below_strip(double half_width, const GroundBlock& block, double strip_size, double end_size) {
  check(block);
  if (!(half_width > 0.0 && strip_size > 0.0 && end_size > 0.0)) {
    throw std::invalid_argument("strip: half_width, strip_size and end_size = " + number(half_width) + ", " +
                                number(strip_size) + ", " + number(end_size) + ", accepted is > 0");
  }
  const double x = half_width + block.width;
  Outline outline;
  outline.vertices = {{-x, 0}, {-x, -block.depth}, {x, -block.depth}, {x, 0}, {half_width, 0}, {-half_width, 0}};
  outline.boundaries = {{block_interface, {0, 1, 2}}, {"strip", {4}}};
  SizeField size{.size = block.size};
  size.lines.push_back({.path = {outline.vertices[4], outline.vertices[5]}, .radius = 0.0, .size = strip_size});
  for (const int end : {4, 5}) {
    size.refinements.push_back({.centre = outline.vertices[end], .radius = 0.0, .size = end_size});
  }
  return dual_mesh(outline, {.size = size, .max_polygons = block.max_polygons});
}

}  // namespace sunder::mesh
