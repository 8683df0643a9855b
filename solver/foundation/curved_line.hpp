#pragma once
/// Coefficient matrices of a smooth line: the edges pass through their nodes as polynomials of their own order.
///
/// For lines whose exact answers are known (circles). Straight edges belong to sbfem::coefficients, which needs no
/// quadrature; on them both agree to round-off.

#include "solver/sbfem/coefficients.hpp"

namespace sunder::foundation {

/// Nodes of a full circle about the scaling centre, or of the half below it (open, from the left end to the right):
/// `elements` >= 1 equal arcs (full: >= 3) of order `order` 1 … 32, nodes at Gauss-Lobatto angles. radius [m], > 0.
sbfem::Boundary circle(double radius, int elements, int order, bool half);

/// As sbfem::coefficients, with 2p + 4 Gauss points an edge: on a smooth line the integrands are no polynomials, and
/// the quadrature error falls faster than that of the interpolation. Throws std::invalid_argument where J_b <= 0.
sbfem::Coefficients curved_coefficients(const sbfem::Boundary& boundary, const material::Isotropic& material);

/// The same for displacements out of the plane, u_z: (n, n), E0 = ∫ G |b1|² NᵀN J_b dη and so on.
sbfem::Coefficients curved_antiplane_coefficients(const sbfem::Boundary& boundary, const material::Isotropic& material);

}  // namespace sunder::foundation
