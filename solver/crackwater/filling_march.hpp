#pragma once
/// A crack that fills and empties in time: where the water stands after each step, how much of it there is, what it
/// presses.
///
/// Each node owns the half segments beside it, with capacity C = ∫ N w ds [m²]; what is not water there is void. A step
/// of backward Euler from a void to the next, with the apertures at the end of the step:
///
///     void' = void + ΔC - Δt (q_in - q_out),   0 ≤ p,  0 ≤ void',  p void' = 0
///
/// is the problem of pressure_profile.hpp with R = (void + ΔC)/Δt in place of the opening rates: where p > 0 the node
/// is full, and fronts, islands and voids come out with it. The order is one in time and segment length jointly. Water
/// is conserved by construction: a flux that leaves one node enters the next. Where the crack is not full water stands
/// until it is pressed: it does not run down an inclined crack.
///
/// A step that is solved together with the structure is tried as often as the structure asks, always from the same
/// state, and then accepted; pressure_tangent.hpp has the derivatives of a trial with respect to the apertures at its
/// end. A crack that grows keeps its water where it was; its new part is dry.

#include <span>
#include <vector>

#include "solver/crackwater/pressure_profile.hpp"

namespace sunder::crackwater {

struct MarchOptions {
  Search search = Search::newton;  ///< of the wet regions
  bool initially_full = true;      ///< otherwise without a drop
};

struct MarchState {
  ProfileStatus status = ProfileStatus::converged;
  double time = 0.0;               ///< [s] since the start
  std::vector<double> voids;       ///< (n + 1) [m²], 0 … capacity
  std::vector<double> capacities;  ///< (n + 1) [m²]
  double content = 0.0;            ///< water in the crack [m²]
  double inflow = 0.0;             ///< through the upstream mouth since the start [m²], negative: out
  double outflow = 0.0;            ///< through the downstream mouth since the start [m²]
  double moved = 0.0;              ///< Σ of the sizes of both
  double balance_error = 0.0;      ///< content - first content - inflow + outflow [m²]
  double front_position = 0.0;     ///< how far the crack is full from the upstream mouth [m]
  long long residual_evaluations = 0, gradient_evaluations = 0, steps = 0;
};

/// What one step of a march leaves for the next.
struct MarchMemory {
  MarchState state;
  numerics::CompensatedSum inflow, outflow;           ///< [m²]
  double first_content = 0.0;                         ///< [m²]
  double upstream_flux = 0.0, downstream_flux = 0.0;  ///< [m²/s]
};

class FillingMarch {
 public:
  /// `apertures` [m], (n + 1), > 0, are those at the start. Throws std::invalid_argument naming the value and its
  /// bound.
  FillingMarch(const CrackLine& line, const Water& water, std::span<const double> apertures,
               const MarchOptions& options = {});

  /// The pressures of a step of `time_step` [s] > 0 from the state to these apertures and mouth pressures. The state
  /// stays: the same trial gives the same bits however many came before. Allocates and throws nothing.
  const PressureProfile& trial(std::span<const double> apertures, const MouthPressures& mouths,
                               double time_step) noexcept;

  /// Makes the last trial the state: with its best answer where it did not converge. Nothing happens where its input
  /// was unusable, or where there was none since the last `accept`.
  const MarchState& accept() noexcept;

  /// `trial` and `accept`; the state has the status of the trial.
  const MarchState& step(std::span<const double> apertures, const MouthPressures& mouths, double time_step) noexcept;

  /// Goes on with a crack that reaches at least as far as before from the same mouth, divided as `line` says, with
  /// `apertures` [m], (its segments + 1), > 0. Each node's water is spread evenly over its half segments and handed to
  /// the nodes that now own the place; where a node cannot hold it all the rest goes to the next that can, and what the
  /// whole crack cannot hold leaves through the upstream mouth. No water is lost. The new part is dry. Allocates.
  /// Throws std::invalid_argument naming the value and its bound.
  void grow(const CrackLine& line, std::span<const double> apertures);

  MarchMemory memory() const;
  /// Goes on as the march in the same crack that `memory` is of. Throws std::invalid_argument where the number of
  /// nodes differs.
  void go_on(const MarchMemory& memory);

  const MarchState& state() const { return state_; }
  /// Pressures of the last trial or step.
  const PressureProfile& profile() const { return solver_.profile(); }
  const PressureSolver& solver() const { return solver_; }
  double trial_time_step() const { return time_step_; }  ///< of the last trial [s]; 0 before the first

 private:
  void allocate(std::size_t nodes);
  void fluxes();
  void capacities(std::span<const double> apertures, std::vector<double>& values) const;
  double total_content() const;
  double front_position() const;
  void carry_excess();

  Water water_;
  MarchOptions options_;
  PressureSolver solver_;
  MarchState state_;
  std::vector<double> next_capacities_, changes_, rates_, flux_;
  std::vector<char> full_;
  numerics::CompensatedSum inflow_, outflow_;
  double first_content_ = 0.0;
  double upstream_flux_ = 0.0, downstream_flux_ = 0.0;  // of the last accepted step
  double time_step_ = 0.0;
  bool tried_ = false;
};

}  // namespace sunder::crackwater
