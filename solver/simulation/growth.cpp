#include "solver/simulation/growth.hpp"

#include <cmath>

#include "solver/simulation/constraints.hpp"

namespace sunder::simulation {

Growth grow(const Body& body, const sbfem::Formation& formation, int tip, const mesh::Point& to,
            numerics::ThreadPool* pool) {
  Growth growth;
  growth.body.polygons = body.polygons;
  crack::Advance advance = crack::advance_tip(growth.body.polygons, tip, to, body.discretisation.cut);
  growth.event = advance.event;
  growth.reason = std::move(advance.reason);
  growth.tip = advance.tip;
  if (growth.event == crack::TipEvent::refused) {
    growth.body = {};
    return growth;
  }
  growth.report = std::move(advance.report);
  growth.body.discretisation = body.discretisation;
  growth.body.materials = body.materials;
  place_nodes(growth.body);
  growth.same = sbfem::same_polygons(growth.body.nodes, body.nodes, growth.report.polygon_from);
  growth.formation = sbfem::form_again(growth.body.nodes, growth.body.materials,
                                       {.with_mass = formation.has_mass(), .pool = pool}, formation, growth.same);
  return growth;
}

int part_count(const mesh::NodalMesh& mesh) {
  int count = 0;
  parts_of(mesh, count);
  return count;
}

std::string boundary_at(const mesh::PolygonMesh& mesh, const mesh::Point& place) {
  for (const auto& [name, edges] : mesh.boundaries) {
    for (const mesh::Edge& edge : edges) {
      if (mesh.vertices[edge[0]] == place || mesh.vertices[edge[1]] == place) return name;
    }
  }
  return {};
}

double crack_length(const mesh::PolygonMesh& mesh, int tip) {
  const mesh::CrackFaces& faces = mesh.cracks[tip];
  double length = 0.0;
  for (std::size_t i = 1; i < faces.lower.size(); ++i) {
    length += (mesh.vertices[faces.lower[i]] - mesh.vertices[faces.lower[i - 1]]).norm();
  }
  if (faces.tip_polygon < 0) return length;
  return length + (mesh.polygons[faces.tip_polygon].scaling_centre - mesh.vertices[faces.lower.back()]).norm();
}

double tip_direction(const mesh::PolygonMesh& mesh, int tip) {
  const mesh::CrackFaces& faces = mesh.cracks[tip];
  const mesh::Point ahead = mesh.polygons[faces.tip_polygon].scaling_centre - mesh.vertices[faces.lower.back()];
  return std::atan2(ahead.y(), ahead.x());
}

}  // namespace sunder::simulation
