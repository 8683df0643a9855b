#include <complex>
#include <optional>
#include <string>

#include "solver/fracture/kink_angle.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/polygon_loads.hpp"
#include "solver/simulation/standing_water.hpp"
#include "solver/simulation/static_contact.hpp"
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

void warn_of_dry_cracks(const scene::Scene& scene, const Body& body, results::RunSummary& summary) {
  for (int tip = 0; tip < static_cast<int>(body.polygons.cracks.size()); ++tip) {
    if (resting_water(scene, body, tip)) return;
  }
  summary.warnings.push_back(
      "[crack_water] presses on no crack: no mouth lies on the reservoir's boundary below its level");
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
  std::optional<StaticContact> touching;
  StaticSolution solution;
  {
    Ledger::Visit visit(ledger, "numerics", "solution");
    const StaticEquations equations(stiffness, supports.constraints);
    ledger.count("factorisations");
    visit.add_entries(equations.factor().entries());
    if (scene.contact && equations.ready()) {
      Ledger::Visit contact(ledger, "contact", "contact");
      touching = solve_with_contact(*scene.contact, body, equations, force);
      contact.add_entries(touching->matrix_entries);
      ledger.count("contact iterations", touching->contact.iterations);
      solution = touching->solution;
    } else {
      solution = equations.solve(force);
    }
  }
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
  if (touching) {
    summary.quantities["contact"] = contact_quantity(*touching);
    if (!touching->holds()) summary.status = "stopped: contact of the crack faces: " + touching->reason();
  }
  if (scene.crack_water) warn_of_dry_cracks(scene, body, summary);
  if (!scene.cracks.empty()) {
    const Ledger::Visit visit(ledger, "fracture", "tips");
    add_cracks(scene, body, formation, u, summary);
  }
}

}  // namespace sunder::simulation
