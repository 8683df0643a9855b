#include "solver/mesh/dual.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "solver/mesh/edge_table.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/words.hpp"

namespace sunder::mesh {
namespace {

/// A cell seen from one of its vertices: polygon edges `out` (leaves the vertex) and `in` (comes to it).
struct Corner {
  int cell = -1;
  int out = -1, in = -1;  ///< mesh edges
};

/// The corners of every vertex, one vertex after another.
struct Corners {
  std::vector<int> first;
  std::vector<Corner> corner;
};

Corners corners_of(const PolygonMesh& mesh, const EdgeTable& table) {
  Corners c;
  c.first.assign(mesh.vertices.size() + 1, 0);
  for (const Polygon& p : mesh.polygons) {
    for (const int v : p.vertices) ++c.first[v + 1];
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) c.first[v + 1] += c.first[v];
  c.corner.resize(c.first.back());
  std::vector<int> next(c.first.begin(), c.first.end() - 1);
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    const std::vector<int>& v = mesh.polygons[i].vertices;
    const int n = static_cast<int>(v.size());
    for (int k = 0; k < n; ++k) {
      c.corner[next[v[k]]++] = {i, table.edge[table.first[i] + k], table.edge[table.first[i] + (k + n - 1) % n]};
    }
  }
  return c;
}

/// The corners of one vertex in counter-clockwise order, from the boundary where it lies there.
std::vector<Corner> turn(const PolygonMesh& mesh, const EdgeTable& table, const Corners& corners, int v) {
  const auto begin = corners.corner.begin() + corners.first[v], end = corners.corner.begin() + corners.first[v + 1];
  const auto unsound = [&](const char* reason) {
    throw MeshError("vertex " + std::to_string(v) + " at " + place(mesh.vertices[v]) + " " + reason);
  };
  if (begin == end) unsound("belongs to no cell");
  auto at = std::find_if(begin, end, [&](const Corner& c) { return table.uses[c.out] == 1; });
  if (at == end) at = begin;
  std::vector<Corner> ordered;
  while (static_cast<long>(ordered.size()) < end - begin) {
    ordered.push_back(*at);
    const int across = at->in;
    at = std::find_if(begin, end, [&](const Corner& c) { return c.out == across; });
    if (at == end || at->cell == ordered.front().cell) break;
  }
  if (static_cast<long>(ordered.size()) != end - begin) unsound("joins parts of the body that touch only there");
  return ordered;
}

int prevailing_material(const PolygonMesh& mesh, const std::vector<Corner>& corners) {
  const int first = mesh.polygons[corners[0].cell].material;
  if (std::all_of(corners.begin(), corners.end(),
                  [&](const Corner& c) { return mesh.polygons[c.cell].material == first; })) {
    return first;
  }
  std::map<int, double> area;
  for (const Corner& c : corners) {
    const double share =
        moments(closed_line(mesh, c.cell)).area / static_cast<double>(mesh.polygons[c.cell].vertices.size());
    area[mesh.polygons[c.cell].material] += share;
  }
  return std::max_element(area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// At a sharp re-entrant corner, its first vertex, a polygon sees its boundary badly or not at all. It is cut from
/// there to centroids into parts that see theirs, each as large as possible; a triangle always does. Parts after the
/// first become the last polygons of the mesh.
void split_at_corner(PolygonMesh& mesh, int polygon) {
  constexpr double poor = 0.05, enough = 0.2;  // clearance; a square has 0.87
  const auto seen = [&](const std::vector<int>& vertices) {
    std::vector<Point> points;
    for (const int v : vertices) points.push_back(mesh.vertices[v]);
    return scaling_centre(points).clearance;
  };
  const std::vector<int> v = mesh.polygons[polygon].vertices;
  if (seen(v) >= poor) return;
  std::vector<std::vector<int>> parts;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) {  // triangle v[0], v[k], v[k + 1] joins the last part, or starts one
    std::vector<int> wider = parts.empty() ? std::vector<int>{v[0], v[k]} : parts.back();
    wider.push_back(v[k + 1]);
    if (!parts.empty() && seen(wider) >= enough) {
      parts.back() = std::move(wider);
    } else {
      parts.push_back({v[0], v[k], v[k + 1]});
    }
  }
  const int material = mesh.polygons[polygon].material;
  mesh.polygons[polygon].vertices = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i) mesh.polygons.push_back({.vertices = parts[i], .material = material});
}

}  // namespace

PolygonMesh dual(const PolygonMesh& primal) {
  if (!primal.cracks.empty()) throw std::invalid_argument("the dual is formed before cracks are cut");
  const EdgeTable table = edge_table(primal);
  const Corners corners = corners_of(primal, table);
  const int cells = static_cast<int>(primal.polygons.size()), count = static_cast<int>(primal.vertices.size());

  PolygonMesh mesh;  // vertices: centroids of the cells, midpoints of boundary edges, boundary vertices
  mesh.vertices.reserve(cells + count / 4);
  for (int i = 0; i < cells; ++i) mesh.vertices.push_back(moments(closed_line(primal, i)).centroid);
  std::vector<int> midpoint(table.count(), -1), kept(count, -1);
  for (int e = 0; e < table.count(); ++e) {
    if (table.uses[e] != 1) continue;
    midpoint[e] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(0.5 * (primal.vertices[table.ends[e][0]] + primal.vertices[table.ends[e][1]]));
    kept[table.ends[e][0]] = kept[table.ends[e][1]] = 0;
  }
  for (int v = 0; v < count; ++v) {
    if (kept[v] < 0) continue;
    kept[v] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(primal.vertices[v]);
  }

  mesh.polygons.resize(count);
  for (int v = 0; v < count; ++v) {
    const std::vector<Corner> ring = turn(primal, table, corners, v);
    Polygon& polygon = mesh.polygons[v];
    if (kept[v] >= 0) polygon.vertices = {kept[v], midpoint[ring.front().out]};
    for (const Corner& c : ring) polygon.vertices.push_back(c.cell);
    if (kept[v] >= 0) polygon.vertices.push_back(midpoint[ring.back().in]);
    polygon.material = prevailing_material(primal, ring);
  }
  for (int v = 0; v < count; ++v) {
    if (kept[v] >= 0) split_at_corner(mesh, v);
  }
  try {
    for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
      mesh.polygons[i].scaling_centre = chosen_centre(mesh, i);
    }
  } catch (const MeshError& error) {
    throw MeshError(std::string(error.what()) + " (in the dual: the cells there are too flat, smaller ones help)");
  }

  // The two halves of a named edge; its midpoint is found by its first vertex, which starts one boundary edge.
  std::vector<int> starts(count, -1);
  for (int e = 0; e < table.count(); ++e) {
    if (table.uses[e] == 1) starts[table.ends[e][0]] = e;
  }
  for (const auto& [name, edges] : primal.boundaries) {
    std::vector<Edge>& halves = mesh.boundaries[name];
    for (const Edge& e : edges) {
      const int start = starts.at(e[0]);
      if (start < 0 || table.ends[start] != e) {
        throw MeshError("boundary \"" + name + "\": edge " + std::to_string(e[0]) + "-" + std::to_string(e[1]) +
                        " from " + place(primal.vertices[e[0]]) + " is not an edge of the outer boundary");
      }
      const int middle = midpoint[start];
      halves.push_back({kept[e[0]], middle});
      halves.push_back({middle, kept[e[1]]});
    }
  }
  return mesh;
}

}  // namespace sunder::mesh
