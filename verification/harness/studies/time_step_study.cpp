/// The step in time on bodies so small that their motion is known: an oscillator, and a rod on a moving base.

#include <cmath>
#include <numbers>

#include "solver/simulation/ledger.hpp"
#include "solver/simulation/step_equations.hpp"
#include "verification/exact/oscillator.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using Eigen::Index;

/// Nodes in a row that move in x; y is held.
struct Chain {
  Eigen::SparseMatrix<double> stiffness, mass;  // lower triangles
  simulation::Constraints constraints;
};

Chain oscillator(double omega) {
  Chain chain{.stiffness = Eigen::SparseMatrix<double>(2, 2),
              .mass = Eigen::SparseMatrix<double>(2, 2),
              .constraints = simulation::Constraints(2)};
  const std::vector<Eigen::Triplet<double>> unit{{0, 0, 1.0}, {1, 1, 1.0}};
  chain.mass.setFromTriplets(unit.begin(), unit.end());  // compressed, as the step wants them
  chain.stiffness = omega * omega * chain.mass;
  chain.constraints.prescribe(1, 0.0);
  return chain;
}

/// Linear elements of equal length, the first node held; E, density and section of one: wave speed 1, length 1.
Chain rod(int elements) {
  const Index dofs = 2 * (elements + 1);
  const double length = 1.0 / elements;
  Chain chain{.stiffness = Eigen::SparseMatrix<double>(dofs, dofs),
              .mass = Eigen::SparseMatrix<double>(dofs, dofs),
              .constraints = simulation::Constraints(static_cast<int>(dofs))};
  std::vector<Eigen::Triplet<double>> k, m;
  for (int node = 0; node <= elements; ++node) {
    const double shares = node == 0 || node == elements ? 1.0 : 2.0;
    const int x = 2 * node;
    for (int dof : {x, x + 1}) {
      k.emplace_back(dof, dof, shares / length);
      m.emplace_back(dof, dof, shares * length / 3.0);
    }
    if (node < elements) {
      k.emplace_back(x + 2, x, -1.0 / length);
      m.emplace_back(x + 2, x, length / 6.0);
    }
    chain.constraints.prescribe(x + 1, 0.0);
  }
  chain.constraints.prescribe(0, 0.0);
  chain.stiffness.setFromTriplets(k.begin(), k.end());
  chain.mass.setFromTriplets(m.begin(), m.end());
  return chain;
}

dynamics::TimeScheme scheme_of(const StudyInput& input) {
  const std::string name = text_parameter(input, "integrator", "newmark");
  if (name == "newmark") return dynamics::newmark();
  const double radius = number_parameter(input, "spectral_radius");
  if (name == "hht-alpha") return dynamics::hht_alpha(radius);
  if (name == "generalised-alpha") return dynamics::generalised_alpha(radius);
  throw std::invalid_argument("integrator \"" + name + "\" is unknown");
}

/// α M, β K, or both with the same ratio at ω and 3 ω: the ratio at ω is the one asked for in each.
dynamics::Rayleigh damping_of(const StudyInput& input, double omega) {
  const double ratio = number_parameter(input, "damping_ratio", 0.0);
  if (ratio == 0.0) return {};
  const std::string kind = text_parameter(input, "damping", "both");
  if (kind == "stiffness") return dynamics::stiffness_proportional(ratio, omega);
  if (kind == "both") return dynamics::rayleigh(ratio, omega, 3.0 * omega);
  throw std::invalid_argument("damping \"" + kind + "\" is unknown; accepted: stiffness, both");
}

struct Drive {
  std::string kind;  // "free", "force", "ground", "pulse"
  double amplitude = 1.0, forcing = 0.0, duration = 1.0;

  double force(double time) const { return kind == "force" ? amplitude * std::sin(forcing * time) : 0.0; }
  double ground(double time) const {
    if (kind == "ground") return amplitude * std::sin(forcing * time);
    return kind == "pulse" ? exact::smooth_pulse_acceleration(amplitude, duration, time) : 0.0;
  }
};

double energy(const Chain& chain, const simulation::MotionState& state) {
  return 0.5 * state.displacement.dot(chain.stiffness.selfadjointView<Eigen::Lower>() * state.displacement) +
         0.5 * state.velocity.dot(chain.mass.selfadjointView<Eigen::Lower>() * state.velocity);
}

struct March {
  const Chain& chain;
  const Drive& drive;
  simulation::MotionState state, next;
  simulation::StepLoad start, end;
  double first_energy = 0.0, drift = 0.0, largest = 0.0;
  Index watched = 0;

  void load(simulation::StepLoad& at, double time) const {
    at.force[watched] = drive.force(time);
    at.ground.x() = drive.ground(time);
  }

  /// False where the matrix of the step cannot be factorised.
  bool go(const simulation::StepOptions& options, long long steps, simulation::Ledger& ledger) {
    simulation::StepEquations equations(chain.stiffness, chain.mass, chain.constraints, {}, options);
    ledger.count("factorisations");
    if (equations.status() != numerics::FactorStatus::factorised) return false;
    const double begun = state.time;
    load(start, begun);
    equations.stand_at(state);
    for (long long step = 1; step <= steps; ++step) {
      const double time = begun + options.time_step * static_cast<double>(step);
      load(end, time);
      equations.advance(state, equations.trial(state, start, end), next);
      equations.accept(next, end.ground, {});
      std::swap(state, next);
      std::swap(start, end);
      state.time = time;
      largest = std::fmax(largest, std::abs(state.displacement[watched]));
      if (first_energy > 0.0 && (step % 64 == 0 || step == steps))
        drift = std::fmax(drift, std::abs(energy(chain, state) / first_energy - 1.0));
    }
    ledger.count("steps", steps);
    return true;
  }
};

}  // namespace

StudyOutput run_time_step(const StudyInput& input) {
  StudyOutput output;
  simulation::Ledger ledger;
  const bool of_rod = text_parameter(input, "body", "oscillator") == "rod";
  const double omega = number_parameter(input, "omega", 2.0 * std::numbers::pi);
  const Chain chain = of_rod ? rod(static_cast<int>(number_parameter(input, "elements"))) : oscillator(omega);
  const Drive drive{.kind = text_parameter(input, "drive", "free"),
                    .amplitude = number_parameter(input, "amplitude", 1.0),
                    .forcing = number_parameter(input, "forcing", 0.0),
                    .duration = number_parameter(input, "pulse_duration", 1.0)};
  const auto steps = static_cast<long long>(number_parameter(input, "steps"));
  simulation::StepOptions options{
      .scheme = scheme_of(input),
      .time_step =
          number_parameter(input, "time_step", number_parameter(input, "duration", 0.0) / static_cast<double>(steps)),
      .damping = damping_of(input, omega)};
  if (!(options.time_step > 0.0)) throw std::invalid_argument("time_step must be > 0");

  const Index dofs = chain.mass.rows();
  March march{.chain = chain, .drive = drive, .state = {}, .next = {}, .start = {}, .end = {}};
  for (Eigen::VectorXd* values : {&march.state.displacement, &march.state.velocity, &march.state.acceleration,
                                  &march.start.force, &march.end.force}) {
    values->setZero(dofs);
  }
  march.watched = of_rod ? dofs - 2 : 0;
  if (drive.kind == "free") {  // an oscillator let go at 1 m; every other drive begins at rest without a load
    march.state.displacement[0] = 1.0;
    march.state.acceleration[0] = -omega * omega;
  }
  march.next = march.state;
  march.first_energy = energy(chain, march.state);
  bool found = false;
  {
    const simulation::Ledger::Visit visit(ledger, "dynamics", "steps");
    found = march.go(options, steps, ledger);
    const double jump = number_parameter(input, "step_jump", 1.0);
    if (found && jump != 1.0) {  // as many steps again of another length
      options.time_step *= jump;
      found = march.go(options, steps, ledger);
    }
  }
  if (!found) output.summary.status = "stopped: the matrix of a time step is not positive definite";
  auto& quantities = output.summary.quantities;
  quantities["displacement"] = march.state.displacement[march.watched];
  quantities["velocity"] = march.state.velocity[march.watched];
  quantities["time"] = march.state.time;
  quantities["largest_displacement"] = march.largest;
  if (march.first_energy > 0.0) quantities["energy_drift"] = march.drift;
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
