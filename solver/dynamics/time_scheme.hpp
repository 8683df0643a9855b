#pragma once
/// One-step schemes for M a + C v + K u = f: the generalised-α family [Chung & Hulbert 1993] with Newmark's updates
/// [Newmark 1959].
///
///     u' = u + Δt v + Δt² ((½ - β) a + β a'),   v' = v + Δt ((1 - γ) a + γ a')
///     (1 - α_m) M a' + α_m M a + (1 - α_f) (C v' + K u' - f') + α_f (C v + K u - f) = 0
///
/// A prime marks the end of the step. Average acceleration (α = 0, β = ¼, γ = ½) is the bilinear map s = 2(1 - ζ)/(Δt(1
/// + ζ)): it damps nothing, is stable for any Δt, and is the partner of the trapezoidal weights of module convolution.

#include <array>
#include <complex>

namespace sunder::dynamics {

struct TimeScheme {
  double alpha_m = 0.0, alpha_f = 0.0;  ///< [-]
  double beta = 0.25, gamma = 0.5;      ///< [-]
};

/// Average acceleration; order 2, no numerical damping.
TimeScheme newmark();

/// [Hilber, Hughes & Taylor 1977], α_f = (1 - ρ)/(1 + ρ), α_m = 0; `spectral_radius` ρ at infinite frequency, ½ … 1.
/// Throws std::invalid_argument outside.
TimeScheme hht_alpha(double spectral_radius);

/// ρ = 0 … 1: the least damping of low frequencies for a given ρ at infinite frequency. Throws likewise.
TimeScheme generalised_alpha(double spectral_radius);

/// What multiplies M, C and K in the matrix of a step, for the unknown u' - u.
struct StepFactors {
  double mass, damping, stiffness;  ///< [1/s²], [1/s], [-]
};
StepFactors step_factors(const TimeScheme& scheme, double time_step);

/// Eigenvalues of one step of the undamped oscillator with ω Δt = `phase` ≥ 0; the largest size is the spectral radius.
std::array<std::complex<double>, 3> amplification(const TimeScheme& scheme, double phase);

}  // namespace sunder::dynamics
