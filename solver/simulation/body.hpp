#pragma once
/// The body of a scene: its polygons with the cracks in them, its nodes and its materials.

#include <optional>
#include <string>
#include <vector>

#include "solver/crack/cut_options.hpp"
#include "solver/material/isotropic.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/ledger.hpp"

namespace sunder::simulation {

/// How the polygons are cut and where their nodes stand: what growth has to keep to.
struct Discretisation {
  crack::CutOptions cut;
  int order = 1;                    ///< on polygon edges
  int tip_order = 1;                ///< on the edges of crack polygons
  std::optional<double> edge_size;  ///< edges longer than this are divided [m]
};

struct Body {
  mesh::PolygonMesh polygons;
  Discretisation discretisation;
  mesh::NodalMesh nodes;                       ///< of `polygons`, by place_nodes(body)
  std::vector<material::Isotropic> materials;  ///< by mesh::Polygon::material; the first is the scene's own
  int rock = -1;  ///< material of the foundation's near field, -1 where the scene has no foundation

  int dofs() const { return 2 * nodes.node_count(); }
};

/// Meshes the scene, cuts its cracks and places the nodes. Throws mesh::MeshError, crack::CrackError or
/// scene::SceneError where that cannot be done.
[[nodiscard]] Body build_body(const scene::Scene& scene, Ledger& ledger);

/// Divides what is longer than the discretisation allows and places the nodes.
void place_nodes(Body& body);

/// An edge of a polygon of the mesh.
struct PolygonEdge {
  int polygon = -1, edge = -1;
};

/// Where each of `edges` (by its vertices, in either sense) lies; both -1 where no polygon has it.
[[nodiscard]] std::vector<PolygonEdge> find_edges(const mesh::PolygonMesh& mesh, const std::vector<mesh::Edge>& edges);

/// The nodes of a named boundary, each once, ascending.
[[nodiscard]] std::vector<int> boundary_nodes(const Body& body, const std::string& boundary);

}  // namespace sunder::simulation
