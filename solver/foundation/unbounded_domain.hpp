#pragma once
/// Rock without end, outside a line that its scaling centre sees from inside: the scaled boundary equation of ξ ≥ 1.
///
/// The forces R [N/m] that hold the line at displacements u [m] (per unit thickness, e^{st}) are R = S(s) u with
///     (S + E1) E0⁻¹ (S + E1ᵀ) - s dS/ds - E2 - s² M0 = 0                          [Song & Wolf 1997; s = iω]
/// (plane problems: the term (dimension - 2) S is absent). Here it stands in the coordinates in which E0 is the unit
/// matrix and M0 is diagonal,
///     S = F ŝ Fᵀ,  F = Uᵀ V,  E0 = Uᵀ U,  Vᵀ U⁻ᵀ M0 U⁻¹ V = c²,  e1 = Vᵀ U⁻ᵀ E1 U⁻¹ V,  e2 likewise,
/// in time units of the slowest crossing of the domain, so that everything but F is a number without unit.

#include <Eigen/Core>
#include <vector>

#include "solver/sbfem/coefficients.hpp"

namespace sunder::foundation {

struct UnboundedDomain {
  Eigen::MatrixXd F;       ///< (n, n), S = F ŝ Fᵀ
  double time = 0.0;       ///< unit of time [s]: the largest distance of an edge's line over its wave speed
  Eigen::VectorXd c;       ///< (n), 0 < c <= 1: ŝ → σ c for σ = s · time → ∞, the radiation into the rock
  Eigen::MatrixXd k;       ///< (n, n) symmetric, next term: c k + k c = c - e1 c - c e1ᵀ
  Eigen::MatrixXd e1, e2;  ///< (n, n)
  /// a_1, a_2, …: ŝ = σ c + k + Σ a_j σ^-j, the asymptotic series for large |σ|, Re σ >= 0.
  std::vector<Eigen::MatrixXd> series;

  Eigen::Index size() const { return c.size(); }
};

/// `coefficients` with M0; any line of any field problem whose coefficient matrices have this form will do (the plane
/// solid, or waves out of the plane). Throws std::invalid_argument where M0 is absent or E0 or M0 is not positive
/// definite.
UnboundedDomain unbounded_domain(const sbfem::Coefficients& coefficients);

}  // namespace sunder::foundation
