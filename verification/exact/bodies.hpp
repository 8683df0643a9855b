#pragma once
/// Exact answers for simple bodies: a ring under pressure, bars under bending and under their own weight.

#include "verification/exact/plane_elasticity.hpp"

namespace sunder::exact {

/// Lamé's ring, inner radius a < outer radius b [m], pressures [Pa], both pushing into the ring.
struct Ring {
  double inner_radius, outer_radius, inner_pressure, outer_pressure;
};
struct RingState {
  double radial_displacement;         ///< [m]
  double radial_stress, hoop_stress;  ///< [Pa]
};
/// σ_r,θ = A ∓ B / r², 2 G u_r = (κ - 1)/2 A r + B / r [Timoshenko 1970, §28].
RingState ring_state(const Ring& ring, const PlaneBody& body, double radius);

/// A bar along x, |y| <= height / 2, bent so that σ_xx = curvature_stress · y: u = s x y / E', v = -s (x² + ν' y²) / (2
/// E') with s = curvature_stress [Pa/m], ν' = (3 - κ) / (1 + κ). A polynomial of degree 2. Returns u + i v [m].
Complex pure_bending(double curvature_stress, const PlaneBody& body, Complex z);

/// A bar of height `height` [m] that stands on y = 0 under its own weight γ = ρ g [N/m³]: σ_yy = -γ (height - y), the
/// other stresses 0; u = ν' γ x (height - y) / E', v = γ (y² - 2 height y + ν' x²) / (2 E'). Returns u + i v [m]. Its
/// base is flat only for ν' = 0.
Complex own_weight(double specific_weight, double height, const PlaneBody& body, Complex z);
PlaneStress own_weight_stress(double specific_weight, double height, Complex z);

/// Cantilever along x, clamped about x = length, loaded at x = 0 by the downward force P per thickness spread as a
/// parabola: I = height³ / 12, σ_xx = -P x y / I, τ_xy = -P (h²/4 - y²) / (2 I) [Timoshenko 1970, §21]. Clamped so that
/// u, v and ∂v/∂x vanish at (length, 0). Returns u + i v [m].
Complex end_loaded_cantilever(double force, double length, double height, const PlaneBody& body, Complex z);
PlaneStress end_loaded_cantilever_stress(double force, double height, Complex z);

/// ν' = (3 - κ) / (1 + κ): ν in plane stress, ν / (1 - ν) in plane strain.
double effective_poisson_ratio(const PlaneBody& body);

}  // namespace sunder::exact
