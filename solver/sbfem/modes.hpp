#pragma once
/// All displacement modes of a polygon at once, as an invariant subspace: the third route to the stiffness.
///
/// Z [Vu; Vq] = [Vu; Vq] S with ξ d/dξ [u; q] = -Z [u; q], hence u(ξ) = Vu ξ^(-S) c and K = Vq Vu⁻¹ [Song 2004]. The
/// Schur form is orthogonal: nothing blows up where modes merge (λ = -1 meets the rotation at a notch of 257.4534
/// degrees), where a matrix of eigenvectors has condition 1e7 and more.

#include <Eigen/Core>

#include "solver/sbfem/coefficients.hpp"
#include "solver/sbfem/polygon_solution.hpp"
#include "solver/sbfem/reduced_polygon.hpp"
#include "solver/sbfem/ring_doubling.hpp"

namespace sunder::sbfem {

struct ModalSolution {
  Eigen::MatrixXd S;  ///< (2n, 2n) quasi-upper triangular, Re λ <= 0; the last two columns are the translations, λ = 0
  Eigen::MatrixXd Vu;  ///< (2n, 2n) displacements on the boundary
  Eigen::MatrixXd Vq;  ///< (2n, 2n) [Pa] nodal forces
  PolygonStatus status = PolygonStatus::converged;
};

[[nodiscard]] ModalSolution modes(const Coefficients& coefficients);

/// K of the reduced polygon by its ordered real Schur form.
RiccatiSolution schur_stiffness(const ReducedPolygon& polygon);

}  // namespace sunder::sbfem
