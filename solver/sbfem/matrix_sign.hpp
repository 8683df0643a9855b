#pragma once
/// The stiffness of a polygon from the matrix sign function of its Hamiltonian: the second, independent route.
///
/// Z(E0, F, E2) = [E0⁻¹F, -E0⁻¹; -E2 + Fᵀ E0⁻¹ F, -Fᵀ E0⁻¹] has the inverse Z(E2, Fᵀ, E0). The scaled Newton step
/// Z ← ½ (c Z + (c Z)⁻¹) [Byers 1987] therefore stays within this form, and needs one Cholesky factorisation of
/// S = E0/c + c E2:
///     E0 ← 2 (E0/c) S⁻¹ (c E2),  F ← c E2 S⁻¹ F + (E0/c) S⁻¹ Fᵀ,  E2 ← ½ (S - Nᵀ S⁻¹ N),  N = F - Fᵀ,
/// with the determinant scaling c = (det E0 / det E2)^(1/2m). At the fixed point F = Fᵀ, E0 = E2 and K = E0 + F.

#include "solver/sbfem/ring_doubling.hpp"

namespace sunder::sbfem {

RiccatiSolution matrix_sign(Eigen::MatrixXd E0, Eigen::MatrixXd F, Eigen::MatrixXd E2);

}  // namespace sunder::sbfem
