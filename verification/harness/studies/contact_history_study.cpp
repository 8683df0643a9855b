/// A history of loads on the faces of one crack, each solved from the answer before: against exact contact by another
/// method, and against itself, solved again.

#include <algorithm>
#include <cmath>

#include "solver/contact/contact_solver.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/exact/unilateral.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A force on the face moves it by the logarithm of the distance; smoothed by the spacing. [m²/N]
MatrixXd face_flexibility(int pairs) {
  MatrixXd F(pairs, pairs);
  for (int j = 0; j < pairs; ++j) {
    for (int i = 0; i < pairs; ++i) F(i, j) = 1e-10 * std::log(2.0 * pairs / std::hypot(i - j, 0.5));
  }
  return F;
}

/// The gap without contact [m]: a wave that runs along the crack, on an opening that comes and goes; with `flips` its
/// sign changes at every step.
VectorXd gap_at(int step, int pairs, double amplitude, bool flips) {
  VectorXd gap(pairs);
  const double sign = flips && step % 2 == 1 ? -1.0 : 1.0;
  for (int i = 0; i < pairs; ++i) {
    gap[i] = sign * amplitude * (std::sin(0.23 * step) + 0.6 * std::cos(9.0 * i / pairs + 0.11 * step));
  }
  return gap;
}

contact::ContactOptions options_of(const StudyInput& input) {
  contact::ContactOptions options;
  options.model = text_parameter(input, "model", "penalty") == "exact" ? contact::ContactModel::exact
                                                                       : contact::ContactModel::penalty;
  options.initial_stiffness = number_parameter(input, "stiffness", options.initial_stiffness);
  options.growth_factor = number_parameter(input, "growth", options.growth_factor);
  options.penetration_tolerance = number_parameter(input, "tolerance", options.penetration_tolerance);
  return options;
}

struct Found {
  double force_error = 0.0, penetration = 0.0, tension = 0.0, complementarity = 0.0;
  int enlargements = 0, pivots = 0, most_pivots = 0, changes = 0, restless = 0;
};

}  // namespace

StudyOutput run_contact_history(const StudyInput& input) {
  const int pairs = static_cast<int>(number_parameter(input, "pairs", 24.0));
  const int steps = static_cast<int>(number_parameter(input, "steps", 100.0));
  const int repeats = static_cast<int>(number_parameter(input, "repeats", 1.0));
  const double amplitude = number_parameter(input, "amplitude", 5e-3);
  const bool flips = number_parameter(input, "flips", 0.0) != 0.0;
  const bool compare = number_parameter(input, "compare", 1.0) != 0.0;
  const MatrixXd F = face_flexibility(pairs);
  StudyOutput output;
  results::RunSummary& summary = output.summary;
  simulation::Ledger ledger;
  Found found;
  {
    simulation::Ledger::Visit visit(ledger, "contact", "history");
    visit.add_entries(F.size());
    contact::ContactSolver solver(options_of(input));
    solver.set_faces(F, VectorXd::Constant(pairs, 0.25));
    for (int repeat = 1; repeat < repeats; ++repeat) {  // what a sweep times; the method that judges runs once
      solver.forget();
      for (int step = 0; step < steps; ++step) (void)solver.solve(gap_at(step, pairs, amplitude, flips));
    }
    solver.forget();
    VectorXd reference = VectorXd::Zero(pairs), force, before = VectorXd::Zero(pairs);
    double largest_force = 0.0, largest_difference = 0.0;
    for (int step = 0; step < steps; ++step) {
      const VectorXd gap = gap_at(step, pairs, amplitude, flips);
      const contact::ContactResult& result = solver.solve(gap);
      if (result.status != contact::ContactStatus::converged) {
        summary.status = "stopped: the contact of step " + std::to_string(step) + " did not converge";
        break;
      }
      force = result.pair_force;
      found.enlargements += result.enlargements;
      found.pivots += result.iterations;
      found.most_pivots = std::max(found.most_pivots, result.iterations);
      found.penetration = std::max(found.penetration, result.largest_penetration);
      found.tension = std::max(found.tension, result.largest_tension);
      found.complementarity = std::max(found.complementarity, result.complementarity);
      found.changes += static_cast<int>(((force.array() > 0.0) != (before.array() > 0.0)).count());
      before = force;
      // The same load once more: a state that is left again would be the start of a cycle.
      if (solver.solve(gap).iterations > 1 || solver.result().pair_force != force) ++found.restless;
      if (!compare) continue;
      const exact::Unilateral other = exact::projected_gauss_seidel(F, gap, reference, 1e-14, 200'000);
      reference = other.force;
      largest_force = std::max(largest_force, reference.norm());
      largest_difference = std::max(largest_difference, (force - reference).norm());
    }
    if (compare) found.force_error = largest_difference / largest_force;
  }
  if (compare) summary.quantities["force_error"] = found.force_error;
  summary.quantities["max_penetration"] = found.penetration;
  summary.quantities["largest_tension"] = found.tension;
  summary.quantities["complementarity"] = found.complementarity;
  summary.quantities["enlargements"] = found.enlargements;
  summary.quantities["pivots_per_step"] = static_cast<double>(found.pivots) / steps;
  summary.quantities["most_pivots"] = found.most_pivots;
  summary.quantities["changes"] = found.changes;
  summary.quantities["restless"] = found.restless;
  ledger.close(summary);
  return output;
}

}  // namespace sunder::verification
