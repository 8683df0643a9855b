#pragma once
/// Damping proportional to mass and stiffness: C = α M + β K gives a mode of frequency ω the ratio ζ = α/(2ω) + β ω/2.

namespace sunder::dynamics {

struct Rayleigh {
  double of_mass = 0.0;       ///< α [1/s]
  double of_stiffness = 0.0;  ///< β [s]

  double ratio(double omega) const { return 0.5 * (of_mass / omega + of_stiffness * omega); }  ///< ζ [-] at ω [rad/s]
};

/// The same ratio at both frequencies [rad/s], 0 < first < second: α = 2 ζ ω₁ ω₂ / (ω₁ + ω₂), β = 2 ζ / (ω₁ + ω₂).
/// Throws std::invalid_argument where they are not, or ζ is not in 0 … 1.
Rayleigh rayleigh(double ratio, double first, double second);

/// β K alone, with the ratio at `omega` [rad/s] > 0. Throws likewise.
Rayleigh stiffness_proportional(double ratio, double omega);

}  // namespace sunder::dynamics
