#pragma once
/// Where the energy of a shaken body has gone, step by step [J/m].
///
/// With the average acceleration scheme the account closes to round-off: for its steps Δu
///
///     Δ(½ vᵀ M v + ½ uᵀ K u) = ½ Δuᵀ (F + F')  - Δuᵀ C Δu / Δt
///
/// exactly, F and F' being all other forces at both ends. The works below are these trapezoids. The α schemes damp
/// numerically; what they take away appears as balance error.

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

struct Energies {
  double kinetic = 0.0;   ///< ½ vᵀ M v, v relative to the ground
  double strain = 0.0;    ///< ½ uᵀ K u
  double damped = 0.0;    ///< taken by Rayleigh damping, >= 0
  double radiated = 0.0;  ///< work done on attached media by the motion relative to the ground
  double input = 0.0;     ///< work of the ground's inertia load
  double load = 0.0;      ///< work of weight and standing water
  double contact = 0.0;   ///< work of the contact forces on the faces
  double water = 0.0;     ///< work of the water in the cracks on the faces
  double growth = 0.0;    ///< of growth events: change of the stored energy by the transfer of the state, less what the
                          ///< opening of the new faces takes

  double stored() const { return kinetic + strain; }
};

/// Forces between crack faces at both ends of a step, as nodal forces (dofs) [N/m].
struct FaceWork {
  double contact = 0.0, water = 0.0;  ///< of the step [J/m]
};

/// What the account remembers beside the motion.
struct EnergyMemory {
  Energies energies;
  double begun_with = 0.0, worst_error = 0.0, largest = 0.0;  ///< [J/m]
};

class EnergyAccount {
 public:
  /// Begins with the stored energy of `state`, where the equations stand, here and below.
  void begin(const StepEquations& equations, const MotionState& state);

  /// One step from `from` to `to` under the loads `start` and `end` (weights and standing water only). `equations`
  /// holds the forces of the media at the end, `media_before` those at the start. `released` (dofs) [N/m], empty but
  /// after a growth event: what was out of balance at the start, the force that had held the new faces together; it
  /// falls to 0 within the step.
  void add(const StepEquations& equations, const MotionState& from, const MotionState& to, const StepLoad& start,
           const StepLoad& end, const std::vector<Eigen::VectorXd>& media_before, const FaceWork& faces,
           const Eigen::VectorXd& released);

  /// A growth event has changed the stored energy to that of `state` in the new equations.
  void grow(const StepEquations& equations, const MotionState& state);

  const EnergyMemory& memory() const { return memory_; }
  /// Goes on from what another account of the same run remembered at `state`.
  void go_on(const StepEquations& equations, const MotionState& state, const EnergyMemory& memory);

  const Energies& energies() const { return memory_.energies; }
  /// Stored energy less what came in, as a fraction of the largest energy so far.
  double balance_error() const { return memory_.largest > 0.0 ? memory_.worst_error / memory_.largest : 0.0; }

 private:
  void measure(const StepEquations& equations, const MotionState& state);

  EnergyMemory memory_;
  Eigen::VectorXd moved_;
};

}  // namespace sunder::simulation
