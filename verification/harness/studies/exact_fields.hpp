#pragma once
/// Equilibrium polynomials laid on a body of any size and place, and the nodal forces of their tractions.
///
/// With ζ = (x - origin) / size the displacement is size · U(ζ) and the stress S(ζ): of order one, times the field's
/// magnitude, whatever the units.

#include <Eigen/Core>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "verification/exact/plane_elasticity.hpp"

namespace sunder::verification {

struct PlacedField {
  exact::PolynomialField field;
  exact::PlaneBody body;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< [m]
  double size = 1.0;                                 ///< [m]
};

Eigen::Vector2d displacement(const PlacedField& field, const Eigen::Vector2d& x);  ///< [m]
Eigen::Vector3d stress(const PlacedField& field, const Eigen::Vector2d& x);        ///< {σ_xx, σ_yy, τ_xy} [Pa]

/// The displacements at the nodes (2, n) [m], one below the other (2n) [m].
Eigen::VectorXd displacements(const PlacedField& field, const Eigen::Matrix2Xd& nodes);

/// ∫ Nᵀ t ds of the tractions on a straight edge of order p whose outward side is on the right (2p + 2) [N/m]; exact up
/// to polynomials of degree p + 2.
Eigen::VectorXd edge_force(const PlacedField& field, const Eigen::Vector2d& first, const Eigen::Vector2d& last,
                           int order);

/// ∫ u · t ds on the same edge [J/m], exact up to polynomials of degree `order`.
double edge_work(const PlacedField& field, const Eigen::Vector2d& first, const Eigen::Vector2d& last, int order);

/// The material by the formulas of verification/exact: shares nothing with solver/material.
exact::PlaneBody exact_body(const material::Isotropic& material);

/// The four fields of each degree 1 … degree, with magnitude E: index 4 (degree - 1) + part; part 1 of degree 1 is the
/// rotation.
std::vector<PlacedField> polynomial_fields(const material::Isotropic& material, int degree,
                                           const Eigen::Vector2d& origin, double size);

/// Their sum with unequal weights: one field that holds them all.
PlacedField sum_of(const std::vector<PlacedField>& fields);

}  // namespace sunder::verification
