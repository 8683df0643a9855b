/// The patch test of order p: equilibrium polynomials prescribed on the outer boundary of a meshed body.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/static_solution.hpp"
#include "verification/harness/studies/exact_fields.hpp"
#include "verification/harness/studies/free_body.hpp"
#include "verification/harness/studies/interior_stress.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/scene_of_study.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using mesh::Point;

/// Moves the body: `scale`, `rotation` [degrees], `shift` [m, along x and y]; `renumber` = 1 counts vertices and
/// polygons of a listed mesh from the other end.
void place_body(const StudyInput& input, scene::Scene& scene) {
  const double scale = number_parameter(input, "scale", 1.0), shift = number_parameter(input, "shift", 0.0);
  const double angle = number_parameter(input, "rotation", 0.0) * std::numbers::pi / 180.0;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const auto move = [&](std::vector<Point>& points) {
    for (Point& point : points) point = (scale * turn * point + Point(shift, shift)).eval();
  };
  if (scene.geometry) move(scene.geometry->outline);
  if (scene.mesh.size) *scene.mesh.size *= scale;
  if (!scene.mesh.list) return;
  scene::PolygonList& list = *scene.mesh.list;
  move(list.vertices);
  if (number_parameter(input, "renumber", 0.0) == 0.0) return;
  const int last = static_cast<int>(list.vertices.size()) - 1;
  std::reverse(list.vertices.begin(), list.vertices.end());
  std::reverse(list.polygons.begin(), list.polygons.end());
  for (std::vector<int>& polygon : list.polygons) {
    for (int& vertex : polygon) vertex = last - vertex;
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
  for (auto& [name, edges] : list.boundaries) {
    for (mesh::Edge& edge : edges) edge = {last - edge[0], last - edge[1]};
  }
}

/// The edges that belong to one polygon only.
std::vector<simulation::PolygonEdge> outer_edges(const mesh::PolygonMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<simulation::PolygonEdge>> owners;
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    for (int e = 0; e < mesh.polygons[i].edge_count(); ++e) {
      const mesh::Edge edge = mesh.polygons[i].edge(e);
      owners[std::minmax(edge[0], edge[1])].push_back({i, e});
    }
  }
  std::vector<simulation::PolygonEdge> outer;
  for (const auto& [edge, of] : owners)
    if (of.size() == 1) outer.push_back(of.front());
  return outer;
}

struct Patch {
  simulation::Body body;
  std::vector<simulation::PolygonEdge> outer;
  Eigen::SparseMatrix<double> stiffness;
  Point middle;       ///< [m]
  double size = 1.0;  ///< half the longer side of the box around the body [m]
};

struct PatchErrors {
  double displacement = 0.0, reaction = 0.0, residual = 0.0;
};

VectorXd exact_forces(const Patch& patch, const PlacedField& field) {
  const Eigen::Matrix2Xd& x = patch.body.nodes.coordinates();
  VectorXd f = VectorXd::Zero(x.size());
  for (const simulation::PolygonEdge& edge : patch.outer) {
    const std::vector<int> nodes = patch.body.nodes.edge_nodes(edge.polygon, edge.edge);
    const int order = static_cast<int>(nodes.size()) - 1;
    const VectorXd share = edge_force(field, x.col(nodes.front()), x.col(nodes.back()), order);
    for (int i = 0; i <= order; ++i) f.segment<2>(2 * nodes[i]) += share.segment<2>(2 * i);
  }
  return f;
}

double exact_energy(const Patch& patch, const PlacedField& field, int degree) {
  const Eigen::Matrix2Xd& x = patch.body.nodes.coordinates();
  double work = 0.0;
  for (const simulation::PolygonEdge& edge : patch.outer) {
    const std::vector<int> nodes = patch.body.nodes.edge_nodes(edge.polygon, edge.edge);
    work += edge_work(field, x.col(nodes.front()), x.col(nodes.back()), degree);
  }
  return 0.5 * work;
}

simulation::StaticSolution solve(const Patch& patch, const PlacedField& field) {
  const VectorXd exact = displacements(field, patch.body.nodes.coordinates());
  simulation::Constraints constraints(patch.body.dofs());
  for (const simulation::PolygonEdge& edge : patch.outer) {
    for (const int node : patch.body.nodes.edge_nodes(edge.polygon, edge.edge)) {
      for (const int dof : {2 * node, 2 * node + 1}) constraints.prescribe(dof, exact[dof]);
    }
  }
  return simulation::solve_static(patch.stiffness, VectorXd::Zero(patch.body.dofs()), constraints);
}

/// Largest difference of stress at four points of every edge's sector, over the largest exact stress.
double stress_error(const Patch& patch, const PlacedField& field, const VectorXd& u) {
  StressDifference worst;
  for (int i = 0; i < patch.body.nodes.polygon_count(); ++i) {
    const mesh::NodalPolygon polygon = patch.body.nodes.polygon(i);
    const sbfem::Boundary boundary = sbfem::boundary_of(patch.body.nodes, i);
    const material::Isotropic& material = patch.body.materials[polygon.material];
    const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, material);
    VectorXd local(2 * polygon.nodes.size());
    for (std::size_t k = 0; k < polygon.nodes.size(); ++k) local.segment<2>(2 * k) = u.segment<2>(2 * polygon.nodes[k]);
    worst.include(interior_stress_difference(boundary, coefficients, sbfem::solve_polygon(coefficients), local,
                                             material, polygon.scaling_centre, field));
  }
  return worst.difference / worst.exact;
}

void add_rigid_motions(const Patch& patch, results::Quantity& quantities) {
  const MatrixXd rigid = rigid_motions(patch.body.nodes.coordinates(), patch.middle);
  const auto K = patch.stiffness.selfadjointView<Eigen::Lower>();
  const MatrixXd force = K * rigid;
  quantities["rigid_error"] = force.colwise().norm().maxCoeff() / patch.stiffness.norm();
  constexpr Eigen::Index largest_dense = 400;
  if (rigid.rows() > largest_dense) return;
  const VectorXd spectrum = scaled_spectrum(MatrixXd(patch.stiffness).selfadjointView<Eigen::Lower>());
  const double top = spectrum[spectrum.size() - 1];
  quantities["rank_deficiency"] = static_cast<double>((spectrum.array() < 1e-11 * top).count());
}

void run_fields(const StudyInput& input, const Patch& patch, results::RunSummary& summary) {
  const int degree = whole_parameter(input, "degree", 1);
  std::vector<PlacedField> fields = polynomial_fields(patch.body.materials.front(), degree, patch.middle, patch.size);
  fields.push_back(sum_of(fields));
  PatchErrors worst;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const simulation::StaticSolution solution = solve(patch, fields[i]);
    if (solution.status != numerics::FactorStatus::factorised) {
      summary.status = "stopped: the stiffness matrix is not positive definite";
      return;
    }
    const VectorXd exact = displacements(fields[i], patch.body.nodes.coordinates()),
                   force = exact_forces(patch, fields[i]);
    const auto largest = [](const VectorXd& values) { return values.lpNorm<Eigen::Infinity>(); };
    worst.displacement = std::fmax(worst.displacement, largest(solution.displacement - exact) / largest(exact));
    worst.residual = std::fmax(worst.residual, solution.residual);
    if (i != 1)  // the rotation has no force to compare with
      worst.reaction = std::fmax(worst.reaction, (solution.reaction - force).norm() / force.norm());
    if (i + 1 < fields.size()) continue;
    const VectorXd& u = solution.displacement;
    const double energy = 0.5 * u.dot(patch.stiffness.selfadjointView<Eigen::Lower>() * u);
    summary.quantities["energy_error"] = std::abs(energy / exact_energy(patch, fields[i], degree) - 1.0);
    summary.quantities["stress_error"] = stress_error(patch, fields[i], u);
  }
  summary.quantities["displacement_error"] = worst.displacement;
  summary.quantities["reaction_error"] = worst.reaction;
  summary.quantities["residual"] = worst.residual;
}

results::RunSummary run_patch(const StudyInput& input, const scene::Scene& scene) {
  results::RunSummary summary;
  simulation::Ledger ledger;
  Patch patch{.body = simulation::build_body(scene, ledger), .outer = {}, .stiffness = {}, .middle = Point::Zero()};
  {
    const simulation::Ledger::Visit visit(ledger, "sbfem", "polygons");
    const Eigen::Matrix2Xd& x = patch.body.nodes.coordinates();
    patch.outer = outer_edges(patch.body.polygons);
    patch.middle = 0.5 * (x.rowwise().minCoeff() + x.rowwise().maxCoeff());
    patch.size = 0.5 * (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
    const sbfem::Formation formation = sbfem::form(patch.body.nodes, patch.body.materials);
    if (formation.summary().failed_count > 0) {
      summary.status = "stopped: polygon " + std::to_string(formation.summary().worst_polygon) + " has not converged";
    } else {
      patch.stiffness = sbfem::assemble_stiffness(patch.body.nodes, formation);
    }
  }
  summary.mesh = {patch.body.nodes.polygon_count(), patch.body.nodes.node_count(), patch.body.dofs()};
  if (summary.completed()) {
    const simulation::Ledger::Visit visit(ledger, "numerics", "solution");
    add_rigid_motions(patch, summary.quantities);
    run_fields(input, patch, summary);
  }
  ledger.close(summary);
  return summary;
}

}  // namespace

StudyOutput run_polynomial_patch(const StudyInput& input) {
  return run_with_scene(input, [&](scene::Scene& scene) {
    place_body(input, scene);
    return run_patch(input, scene);
  });
}

}  // namespace sunder::verification
