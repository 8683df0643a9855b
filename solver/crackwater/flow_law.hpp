#pragma once
/// How much pressure water loses along a crack with rough faces: Louis' laminar and turbulent laws, switched at Re =
/// 2300.
///
/// With the flux q [m²/s] (positive from the upstream mouth inwards), the aperture w [m] and the relative roughness
/// r = k/(2w), the friction gradient is φ(q)/w³:
///
///     Re = 2 ρ |q| / μ                                        (hydraulic diameter 2w, speed q/w)
///     Re ≤ 2300   φ = 12 μ (1 + 8.8 r^1.5) q                  [Louis 1969; seed paper, Eq. (9)]
///     Re > 2300   φ = ρ q|q| / (16 log10²(r/1.9))             [Louis 1969; seed paper, Eq. (10)]
///
/// Both are λ ρ q|q| / 4 with λ = 96 (1 + 8.8 r^1.5)/Re and λ^-½ = -2 log10(r/1.9). The turbulent denominator is 16:
/// with 4 or 8 the printed uplift forces of the seed paper are missed by a factor of two to four. φ is odd and, for r
/// from 0.00687879 on, increasing with an upward jump at Re = 2300; below that it falls there, fluxes are not unique,
/// and the law is refused. r is a constant: the roughness that counts scales with the gap.

namespace sunder::crackwater {

struct Water {
  double density = 1000.0;          ///< ρ [kg/m³], > 0
  double dynamic_viscosity = 1e-3;  ///< μ [Pa s], > 0
  double relative_roughness = 0.5;  ///< r, 0 < r ≤ 0.5 and large enough for a monotone law
  double gravity = 9.81;            ///< [m/s²], ≥ 0; acts along an inclined crack only
};

/// The law with its constants worked out.
struct FlowLaw {
  double laminar;        ///< φ/q up to Re = 2300 [Pa s], > 0
  double turbulent;      ///< φ/(q|q|) beyond [kg/m³], > 0
  double critical_flux;  ///< |q| at Re = 2300 [m²/s], > 0
  double weight;         ///< ρ g [N/m³]
};

inline constexpr double critical_reynolds_number = 2300.0;
inline constexpr double least_monotone_roughness = 0.00687879;  ///< rounded up; below it φ falls at Re = 2300

/// φ just above Re = 2300 over φ just below: 4.334 for r = 0.5; the law is monotone where this is ≥ 1.
double resistance_jump(double relative_roughness);

/// Throws std::invalid_argument naming the value and its bound.
void check(const Water& water);

/// Throws as `check`.
FlowLaw flow_law(const Water& water);

inline double reynolds_number(const Water& water, double flux) {
  return 2.0 * water.density * (flux < 0.0 ? -flux : flux) / water.dynamic_viscosity;
}

/// φ(q) [Pa m²]; at Re = 2300 exactly the laminar value.
inline double resistance(const FlowLaw& law, double flux) {
  const double size = flux < 0.0 ? -flux : flux;
  return size > law.critical_flux ? law.turbulent * size * flux : law.laminar * flux;
}

/// dφ/dq [Pa s], > 0 but 0 where nothing flows in a law without viscosity; of the branch that `resistance` takes.
inline double resistance_slope(const FlowLaw& law, double flux) {
  const double size = flux < 0.0 ? -flux : flux;
  return size > law.critical_flux ? 2.0 * law.turbulent * size : law.laminar;
}

/// The flux with φ(q) = value; ±critical_flux for values inside the jump.
double flux_of_resistance(const FlowLaw& law, double value);

/// dp/ds = -φ(q)/w³ without weight [Pa/m].
inline double friction_gradient(const FlowLaw& law, double flux, double aperture) {
  return resistance(law, flux) / (aperture * aperture * aperture);
}

}  // namespace sunder::crackwater
