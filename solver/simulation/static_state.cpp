#include "solver/simulation/static_state.hpp"

#include <complex>

#include "solver/fracture/kink_angle.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/simulation/standing_water.hpp"
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

}  // namespace

double StaticState::strain_energy() const {
  const Eigen::VectorXd& u = solution.displacement;
  return 0.5 * u.dot(stiffness.selfadjointView<Eigen::Lower>() * u) + interior.energy;
}

double StaticState::potential_energy() const {
  // Of the fields inside the polygons, the loads' work is twice their energy.
  return strain_energy() - force.dot(solution.displacement) - 2.0 * interior.energy;
}

StaticState static_state(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                         const Supports& supports, numerics::ThreadPool& pool, Ledger& ledger,
                         const std::optional<EarlierLoads>& earlier) {
  StaticState state;
  {
    Ledger::Visit visit(ledger, "sbfem", "polygons");
    state.stiffness = sbfem::assemble_stiffness(body.nodes, formation, &pool);
    state.interior = interior_loads(scene, body, formation, pool, earlier);
    visit.add_entries(state.stiffness.nonZeros());
  }
  state.force = boundary_forces(scene, body) + state.interior.force + crack_face_forces(scene, body);
  {
    Ledger::Visit visit(ledger, "numerics", "solution");
    const StaticEquations equations(state.stiffness, supports.constraints);
    ledger.count("factorisations");
    visit.add_entries(equations.factor().entries());
    if (scene.contact && equations.ready()) {
      Ledger::Visit touching(ledger, "contact", "contact");
      state.contact = solve_with_contact(*scene.contact, body, equations, state.force);
      touching.add_entries(state.contact->matrix_entries);
      ledger.count("contact iterations", state.contact->contact.iterations);
      state.solution = state.contact->solution;
    } else {
      state.solution = equations.solve(state.force);
    }
  }
  return state;
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

void add_static_quantities(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                           const Supports& supports, const StaticState& state, Ledger& ledger,
                           results::RunSummary& summary) {
  const Eigen::VectorXd& u = state.solution.displacement;
  summary.quantities["strain_energy"] = state.strain_energy();
  summary.quantities["max_displacement"] = std::sqrt(u.reshaped(2, u.size() / 2).colwise().squaredNorm().maxCoeff());
  summary.quantities["residual"] = state.solution.residual;
  summary.quantities["reactions"] = reactions(scene, supports, state.solution.reaction);
  if (state.contact) {
    summary.quantities["contact"] = contact_quantity(*state.contact);
    if (!state.contact->holds()) summary.status = "stopped: contact of the crack faces: " + state.contact->reason();
  }
  if (scene.crack_water) warn_of_dry_cracks(scene, body, summary);
  if (!scene.cracks.empty()) {
    const Ledger::Visit visit(ledger, "fracture", "tips");
    add_cracks(scene, body, formation, u, summary);
  }
}

}  // namespace sunder::simulation
