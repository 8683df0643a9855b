#include "solver/simulation/energy_account.hpp"

#include <cmath>

namespace sunder::simulation {

void EnergyAccount::measure(const StepEquations& equations, const MotionState& state) {
  Ku_.noalias() = equations.stiffness().selfadjointView<Eigen::Lower>() * state.displacement;
  Mv_.noalias() = equations.mass().selfadjointView<Eigen::Lower>() * state.velocity;
  energies_.strain = 0.5 * state.displacement.dot(Ku_);
  energies_.kinetic = 0.5 * state.velocity.dot(Mv_);
}

void EnergyAccount::begin(const StepEquations& equations, const MotionState& state) {
  const Eigen::Index dofs = state.displacement.size();
  for (Eigen::VectorXd* values : {&Ku_, &Mv_, &Ku_before_, &Mv_before_, &moved_}) values->setZero(dofs);
  measure(equations, state);
  begun_with_ = energies_.stored();
  largest_ = energies_.stored();
}

void EnergyAccount::grow(const StepEquations& equations, const MotionState& state) {
  const double before = energies_.stored();
  const Eigen::Index dofs = state.displacement.size();
  for (Eigen::VectorXd* values : {&Ku_, &Mv_, &Ku_before_, &Mv_before_, &moved_}) values->setZero(dofs);
  measure(equations, state);
  energies_.growth += energies_.stored() - before;
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
  energies_.damped +=
      moved_.dot(0.5 * damping.of_mass * (Mv_before_ + Mv_)) + moved_.dot(Ku_ - Ku_before_) * damping.of_stiffness / dt;
  energies_.input -= 0.5 * equations.work_of_ground(moved_, start.ground + end.ground);
  energies_.load += 0.5 * moved_.dot(start.force + end.force);
  for (std::size_t m = 0; m < media_before.size(); ++m) {
    energies_.radiated += 0.5 * equations.work_on_medium(m, moved_, media_before[m]);
  }
  if (released.size() > 0) energies_.growth += 0.5 * moved_.dot(released);
  energies_.contact += faces.contact;
  energies_.water += faces.water;
  const double came_in = energies_.input + energies_.load + energies_.contact + energies_.water + energies_.growth -
                         energies_.damped - energies_.radiated;
  worst_error_ = std::fmax(worst_error_, std::abs(energies_.stored() - begun_with_ - came_in));
  largest_ = std::fmax(largest_, std::fmax(energies_.stored(), std::abs(energies_.input)));
}

}  // namespace sunder::simulation
