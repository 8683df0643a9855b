#pragma once
/// Whether a crack tip grows, which way, and how far in one step: the criterion of the largest hoop stress.
///
///     grows where the faces are open and K_eq >= K_IC, along θ (kink_angle.hpp) [Erdogan and Sih 1963].
///
/// K_I is signed. Where it is negative the faces press on each other, and the stress that the formula sees does not
/// exist: such a tip, and one that contact holds closed, does not grow whatever K_II is. The faces of a sawn notch do
/// not meet; there a negative K_I counts as it is.
///
/// A crack has no inertia in this law, so a step in time needs a rule for how far it runs: one increment (the default
/// and the seed paper's), or increments until K_eq < K_IC. One increment a step is a speed limit of increment / Δt that
/// depends on the step; `max_speed` states the limit itself. A crack in concrete stays below the Rayleigh wave, about
/// 2000 m/s: the limit bites only where increment / Δt is smaller than that.

#include <Eigen/Core>
#include <limits>

namespace sunder::fracture {

struct StressIntensityFactors;

enum class GrowthPerStep {
  one_increment,  ///< at most one increment a tip and step; K_eq may stay above K_IC until the next step
  until_arrest,   ///< increments until K_eq < K_IC or max_speed is used up
};

struct PropagationLaw {
  double fracture_toughness;  ///< K_IC [Pa √m], > 0; infinity: never grows
  double increment;           ///< length of one growth [m], > 0, finite
  GrowthPerStep per_step = GrowthPerStep::one_increment;
  double max_speed = std::numeric_limits<double>::infinity();  ///< of a tip [m/s], > 0
};

/// Throws std::invalid_argument with name, value and bound where a value is out of range.
void check(const PropagationLaw& law);

enum class GrowthVerdict {
  grows,
  below_toughness,
  closed,  ///< K_I < 0 or held closed
};

struct GrowthDecision {
  GrowthVerdict verdict = GrowthVerdict::closed;
  double kink_angle = 0.0;         ///< θ from the crack's direction, counter-clockwise [rad]; 0 where closed
  double equivalent_factor = 0.0;  ///< K_eq [Pa √m], >= 0; 0 where closed
};

/// K_I down to -closed_ratio · |K_II| is round-off of a crack in pure shear, not a closed one.
inline constexpr double closed_ratio = 1e-6;

/// What is known of the faces next to the tip.
enum class Faces {
  as_K_I_says,  ///< closed where K_I < 0
  held_closed,  ///< contact presses on them
  apart,        ///< of a notch with a width: never closed
};

[[nodiscard]] GrowthDecision decide_growth(const StressIntensityFactors& factors, Faces faces,
                                           const PropagationLaw& law);

/// Where the tip goes: `increment` from `tip` at the angle θ to `direction`, the crack's own at its tip [rad].
[[nodiscard]] Eigen::Vector2d next_tip(const Eigen::Vector2d& tip, double direction, double kink_angle,
                                       double increment);

/// How far one tip may run: what max_speed · time has allowed and growth has not used. Kept from step to step, so that
/// a slow limit lets an increment through every few steps; a tip that rests saves up no more than one increment.
struct SpeedAllowance {
  double length = 0.0;  ///< [m], >= 0
};

/// At the start of a step of `time_step` [s], > 0.
void refill(SpeedAllowance& allowance, const PropagationLaw& law, double time_step);

/// Whether one more increment fits after `taken` in this step; if so it is taken off the allowance.
[[nodiscard]] bool take_increment(SpeedAllowance& allowance, const PropagationLaw& law, int taken);

}  // namespace sunder::fracture
