#pragma once
/// The two groups of exponents of a crack polygon that fracture mechanics asks for: r^½ and r¹.
///
/// u(ξ) = ξ^A u_b holds two exponents near ½ (the singular stresses of mode I and II) and two equal to 1 (the T-stress
/// and the rotation). On a coarse boundary the former differ from ½ by up to 1e-2 and from each other, or are complex,
/// or defective; so each group is taken as an invariant subspace, A V = V S with Wᵀ V = I and Wᵀ A = S Wᵀ, never as
/// eigenvectors.

#include <Eigen/Core>
#include <array>
#include <complex>

#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::fracture {

/// One invariant pair of A.
struct ModeGroup {
  Eigen::MatrixX2d right;                         ///< V (2n, 2) [-]
  Eigen::MatrixX2d left;                          ///< W (2n, 2), Wᵀ V = I: Wᵀ u is the share of the group in u
  Eigen::Matrix2d matrix;                         ///< S (2, 2), A V = V S
  std::array<std::complex<double>, 2> exponents;  ///< eigenvalues of S
};

enum class ModeStatus {
  converged,    ///< by two-sided inverse iteration
  by_schur,     ///< the iteration did not settle; taken from the ordered Schur form of A
  not_a_crack,  ///< there are not exactly two exponents in the group's window: the groups are not to be used
};

struct SingularModes {
  ModeGroup singular;  ///< 0.02 < Re λ < 0.98
  ModeGroup unit;      ///< about 1
  int iterations = 0;  ///< of the slower group
  ModeStatus status = ModeStatus::converged;
};

/// Of an open polygon. ‖A V - V S‖ <= 1e-12 ‖A‖ for both groups and both sides where the status is `converged`.
[[nodiscard]] SingularModes singular_modes(const sbfem::Boundary& boundary, const material::Isotropic& material,
                                           const sbfem::Coefficients& coefficients,
                                           const sbfem::PolygonSolution& solution);

}  // namespace sunder::fracture
