#include <complex>
#include <string>

#include "solver/fracture/kink_angle.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/field_snapshot.hpp"
#include "solver/simulation/polygon_loads.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/static_solution.hpp"
#include "solver/simulation/tips.hpp"

namespace sunder::simulation {
namespace {

using results::Quantity;

Quantity pair_of(double first, double second) {
  return Quantity::List{first, second};
}

Quantity reactions(const scene::Scene& scene, const Supports& supports, const Eigen::VectorXd& reaction) {
  Quantity::List list;
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    double sum[2] = {0.0, 0.0};
    for (const int dof : supports.dofs[i]) sum[dof % 2] += reaction[dof];
    const scene::Support& support = scene.supports[i];
    Quantity::Table entry;
    if (support.point) {
      entry.emplace_back("point", pair_of(support.point->x(), support.point->y()));
    } else {
      entry.emplace_back("boundary", support.boundary);
    }
    entry.emplace_back("force", pair_of(sum[0], sum[1]));
    list.emplace_back(std::move(entry));
  }
  return list;
}

Quantity tip_quantity(const TipResult& tip) {
  const fracture::StressIntensityFactors& factors = tip.state.factors;
  Quantity::List exponents;
  for (const std::complex<double>& exponent : tip.exponents) {
    exponents.push_back(pair_of(exponent.real(), exponent.imag()));
  }
  return Quantity::Table{{"position", pair_of(tip.position.x(), tip.position.y())},
                         {"K_I", factors.K_I},
                         {"K_II", factors.K_II},
                         {"T_stress", tip.state.T_stress},
                         {"kink_angle", fracture::kink_angle(factors)},
                         {"exponents", std::move(exponents)}};
}

void add_cracks(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                const Eigen::VectorXd& displacement, results::RunSummary& summary) {
  Quantity::List tips;
  for (const TipResult& tip : tip_results(scene, body, formation, displacement)) {
    if (tip.status == fracture::TipStatus::not_a_crack) {
      summary.status = "stopped: the crack polygon at (" + std::to_string(tip.position.x()) + ", " +
                       std::to_string(tip.position.y()) + ") has no pair of singular exponents; refine its edges";
    }
    tips.push_back(tip_quantity(tip));
  }
  summary.quantities["tips"] = std::move(tips);
  const std::vector<double> openings = mouth_openings(scene, body, displacement);
  summary.quantities["crack_mouth_opening"] = openings.size() == 1 ? Quantity(openings.front()) : Quantity(openings);
}

void write_fields(const scene::Scene& scene, const Body& body, const RunOptions& options,
                  const Eigen::VectorXd& displacement, Ledger& ledger) {
  Ledger::Visit visit(ledger, "results", "fields");
  const FieldGeometry geometry = field_geometry(body, [&](int polygon, const sbfem::Boundary& boundary) {
    return polygon_loads(scene, body, polygon, boundary);
  });
  results::FieldFile file(options.output / field_file_name);
  file.begin_mesh(geometry.mesh);
  file.append(0.0, {.point_data = {vector_field(geometry, "displacement", displacement)},
                    .cell_data = {stress_field(geometry, displacement)}});
  file.commit();
  visit.add_entries(3 * geometry.mesh.point_count() + 6 * geometry.mesh.polygon_count());
}

std::string stopping_reason(const Body& body, const StaticSolution& solution) {
  if (solution.status == numerics::FactorStatus::too_large) {
    return "stopped: the factor of the stiffness matrix does not fit into memory or 32-bit indices; use a larger "
           "mesh.size";
  }
  const mesh::Point place = body.nodes.coordinates().col(solution.failed_dof / 2);
  return "stopped: the stiffness matrix is not positive definite at the node (" + std::to_string(place.x()) + ", " +
         std::to_string(place.y()) + "); a part of the body hangs by round-off only";
}

}  // namespace

void run_static(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                Ledger& ledger, results::RunSummary& summary) {
  const auto report = [&](std::string_view phase, double fraction) {
    if (options.progress) options.progress(phase, fraction);
  };
  const Supports supports = supports_of(scene, body, false);

  report("polygons", 0.2);
  sbfem::Formation formation;
  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd force = boundary_forces(scene, body);
  double interior_energy = 0.0;
  {
    Ledger::Visit visit(ledger, "sbfem", "polygons");
    formation = sbfem::form(body.nodes, body.materials, {.pool = &pool});
    stiffness = sbfem::assemble_stiffness(body.nodes, formation, &pool);
    const InteriorLoads interior = interior_loads(scene, body, formation, pool);
    force += interior.force + crack_face_forces(scene, body);
    interior_energy = interior.energy;
    visit.add_entries(stiffness.nonZeros());
  }

  report("solution", 0.5);
  const StaticSolution solution = [&] {
    Ledger::Visit visit(ledger, "numerics", "solution");
    StaticSolution result = solve_static(stiffness, force, supports.constraints);
    visit.add_entries(result.factor_entries);
    return result;
  }();
  ledger.count("factorisations");
  if (solution.status != numerics::FactorStatus::factorised) {
    summary.status = stopping_reason(body, solution);
    return;
  }

  report("quantities", 0.9);
  const Eigen::VectorXd& u = solution.displacement;
  summary.quantities["strain_energy"] = 0.5 * u.dot(stiffness.selfadjointView<Eigen::Lower>() * u) + interior_energy;
  summary.quantities["max_displacement"] = std::sqrt(u.reshaped(2, u.size() / 2).colwise().squaredNorm().maxCoeff());
  summary.quantities["residual"] = solution.residual;
  summary.quantities["reactions"] = reactions(scene, supports, solution.reaction);
  if (!scene.cracks.empty()) {
    const Ledger::Visit visit(ledger, "fracture", "tips");
    add_cracks(scene, body, formation, u, summary);
  }
  if (wants_fields(scene)) {
    report("fields", 0.95);
    write_fields(scene, body, options, u, ledger);
  }
}

}  // namespace sunder::simulation
