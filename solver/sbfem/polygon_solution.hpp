#pragma once
/// The stiffness of a polygon and the displacement field inside it, without any eigenvalue.

#include <Eigen/Core>

#include "solver/sbfem/coefficients.hpp"

namespace sunder::sbfem {

enum class Route {
  ring_doubling,  ///< default: rings glued and condensed until the inner one no longer matters; where
                  ///< round-off makes them indefinite (edges of 1e-9 of the polygon), matrix_sign takes over
  matrix_sign,  ///< matrix sign function of the scaled, deflated Hamiltonian on Cholesky factors: independent, best on
                ///< slivers
  ordered_schur,  ///< ordered real Schur form of the balanced Hamiltonian: independent, and the only one with all modes
};

enum class PolygonStatus { converged, not_converged, not_positive_definite };

/// What a polygon does: R = K u_b on its boundary and u(ξ) = ξ^A u_b inside.
struct PolygonSolution {
  Eigen::MatrixXd K;       ///< stiffness (2n, 2n) [Pa] (unit thickness), symmetric
  Eigen::MatrixXd A;       ///< closed loop (2n, 2n) [-]: u(ξ) = ξ^A u_b, A = E0⁻¹ (K - E1ᵀ) [Song 2018]
  double asymmetry = 0.0;  ///< ‖K - Kᵀ‖ / ‖K‖ before symmetrising: 1e-15 … 1e-11 where healthy, 0 with rings
  int iterations = 0;      ///< merges, sign iterations, or 0
  PolygonStatus status = PolygonStatus::converged;
};

[[nodiscard]] PolygonSolution solve_polygon(const Coefficients& coefficients, Route route = Route::ring_doubling);

/// The solution of a polygon whose stiffness is known, as from a Formation: A alone is left to be found, for a small
/// part of the cost. A stiffness that is not finite, that of a failed polygon, fails here too.
[[nodiscard]] PolygonSolution solution_of_stiffness(const Coefficients& coefficients,
                                                    const Eigen::Ref<const Eigen::MatrixXd>& K);

/// Consistent mass of the static displacement field (2n, 2n) [kg/m]: (I + A)ᵀ M + M (I + A) = M0, by squared Smith
/// iteration [Smith 1968]. NaN where the solution failed or where the mass of a translation is not density times area.
[[nodiscard]] Eigen::MatrixXd mass(const Coefficients& coefficients, const PolygonSolution& solution);

}  // namespace sunder::sbfem
