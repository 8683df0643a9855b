#pragma once
/// Natural frequencies and motions with a closed form.

#include "verification/exact/plane_elasticity.hpp"

namespace sunder::exact {

/// c_s = √(G / ρ) and c_p = c_s √((κ + 1) / (κ - 1)) of the plane state [m/s]; ρ [kg/m³] > 0.
double shear_wave_speed(const PlaneBody& body, double density);
double longitudinal_wave_speed(const PlaneBody& body, double density);

/// Square of side L [m] on rollers all round (normal displacement fixed, tangential free): ω = c π √(i² + j²) / L
/// [rad/s] for shear waves (i, j >= 1) and longitudinal waves (i, j >= 0, not both 0). The `index`-th lowest of all,
/// from 0 on, each as often as it comes.
double roller_square_frequency(const PlaneBody& body, double density, double side, int index);

/// Bending of a slender cantilever after Euler and Bernoulli: ω_n = λ_n² √(E I / (ρ A)) / L², cos λ cosh λ = -1; height
/// h, unit thickness, `effective` modulus E' [Pa]; n from 1 on. Not a bar for stout beams: shear and rotary inertia are
/// left out.
double slender_cantilever_frequency(double effective, double density, double length, double height, int n);

/// Oscillator at rest that a constant force meets at once: displacement as a fraction of the static one, ζ = `ratio` in
/// 0 … 1 (1 excluded), ω t = `phase`.
double step_response(double ratio, double phase);

/// Oscillator at rest in ground whose acceleration is sin(Ω t) [m/s²] from t = 0: -u [m] per unit of participation,
/// undamped, Ω != ω.
double shaken_oscillator(double omega, double ground_omega, double time);

/// Rod on such ground, free at its other end, which waves reach after `transit` [s]: displacement of the free end
/// relative to the ground [m], 2 Σ (-1)^k u_g(t - (2k + 1) transit) - u_g(t) by d'Alembert.
double shaken_rod(double transit, double ground_omega, double time);

/// What a one-step scheme of the generalised-α family makes of `step_response` after `steps` steps of ω Δt = `phase`:
/// [Chung & Hulbert 1993, Eqs. (2)-(5)] for one unknown, solved for the acceleration. `radius` as there.
double newmark_step_response(double phase, double ratio, int steps);
double hht_alpha_step_response(double radius, double phase, double ratio, int steps);
double generalised_alpha_step_response(double radius, double phase, double ratio, int steps);

}  // namespace sunder::exact
