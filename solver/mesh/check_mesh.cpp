#include "solver/mesh/check_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/mesh/boundary_search.hpp"
#include "solver/mesh/edge_table.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/outline.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/words.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::mesh {
namespace {

std::string vertex_words(const PolygonMesh& mesh, int v) {
  return "vertex " + std::to_string(v) + " at " + place(mesh.vertices[v]);
}

std::string edge_words(const PolygonMesh& mesh, const Edge& e) {
  return "edge " + std::to_string(e[0]) + "-" + std::to_string(e[1]) + " from " + place(mesh.vertices[e[0]]) + " to " +
         place(mesh.vertices[e[1]]);
}

std::string polygon_words(const PolygonMesh& mesh, int i) {
  const Polygon& p = mesh.polygons[i];
  return "polygon " + std::to_string(i) + (p.vertices.empty() ? "" : " with " + vertex_words(mesh, p.vertices[0]));
}

void check_indices(const PolygonMesh& mesh) {
  if (mesh.polygons.empty()) throw MeshError("the mesh has no polygons");
  const int vertices = static_cast<int>(mesh.vertices.size());
  const auto exists = [&](int v, const std::string& where) {
    if (v < 0 || v >= vertices) {
      throw MeshError(where + " names vertex " + std::to_string(v) + "; there are vertices 0 to " +
                      std::to_string(vertices - 1));
    }
  };
  std::vector<int> seen(vertices, -1);
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    const Polygon& p = mesh.polygons[i];
    for (const int v : p.vertices) exists(v, "polygon " + std::to_string(i));
    const int least = p.open ? 2 : 3;
    if (static_cast<int>(p.vertices.size()) < least) {
      throw MeshError(polygon_words(mesh, i) + " has " + std::to_string(p.vertices.size()) + " vertices; at least " +
                      std::to_string(least) + " are needed");
    }
    for (const int v : p.vertices) {
      if (seen[v] == i) throw MeshError("polygon " + std::to_string(i) + " names " + vertex_words(mesh, v) + " twice");
      seen[v] = i;
    }
  }
  for (const auto& [name, edges] : mesh.boundaries) {
    for (const Edge& e : edges) {
      for (const int v : e) exists(v, "boundary \"" + name + "\"");
    }
  }
  for (std::size_t c = 0; c < mesh.cracks.size(); ++c) {
    for (const auto* face : {&mesh.cracks[c].lower, &mesh.cracks[c].upper}) {
      for (const int v : *face) exists(v, "crack " + std::to_string(c));
    }
  }
  const auto unused = std::find(seen.begin(), seen.end(), -1);
  if (unused != seen.end()) {
    throw MeshError(vertex_words(mesh, static_cast<int>(unused - seen.begin())) + " belongs to no polygon");
  }
}

void check_watertight(const PolygonMesh& mesh, const EdgeTable& table) {
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    for (int h = table.first[i]; h < table.first[i + 1]; ++h) {
      const int e = table.edge[h];
      if (table.uses[e] > 2) {
        throw MeshError(edge_words(mesh, table.ends[e]) + " belongs to " + std::to_string(table.uses[e]) +
                        " polygons, among them " + std::to_string(table.owners[e][0]) + " and " +
                        std::to_string(table.owners[e][1]) + "; one or two may share an edge");
      }
      if (table.owners[e][1] == i && mesh.polygons[i].vertices[h - table.first[i]] == table.ends[e][0]) {
        throw MeshError("polygons " + std::to_string(table.owners[e][0]) + " and " + std::to_string(i) + " run along " +
                        edge_words(mesh, table.ends[e]) +
                        " in the same sense; both must be counter-clockwise and lie on opposite sides of it");
      }
    }
  }
}

/// Edges of one polygon only, sorted.
std::vector<Edge> boundary_edges(const EdgeTable& table) {
  std::vector<Edge> edges;
  for (int e = 0; e < table.count(); ++e) {
    if (table.uses[e] == 1) edges.push_back(table.ends[e]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void check_names(const PolygonMesh& mesh, const std::vector<Edge>& boundary) {
  for (const auto& [name, edges] : mesh.boundaries) {
    for (const Edge& e : edges) {
      if (std::binary_search(boundary.begin(), boundary.end(), e)) continue;
      const bool turned = std::binary_search(boundary.begin(), boundary.end(), Edge{e[1], e[0]});
      throw MeshError("boundary \"" + name + "\": " + edge_words(mesh, e) +
                      (turned ? " runs against the sense of its polygon" : " is not an edge of the outer boundary"));
    }
  }
}

void check_cracks(const PolygonMesh& mesh) {
  std::vector<int> tips(mesh.polygons.size(), 0);
  for (std::size_t c = 0; c < mesh.cracks.size(); ++c) {
    const CrackFaces& faces = mesh.cracks[c];
    const std::string name = "crack " + std::to_string(c);
    if (faces.lower.empty() || faces.lower.size() != faces.upper.size()) {
      throw MeshError(name + " has " + std::to_string(faces.lower.size()) + " lower and " +
                      std::to_string(faces.upper.size()) + " upper vertices; they must be paired, at least one pair");
    }
    if (faces.tip_polygon == -1) continue;  // has reached a face
    if (faces.tip_polygon < 0 || faces.tip_polygon >= static_cast<int>(mesh.polygons.size()) ||
        !mesh.polygons[faces.tip_polygon].open) {
      throw MeshError(name + ": its tip polygon " + std::to_string(faces.tip_polygon) +
                      " is not an open polygon of the mesh");
    }
    const Polygon& tip = mesh.polygons[faces.tip_polygon];
    if (tip.vertices.front() != faces.lower.back() || tip.vertices.back() != faces.upper.back()) {
      throw MeshError(name + ": its faces do not end at the ends of its tip polygon " +
                      std::to_string(faces.tip_polygon));
    }
    ++tips[faces.tip_polygon];
  }
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    if (mesh.polygons[i].open && tips[i] != 1) {
      throw MeshError(polygon_words(mesh, i) + " is open, but is the tip polygon of " + std::to_string(tips[i]) +
                      " cracks; it must be of one");
    }
  }
}

void check_polygon_places(const PolygonMesh& mesh, double tolerance) {
  std::vector<Point> line;
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    const Polygon& p = mesh.polygons[i];
    for (int e = 0; e < p.edge_count(); ++e) {
      const Edge edge = p.edge(e);
      if (!((mesh.vertices[edge[1]] - mesh.vertices[edge[0]]).norm() > tolerance)) {
        throw MeshError("polygon " + std::to_string(i) + ": " + edge_words(mesh, edge) + " has no length");
      }
    }
    line.clear();
    for (const int v : p.vertices) line.push_back(mesh.vertices[v]);
    const double seen = clearance(line, p.scaling_centre, p.open);
    if (seen > smallest_clearance) continue;
    const double area = moments(closed_line(mesh, i)).area;
    if (area < 0.0) throw MeshError(polygon_words(mesh, i) + " runs clockwise; write its vertices counter-clockwise");
    if (!(area > 0.0)) throw MeshError(polygon_words(mesh, i) + " has no area");
    throw MeshError(polygon_words(mesh, i) + ": its scaling centre " + place(p.scaling_centre) +
                    (p.open ? " (the crack tip)" : "") + " does not see its whole boundary (clearance " + number(seen) +
                    ", must be > " + number(smallest_clearance) + ")");
  }
}

/// Round an inner vertex the angles of its polygons make one full turn.
void check_turns(const PolygonMesh& mesh, const EdgeTable& table) {
  std::vector<char> inner(mesh.vertices.size(), 1);
  for (int e = 0; e < table.count(); ++e) {
    if (table.uses[e] == 1) inner[table.ends[e][0]] = inner[table.ends[e][1]] = 0;
  }
  std::vector<double> turn(mesh.vertices.size(), 0.0);
  for (const Polygon& p : mesh.polygons) {
    const int n = static_cast<int>(p.vertices.size());
    if (p.open) inner[p.vertices.front()] = inner[p.vertices.back()] = 0;
    for (int k = 0; k < n; ++k) {
      const Point x = mesh.vertices[p.vertices[k]];
      const Point after = mesh.vertices[p.vertices[(k + 1) % n]] - x,
                  before = mesh.vertices[p.vertices[(k + n - 1) % n]] - x;
      const double angle = std::atan2(after.x() * before.y() - after.y() * before.x(), after.dot(before));
      turn[p.vertices[k]] += angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
    }
  }
  for (std::size_t v = 0; v < turn.size(); ++v) {
    // 1e-3 is far above round-off and far below the least possible error, a whole turn too much or too little.
    if (inner[v] && std::abs(turn[v] - 2.0 * std::numbers::pi) > 1e-3) {
      throw MeshError("the polygons round " + vertex_words(mesh, static_cast<int>(v)) + " overlap: their angles make " +
                      number(turn[v] / (2.0 * std::numbers::pi)) + " turns");
    }
  }
}

}  // namespace

void check_topology(const PolygonMesh& mesh) {
  check_indices(mesh);
  const EdgeTable table = edge_table(mesh);
  check_watertight(mesh, table);
  check_cracks(mesh);
}

void check_mesh(const PolygonMesh& mesh) {
  if (numerics::planted_fault("mesh/not-checked")) return;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw MeshError(vertex_words(mesh, static_cast<int>(v)) + "; finite coordinates are needed");
    }
  }
  check_topology(mesh);
  const EdgeTable table = edge_table(mesh);
  const std::vector<Edge> boundary = boundary_edges(table);
  check_names(mesh, boundary);
  check_polygon_places(mesh, place_tolerance(mesh.vertices));
  check_turns(mesh, table);
  check_boundary_places(mesh, boundary);
}

void orient_boundaries(PolygonMesh& mesh) {
  const std::vector<Edge> boundary = boundary_edges(edge_table(mesh));
  for (auto& [name, edges] : mesh.boundaries) {
    for (Edge& e : edges) {
      const bool along = std::binary_search(boundary.begin(), boundary.end(), e);
      if (!along && std::binary_search(boundary.begin(), boundary.end(), Edge{e[1], e[0]})) std::swap(e[0], e[1]);
    }
  }
}

}  // namespace sunder::mesh
