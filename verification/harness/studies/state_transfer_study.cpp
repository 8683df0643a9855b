/// Growth events along a given path, and what each of them does to the fields on the nodes.

#include <algorithm>
#include <cmath>

#include "solver/crack/crack_faces.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/state_transfer.hpp"
#include "solver/simulation/static_state.hpp"
#include "solver/simulation/tips.hpp"
#include "verification/harness/studies/scene_of_study.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using Eigen::MatrixXd;
using mesh::Point;
using simulation::Body;

/// Translations, rotation, and a uniform tension along the direction of the crack at its tip, which leaves its faces
/// free of traction.
MatrixXd linear_fields(const Body& body, double direction) {
  const Eigen::Matrix3d D = material::elasticity_matrix(body.materials.front());
  const mesh::Point t(std::cos(direction), std::sin(direction)), n(-t.y(), t.x());
  const double contraction = D(0, 1) / D(0, 0);
  MatrixXd fields(body.dofs(), 4);
  for (int i = 0; i < body.nodes.node_count(); ++i) {
    const mesh::Point x = body.nodes.coordinates().col(i), stretch = x.dot(t) * t - contraction * x.dot(n) * n;
    fields.row(2 * i) << 1.0, 0.0, -x.y(), stretch.x();
    fields.row(2 * i + 1) << 0.0, 1.0, x.x(), stretch.y();
  }
  return fields;
}

/// Largest difference between blocks that were taken over or formed and all formed anew, over the largest entry.
double reuse_difference(const simulation::Growth& growth) {
  const sbfem::Formation anew =
      sbfem::form(growth.body.nodes, growth.body.materials, {.with_mass = growth.formation.has_mass()});
  double difference = 0.0, largest = 0.0;
  for (int i = 0; i < anew.polygon_count(); ++i) {
    difference = std::max(difference, (anew.stiffness(i) - growth.formation.stiffness(i)).cwiseAbs().maxCoeff());
    largest = std::max(largest, anew.stiffness(i).cwiseAbs().maxCoeff());
  }
  return difference / largest;
}

struct Worst {
  double reuse = 0.0, linear = 0.0, rigid_energy = 0.0, new_opening = 0.0;
  double old_opening = 1.0;  ///< least opening of the old faces over the square root profile of an edge crack
  std::vector<double> strain_change, kinetic_change;  ///< of the state, over its energy
  double reused_share = 1.0;
};

void look_at_faces(const Body& before, const Eigen::VectorXd& old_state, const Body& after, const MatrixXd& state,
                   Worst& worst) {
  const crack::CrackPairs old_pairs = crack::crack_pairs(before.polygons, before.nodes, 0);
  const crack::CrackPairs pairs = crack::crack_pairs(after.polygons, after.nodes, 0);
  const double mouth = crack::crack_motion(old_pairs, old_state).opening[0], length = old_pairs.tip_position;
  const crack::CrackMotion motion = crack::crack_motion(pairs, state.col(0));
  for (int i = 0; i < pairs.count(); ++i) {
    const double s = pairs.position[i] / length, opening = motion.opening[i] / mouth;
    if (s > 1.0 - 1e-9) {
      worst.new_opening = std::max(worst.new_opening, std::abs(opening));
    } else {
      worst.old_opening = std::min(worst.old_opening, opening / std::sqrt(1.0 - s));
    }
  }
}

results::RunSummary follow(const StudyInput& input, const scene::Scene& scene) {
  const int steps = static_cast<int>(number_parameter(input, "steps"));
  const double increment = number_parameter(input, "increment"), turn = number_parameter(input, "turn");
  simulation::Ledger ledger;
  numerics::ThreadPool pool(input.threads);
  Body body = simulation::build_body(scene, ledger);
  sbfem::Formation formation;
  {
    const simulation::Ledger::Visit visit(ledger, "sbfem", "polygons");
    formation = sbfem::form(body.nodes, body.materials, {.with_mass = true, .pool = &pool});
  }
  Worst worst;
  results::RunSummary summary;
  for (int step = 0; step < steps; ++step) {
    const simulation::Supports supports = simulation::supports_of(scene, body, false);
    const Eigen::VectorXd u =
        simulation::static_state(scene, body, formation, supports, pool, ledger).solution.displacement;
    const int tip_polygon = body.polygons.cracks[0].tip_polygon;
    const double angle = simulation::tip_direction(body.polygons, 0) + (step % 2 == 0 ? turn : -turn);
    const Point to = body.polygons.polygons[static_cast<std::size_t>(tip_polygon)].scaling_centre +
                     increment * Point(std::cos(angle), std::sin(angle));
    simulation::Growth growth;
    {
      const simulation::Ledger::Visit visit(ledger, "crack", "growth");
      growth = simulation::grow(body, formation, 0, to, &pool);
    }
    if (growth.event != crack::TipEvent::advanced) {
      summary.status = "stopped: " + growth.reason;
      break;
    }
    worst.reuse = std::max(worst.reuse, reuse_difference(growth));
    worst.reused_share = std::min(worst.reused_share, static_cast<double>(growth.formation.summary().reused_count) /
                                                          growth.formation.polygon_count());
    const double direction = simulation::tip_direction(body.polygons, 0);
    MatrixXd fields(body.dofs(), 5);
    fields << linear_fields(body, direction), u;
    const simulation::TransferredFields moved =
        simulation::transfer_fields(body, formation, growth.body, growth.same, growth.report, fields);
    const simulation::TransferredEnergies energies = simulation::transferred_energies(
        {body, formation, fields}, {growth.body, growth.formation, moved.values}, growth.same);
    const MatrixXd exact = linear_fields(growth.body, direction);
    worst.linear =
        std::max(worst.linear, (moved.values.leftCols(4) - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff());
    worst.rigid_energy = std::max(
        worst.rigid_energy, energies.strain_energy_change.head(3).cwiseAbs().maxCoeff() / energies.strain_energy[3]);
    worst.strain_change.push_back(energies.strain_energy_change[4] / energies.strain_energy[4]);
    worst.kinetic_change.push_back(energies.kinetic_energy_change[4] / energies.kinetic_energy[4]);
    look_at_faces(body, u, growth.body, moved.values.rightCols(1), worst);
    body = std::move(growth.body);
    formation = std::move(growth.formation);
  }
  summary.mesh = {.polygons = body.nodes.polygon_count(), .nodes = body.nodes.node_count(), .dofs = body.dofs()};
  summary.quantities["reuse_difference"] = worst.reuse;
  summary.quantities["reused_share"] = worst.reused_share;
  summary.quantities["linear_error"] = worst.linear;
  summary.quantities["rigid_energy"] = worst.rigid_energy;
  summary.quantities["new_opening"] = worst.new_opening;
  summary.quantities["old_opening"] = worst.old_opening;
  summary.quantities["strain_energy_change"] = results::Quantity(worst.strain_change);
  summary.quantities["kinetic_energy_change"] = results::Quantity(worst.kinetic_change);
  ledger.close(summary);
  return summary;
}

}  // namespace

StudyOutput run_state_transfer(const StudyInput& input) {
  return run_with_scene(input, [&](const scene::Scene& scene) { return follow(input, scene); });
}

}  // namespace sunder::verification
