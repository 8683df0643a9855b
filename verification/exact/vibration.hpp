#pragma once
/// Natural frequencies with a closed form.

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

}  // namespace sunder::exact
