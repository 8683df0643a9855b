#pragma once
/// Water in an endless rectangular reservoir with a rigid bottom: series with closed-form terms, κ = ω H/c.

namespace sunder::exact {

/// Force on a rigid face per ρ a H² below the cut-off, 0 <= κ < π/2: Σ 2/(z_n² √(z_n² - κ²)), z_n = (2n - 1) π/2; at 0
/// it is 14 ζ(3)/π³ [Chopra 1967].
double reservoir_force(double kappa);

/// κ of an undamped oscillator on the rigid face whose mass is `ratio` · 14 ζ(3)/π³ ρ H² and whose frequency without
/// water is `dry` (as κ): the root of κ² (mass + reservoir_force(κ)) = dry² mass. Below the cut-off water radiates
/// nothing, and the oscillation lasts.
double coupled_frequency(double ratio, double dry);

/// The force after an impulse of acceleration per ρ c H before the first echo, 0 <= T <= 2: 1 - 2 T/π.
double reservoir_impulse_before_echo(double T);

}  // namespace sunder::exact
