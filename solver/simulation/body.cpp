#include "solver/simulation/body.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "solver/crack/advance_tip.hpp"
#include "solver/crack/insert_crack.hpp"
#include "solver/mesh/divide.hpp"
#include "solver/mesh/ground_block.hpp"
#include "solver/mesh/msh_file.hpp"

#include "solver/mesh/sources.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::simulation {
namespace {

using mesh::Point;

mesh::Outline outline_of(const scene::Geometry& geometry) {
  return {.vertices = geometry.outline, .holes = geometry.holes, .boundaries = geometry.boundaries};
}

double length_of(const std::vector<Point>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

/// The scene's sizes, and polygons no larger than half a crack along it: its tip polygon must fit inside.
mesh::SizeField size_field(const scene::Scene& scene) {
  mesh::SizeField field{.size = scene.mesh.size.value_or(std::numeric_limits<double>::infinity())};
  for (const scene::Refinement& refinement : scene.mesh.refine) {
    field.refinements.push_back({.centre = refinement.centre, .radius = refinement.radius, .size = refinement.size});
  }
  for (const scene::Crack& crack : scene.cracks) {
    const double half = 0.5 * length_of(crack.path);
    if (half < field.size) field.lines.push_back({.path = crack.path, .radius = half, .size = half});
  }
  return field;
}

mesh::PolygonMesh mesh_of_outline(const scene::Scene& scene) {
  const mesh::Outline outline = outline_of(*scene.geometry);
  const scene::Mesh& wanted = scene.mesh;
  switch (wanted.cells) {
    case scene::Cells::one: {
      std::vector<mesh::CornerLayers> corners;
      for (const scene::Grading& grading : wanted.grade) {
        corners.push_back({.corner = grading.corner, .layers = grading.layers, .ratio = grading.ratio});
      }
      return mesh::one_polygon(outline, {}, corners);
    }
    case scene::Cells::squares:
      return mesh::square_grid(outline, *wanted.size, wanted.max_polygons);
    case scene::Cells::dual:
    case scene::Cells::triangles: {
      mesh::TriangulationOptions options{.size = size_field(scene), .max_polygons = wanted.max_polygons};
      for (const scene::Crack& crack : scene.cracks) options.paths.push_back(crack.path);
      return wanted.cells == scene::Cells::dual ? mesh::dual_mesh(outline, options)
                                                : mesh::triangle_mesh(outline, options);
    }
  }
  throw std::invalid_argument("unknown kind of cells");
}

mesh::PolygonMesh uncracked_mesh(const scene::Scene& scene) {
  if (scene.mesh.list) {
    const scene::PolygonList& list = *scene.mesh.list;
    return mesh::listed_polygons(list.vertices, list.polygons, list.boundaries);
  }
  if (scene.mesh.file) {
    return mesh::read_msh(*scene.mesh.file, {.dual = scene.mesh.dual, .max_polygons = scene.mesh.max_polygons});
  }

  return mesh_of_outline(scene);
}

bool inside(const std::vector<Point>& outline, const Point& x) {
  bool odd = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point &a = outline[i], &b = outline[j];
    if ((a.y() > x.y()) != (b.y() > x.y()) && x.x() < (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      odd = !odd;
    }
  }
  return odd;
}

void assign_materials(const scene::Scene& scene, mesh::PolygonMesh& polygons) {
  for (mesh::Polygon& polygon : polygons.polygons) {
    for (std::size_t i = 0; i < scene.regions.size(); ++i) {
      if (inside(scene.regions[i].outline, polygon.scaling_centre)) polygon.material = static_cast<int>(i) + 1;
    }
  }
}

material::Isotropic rock_of(const scene::Scene& scene) {
  const scene::Foundation& foundation = *scene.foundation;
  material::Isotropic rock{.youngs_modulus = foundation.youngs_modulus,
                           .poisson_ratio = foundation.poisson_ratio,
                           .density = foundation.density};
  // Modes of a block of rock with inertia would be those of its own size, not of the dam.
  if (scene.analysis == scene::Analysis::modal) rock.density = 0.0;
  return rock;
}

void append_near_field(const scene::Scene& scene, int material, mesh::PolygonMesh& polygons) {
  const scene::NearField given = scene.foundation->near_field.value_or(scene::NearField{});
  const double base = mesh::level_base(polygons, scene.foundation->boundary).length();
  mesh::append_block(polygons, scene.foundation->boundary,
                     {.width = given.width.value_or(0.25 * base),
                      .depth = given.depth.value_or(0.25 * base),
                      .size = given.size.value_or(0.125 * base),
                      .material = material,
                      .max_polygons = scene.mesh.max_polygons});
}

/// A crack from face to face: first to the middle of its last segment, then on until it comes out.
void cut_through(mesh::PolygonMesh& polygons, std::vector<Point> path, int number, const crack::CutOptions& options) {
  const Point end = path.back();
  path.back() = 0.5 * (path[path.size() - 2] + end);
  crack::insert_crack(polygons, {.points = path}, number, options);
  const int tip = static_cast<int>(polygons.cracks.size()) - 1;
  // A little beyond the face: an advance ends at the first one that it meets.
  const crack::Advance advance = crack::advance_tip(polygons, tip, end + 0.1 * (end - path.back()), options);
  const double reach = 1e-6 * (end - path.back()).norm();
  if (advance.event == crack::TipEvent::reached_boundary && (advance.tip - end).norm() <= reach) return;
  const std::string place = "(" + std::to_string(end.x()) + ", " + std::to_string(end.y()) + ")";
  throw crack::CrackError("crack " + std::to_string(number + 1) + ": does not come out at " + place +
                          (advance.reason.empty() ? "" : ": " + advance.reason) +
                          "; accepted with `through`: a path that ends on a face of the body");
}

crack::CutOptions cut_options(const scene::Scene& scene) {
  crack::CutOptions options;
  if (scene.mesh.cells == scene::Cells::one && !scene.mesh.list && !scene.mesh.file) {
    options.tip_edges = 1;  // edge_size and grade say how the one polygon's edges are divided
    options.flattest_edge = 1e-6;
  }
  if (scene.mesh.tip_edges) options.tip_edges = *scene.mesh.tip_edges;
  return options;
}

/// Edges on crack faces that have an edge of a crack polygon opposite. A tip polygon may hold a piece of one face, as
/// behind a kink; both faces of a piece need the same nodes to be paired.
std::set<mesh::Edge> opposite_tip_edges(const mesh::PolygonMesh& polygons) {
  std::set<mesh::Edge> of_tips, opposite;
  for (const mesh::Polygon& polygon : polygons.polygons) {
    if (!polygon.open) continue;
    for (int e = 0; e < polygon.edge_count(); ++e) of_tips.insert(polygon.edge(e));
  }
  if (of_tips.empty()) return opposite;
  for (const mesh::CrackFaces& faces : polygons.cracks) {
    for (std::size_t i = 0; i + 1 < faces.lower.size(); ++i) {
      const mesh::Edge below{faces.lower[i + 1], faces.lower[i]}, above{faces.upper[i], faces.upper[i + 1]};
      if (of_tips.contains(below)) opposite.insert(above);
      if (of_tips.contains(above)) opposite.insert(below);
    }
  }
  return opposite;
}

/// On a coarse tip polygon the edges' order decides K_I, and raising it costs next to nothing (measured: README).
int tip_order(const scene::Mesh& mesh) {
  if (mesh.tip_order) return *mesh.tip_order;
  return mesh.cells == scene::Cells::one ? mesh.order : mesh.order + 1;
}

}  // namespace

Body build_body(const scene::Scene& scene, Ledger& ledger) {
  Body body;
  {
    const Ledger::Visit visit(ledger, "mesh", "mesh");
    body.polygons = uncracked_mesh(scene);
    assign_materials(scene, body.polygons);
  }
  if (scene.foundation) {
    const Ledger::Visit visit(ledger, "foundation", "mesh");
    body.rock = static_cast<int>(scene.regions.size()) + 1;
    append_near_field(scene, body.rock, body.polygons);
  }
  body.discretisation = {.cut = cut_options(scene),
                         .order = scene.mesh.order,
                         .tip_order = tip_order(scene.mesh),
                         .edge_size = scene.mesh.edge_size};
  for (std::size_t i = 0; i < scene.cracks.size(); ++i) {
    const Ledger::Visit visit(ledger, "crack", "mesh");
    const scene::Crack& wanted = scene.cracks[i];
    if (wanted.through) {
      cut_through(body.polygons, wanted.path, static_cast<int>(i), body.discretisation.cut);
    } else {
      crack::insert_crack(body.polygons, {.points = wanted.path, .inner = wanted.inner}, static_cast<int>(i),
                          body.discretisation.cut);
    }
  }
  {
    Ledger::Visit visit(ledger, "mesh", "mesh");
    place_nodes(body);
    visit.add_entries(body.nodes.coordinates().size());
  }
  if (scene.material) body.materials.push_back(*scene.material);
  for (const scene::Region& region : scene.regions) body.materials.push_back(region.material);
  if (scene.foundation) body.materials.push_back(rock_of(scene));
  return body;
}

void place_nodes(Body& body) {
  const Discretisation& rule = body.discretisation;
  if (rule.edge_size) mesh::divide_long_edges(body.polygons, {.size = *rule.edge_size});
  const std::set<mesh::Edge> opposite = opposite_tip_edges(body.polygons);
  body.nodes = mesh::place_nodes(body.polygons, [&](int polygon, int edge) {
    const mesh::Polygon& owner = body.polygons.polygons[polygon];
    return owner.open || opposite.contains(owner.edge(edge)) ? rule.tip_order : rule.order;
  });
}

std::vector<PolygonEdge> find_edges(const mesh::PolygonMesh& mesh, const std::vector<mesh::Edge>& edges) {
  if (edges.empty()) return {};
  const auto key = [](const mesh::Edge& edge) {
    const auto [low, high] = std::minmax(edge[0], edge[1]);
    return (static_cast<unsigned long long>(low) << 32) | static_cast<unsigned>(high);
  };
  std::unordered_map<unsigned long long, std::size_t> wanted;
  std::vector<char> at_vertex(mesh.vertices.size(), 0);  // most edges of a body have no wanted vertex: no look-up
  for (std::size_t i = 0; i < edges.size(); ++i) {
    wanted.emplace(key(edges[i]), i);
    for (const int vertex : edges[i]) at_vertex[static_cast<std::size_t>(vertex)] = 1;
  }
  std::vector<PolygonEdge> found(edges.size());
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    const mesh::Polygon& polygon = mesh.polygons[p];
    for (int e = 0; e < polygon.edge_count(); ++e) {
      const mesh::Edge edge = polygon.edge(e);
      if (at_vertex[static_cast<std::size_t>(edge[0])] == 0 || at_vertex[static_cast<std::size_t>(edge[1])] == 0)
        continue;
      const auto match = wanted.find(key(edge));
      if (match != wanted.end()) found[match->second] = {static_cast<int>(p), e};
    }
  }
  return found;
}

std::vector<int> boundary_nodes(const Body& body, const std::string& boundary) {
  std::vector<int> nodes;
  for (const PolygonEdge& place : find_edges(body.polygons, body.polygons.boundaries.at(boundary))) {
    const std::vector<int> on_edge = body.nodes.edge_nodes(place.polygon, place.edge);
    nodes.insert(nodes.end(), on_edge.begin(), on_edge.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace sunder::simulation
