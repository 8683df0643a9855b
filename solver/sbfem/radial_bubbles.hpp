#pragma once
/// What moves inside a polygon while its boundary rests: the inertia that a mass from static modes leaves out.
///
/// The static field ξ^A u_b alone gives frequencies of order 2 whatever the order p of the boundary, because it holds
/// no motion with a resting boundary. The functions
///     w_k(ξ) = (ξ^k - ξ^A) d,   k = 2 … interior_order, any d,
/// vanish at ξ = 1 and complete the field to all polynomials of degree min(p, interior_order). They are orthogonal to
/// the static field in the energy, a(ξ^A u, w) = 0, so the stiffness stays K and only the mass couples (Craig and
/// Bampton's form, with the static field in place of the constraint modes):
///     a(w_k d, w_l e) = dᵀ [(kl E0 + k E1ᵀ + l E1 + E2) / (k + l) - K] e
///     m(ξ^k d, ξ^l e) = dᵀ M0 e / (k + l + 2),   m(ξ^A u, ξ^l e) = uᵀ (Aᵀ + (l + 2) I)⁻¹ M0 e
/// Frequencies then converge with order 2 min(p, interior_order). Own derivation; the check is verification's roller
/// square.

#include <Eigen/Core>

#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::sbfem {

/// Highest power worth asking for: the Gram matrix of ξ² … ξ^m loses half of the digits at m = 10.
constexpr int highest_interior_order = 10;

/// The bubbles as modes of the polygon with a resting boundary: unit modal mass each.
struct RadialBubbles {
  Eigen::VectorXd omega_squared;  ///< (b) [rad²/s²], ascending
  Eigen::MatrixXd coupling;       ///< (2n, b): mass between boundary displacements and bubbles [√(kg/m)]
};

/// `mass` (2n, 2n) is that of the static field. interior_order 2 … highest_interior_order; density > 0.
/// Polynomials in equilibrium are static fields already (four for each k <= p) and are left out by their rank.
[[nodiscard]] RadialBubbles radial_bubbles(const Coefficients& coefficients, const PolygonSolution& solution,
                                           const Eigen::MatrixXd& mass, int interior_order);

}  // namespace sunder::sbfem
