#include "solver/simulation/field_snapshot.hpp"

#include "solver/sbfem/mean_strain.hpp"

namespace sunder::simulation {
namespace {

constexpr const char* displacement_name = "displacement";

using Entries = std::vector<Eigen::Triplet<double>>;

/// Rows from `first_row` on of a matrix on the dofs of the body, from one on those of a polygon.
void scatter(const Eigen::MatrixXd& local, std::span<const int> nodes, Eigen::Index first_row, Entries& entries) {
  for (Eigen::Index column = 0; column < local.cols(); ++column) {
    for (Eigen::Index row = 0; row < local.rows(); ++row) {
      if (local(row, column) == 0.0) continue;
      entries.emplace_back(static_cast<int>(first_row + row), 2 * nodes[column / 2] + static_cast<int>(column % 2),
                           local(row, column));
    }
  }
}

}  // namespace

bool wants_fields(const scene::Scene& scene) {
  return scene.output && scene.output->fields_every > 0;
}

FieldGeometry field_geometry(const Body& body, const TipLoads& tip_loads) {
  const mesh::NodalMesh& nodes = body.nodes;
  const int polygons = nodes.polygon_count();
  FieldGeometry geometry;
  geometry.mean_strain_of_loads = Eigen::VectorXd::Zero(3 * polygons);
  Entries strain_entries, tip_entries;
  std::vector<mesh::Point> tips;
  std::vector<Eigen::Vector2d> tips_of_loads;
  for (int i = 0; i < polygons; ++i) {
    const mesh::NodalPolygon polygon = nodes.polygon(i);
    const sbfem::Boundary boundary = sbfem::boundary_of(nodes, i);
    const material::Isotropic& solid = body.materials[polygon.material];
    geometry.materials.push_back(solid);
    std::vector<std::int64_t>& corners = geometry.mesh.connectivity;
    corners.insert(corners.end(), polygon.nodes.begin(), polygon.nodes.end());
    if (polygon.open) {
      const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, solid);
      const sbfem::TipField tip =
          sbfem::tip_field(boundary, coefficients, sbfem::solve_polygon(coefficients),
                           tip_loads ? tip_loads(i, boundary) : std::vector<sbfem::RadialLoad>{});
      scatter(tip.mean_strain, polygon.nodes, 3 * i, strain_entries);
      scatter(tip.tip, polygon.nodes, 2 * std::ssize(tips), tip_entries);
      geometry.mean_strain_of_loads.segment<3>(3 * i) = tip.mean_strain_of_loads;
      corners.push_back(nodes.node_count() + std::ssize(tips));
      tips.push_back(polygon.scaling_centre);
      tips_of_loads.push_back(tip.tip_of_loads);
    } else {
      scatter(sbfem::mean_strain(boundary), polygon.nodes, 3 * i, strain_entries);
    }
    geometry.mesh.offsets.push_back(std::ssize(corners));
  }

  const auto tip_count = std::ssize(tips);
  geometry.mesh.points.resize(2, nodes.node_count() + tip_count);
  geometry.mesh.points.leftCols(nodes.node_count()) = nodes.coordinates();
  geometry.tips_of_loads.resize(2 * tip_count);
  for (std::ptrdiff_t t = 0; t < tip_count; ++t) {
    geometry.mesh.points.col(nodes.node_count() + t) = tips[t];
    geometry.tips_of_loads.segment<2>(2 * t) = tips_of_loads[t];
  }
  geometry.mean_strain.resize(3 * polygons, body.dofs());
  geometry.mean_strain.setFromTriplets(strain_entries.begin(), strain_entries.end());
  geometry.tips.resize(2 * tip_count, body.dofs());
  geometry.tips.setFromTriplets(tip_entries.begin(), tip_entries.end());
  return geometry;
}

results::Field vector_field(const FieldGeometry& geometry, const std::string& name, const Eigen::VectorXd& nodal) {
  results::Field field{.name = name, .values = Eigen::MatrixXd::Zero(3, geometry.mesh.points.cols())};
  const Eigen::Index nodes = nodal.size() / 2;
  field.values.topLeftCorner(2, nodes) = nodal.reshaped(2, nodes);
  Eigen::VectorXd at_tips = geometry.tips * nodal;
  if (name == displacement_name) at_tips += geometry.tips_of_loads;
  field.values.topRightCorner(2, at_tips.size() / 2) = at_tips.reshaped(2, at_tips.size() / 2);
  return field;
}

results::Field stress_field(const FieldGeometry& geometry, const Eigen::VectorXd& displacement) {
  const Eigen::VectorXd strain = geometry.mean_strain * displacement + geometry.mean_strain_of_loads;
  const Eigen::Index polygons = strain.size() / 3;
  results::Field field{.name = "stress", .values = Eigen::MatrixXd::Zero(6, polygons)};
  for (Eigen::Index i = 0; i < polygons; ++i) {
    const material::Isotropic& solid = geometry.materials[i];
    const Eigen::Vector3d stress = material::elasticity_matrix(solid) * strain.segment<3>(3 * i);
    field.values(0, i) = stress[0];
    field.values(1, i) = stress[1];
    if (solid.plane == material::Plane::strain) field.values(2, i) = solid.poisson_ratio * (stress[0] + stress[1]);
    field.values(3, i) = stress[2];
  }
  return field;
}

}  // namespace sunder::simulation
