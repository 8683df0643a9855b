#pragma once
/// Equilibrium of the assembled body: K u = f with prescribed displacements.

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "solver/numerics/symmetric_factor.hpp"
#include "solver/simulation/constraints.hpp"

namespace sunder::simulation {

struct StaticSolution {
  Eigen::VectorXd displacement;  ///< (dofs) [m]
  Eigen::VectorXd reaction;      ///< K u - f (dofs) [N/m]: the supports' forces on the body, round-off elsewhere
  double residual = 0.0;         ///< ‖K u - f‖ over the free dofs / (‖f‖ + ‖reaction‖)
  double pivot_ratio = 0.0;      ///< of the factor, a cheap estimate of 1 / condition
  long long factor_entries = 0;
  numerics::FactorStatus status = numerics::FactorStatus::factorised;
  int failed_dof = -1;  ///< where the matrix is not positive definite
};

/// `stiffness` (dofs, dofs): lower triangle; `force` (dofs) [N/m]. One step of iterative refinement: the residual is at
/// round-off also where stiffnesses differ by many orders of magnitude.
[[nodiscard]] StaticSolution solve_static(const Eigen::SparseMatrix<double>& stiffness, const Eigen::VectorXd& force,
                                          const Constraints& constraints);

}  // namespace sunder::simulation
