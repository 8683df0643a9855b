#include "solver/simulation/energy_account.hpp"

#include <cmath>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::simulation {

void EnergyAccount::measure(const StepEquations& equations, const MotionState& state) {
  equations.multiply(state.displacement, state.velocity, Ku_, Mv_);
  memory_.energies.strain = 0.5 * state.displacement.dot(Ku_);
  memory_.energies.kinetic = 0.5 * state.velocity.dot(Mv_);
}

void EnergyAccount::go_on(const StepEquations& equations, const MotionState& state, const EnergyMemory& memory) {
  memory_ = memory;
  begin_with(equations, state);
}

void EnergyAccount::begin_with(const StepEquations& equations, const MotionState& state) {
  const Eigen::Index dofs = state.displacement.size();
  for (Eigen::VectorXd* values : {&Ku_, &Mv_, &Ku_before_, &Mv_before_, &moved_}) values->setZero(dofs);
  measure(equations, state);
}

void EnergyAccount::begin(const StepEquations& equations, const MotionState& state) {
  begin_with(equations, state);
  memory_.begun_with = memory_.energies.stored();
  memory_.largest = memory_.energies.stored();
}

void EnergyAccount::grow(const StepEquations& equations, const MotionState& state) {
  const double before = memory_.energies.stored();
  begin_with(equations, state);
  memory_.energies.growth += memory_.energies.stored() - before;
}

void EnergyAccount::add(const StepEquations& equations, const MotionState& from, const MotionState& to,
                        const StepLoad& start, const StepLoad& end, const std::vector<Eigen::VectorXd>& media_before,
                        const FaceWork& faces, const Eigen::VectorXd& released) {
  const double dt = equations.options().time_step;
  const dynamics::Rayleigh& damping = equations.options().damping;
  Ku_before_.swap(Ku_);
  Mv_before_.swap(Mv_);
  measure(equations, to);
  moved_ = to.displacement - from.displacement;
  // C Δu / Δt with M Δu = Δt (M v + M v') / 2, exact for average acceleration
  memory_.energies.damped +=
      moved_.dot(0.5 * damping.of_mass * (Mv_before_ + Mv_)) + moved_.dot(Ku_ - Ku_before_) * damping.of_stiffness / dt;
  memory_.energies.input -= 0.5 * equations.work_of_ground(moved_, start.ground + end.ground);
  memory_.energies.load += 0.5 * moved_.dot(start.force + end.force);
  for (std::size_t m = 0; m < media_before.size(); ++m) {
    memory_.energies.radiated += 0.5 * equations.work_on_medium(m, moved_, media_before[m]);
  }
  if (released.size() > 0) memory_.energies.growth += 0.5 * moved_.dot(released);
  if (numerics::planted_fault("simulation/damping-not-accounted-for")) memory_.energies.damped = 0.0;
  memory_.energies.contact += faces.contact;
  memory_.energies.water += faces.water;
  const double came_in = memory_.energies.input + memory_.energies.load + memory_.energies.contact +
                         memory_.energies.water + memory_.energies.growth - memory_.energies.damped -
                         memory_.energies.radiated;
  memory_.worst_error =
      std::fmax(memory_.worst_error, std::abs(memory_.energies.stored() - memory_.begun_with - came_in));
  memory_.largest = std::fmax(memory_.largest, std::fmax(memory_.energies.stored(), std::abs(memory_.energies.input)));
}

}  // namespace sunder::simulation
