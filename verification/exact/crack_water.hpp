#pragma once
/// Water between the faces of a crack of uniform aperture, in closed form: at rest, moving with its tip closed, and
/// running into it when it is dry.
///
/// The friction gradient is φ(q)/w³ with Louis' laws, φ = a q up to the critical flux q_c (Re = 2300) and b q² beyond
/// [Louis 1969]; water of 1000 kg/m³, relative roughness 0.5. A pressure is one above that of the air.

namespace sunder::exact {

struct LouisLaw {
  double laminar;        ///< a [Pa s]
  double turbulent;      ///< b [kg/m³]
  double critical_flux;  ///< q_c [m²/s]
};

/// a = 12 μ (1 + 8.8 · 0.5^1.5), b = 1000 / (16 log10²(0.5/1.9)), q_c = 2300 μ / 2000.
LouisLaw louis_law(double viscosity);

/// Flux [m²/s] of a crack at rest that loses `pressure` [Pa] >= 0 over its length: φ(q) = pressure w³ / L.
double resting_crack_flux(double pressure, double aperture, double length, double viscosity);

/// A crack whose whole length opens with `rate` [m/s] (negative: closes), full just before, `pressure` [Pa] at its
/// mouth and a closed tip. The water behind the point where it stands, at the tip or at the front, flows with q = rate
/// · (distance to it).
struct MovingCrack {
  double pressure, aperture, length, rate, viscosity;
};
double moving_crack_front(const MovingCrack& crack);         ///< how far water reaches [m]
double moving_crack_tip_pressure(const MovingCrack& crack);  ///< [Pa]
double moving_crack_uplift(const MovingCrack& crack);        ///< ∫ p ds [N/m]

/// Front [m] after `time` [s] of water that runs into a dry crack at rest: x² = 2 p w² t / a where all is laminar. At
/// first it is turbulent, x = (3/2 √(p w / b) t)^(2/3), up to x1 = p w³/(b q_c²); then the flux stays at q_c while the
/// front runs to x2 = p w³/(a q_c).
double filling_front(double pressure, double aperture, double time, double viscosity);

}  // namespace sunder::exact
