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

/// The equations with their factor, for one right side after another.
class StaticEquations {
 public:
  /// Factorises. `stiffness` (dofs, dofs): lower triangle. Both arguments must outlive this object.
  StaticEquations(const Eigen::SparseMatrix<double>& stiffness, const Constraints& constraints);

  bool ready() const { return factor_.status() == numerics::FactorStatus::factorised; }
  const numerics::SymmetricFactor& factor() const { return factor_; }
  const Constraints& constraints() const { return *constraints_; }

  /// `force` (dofs) [N/m]. One step of iterative refinement: the residual is at round-off also where stiffnesses differ
  /// by many orders of magnitude. Where the factor is not ready the prescribed displacements alone are returned.
  [[nodiscard]] StaticSolution solve(const Eigen::VectorXd& force) const;

  /// The same from a displacement (dofs) that is right up to round-off.
  [[nodiscard]] StaticSolution refine(Eigen::VectorXd displacement, const Eigen::VectorXd& force) const;

 private:
  Eigen::VectorXd right_side(const Eigen::VectorXd& force) const;
  StaticSolution without_answer() const;

  const Eigen::SparseMatrix<double>* stiffness_;
  const Constraints* constraints_;
  Eigen::SparseMatrix<double> constrained_;
  Eigen::VectorXd prescribed_;  ///< what the prescribed displacements add to the right side
  numerics::SymmetricFactor factor_;
};

/// One right side only. `stiffness` (dofs, dofs): lower triangle; `force` (dofs) [N/m].
[[nodiscard]] StaticSolution solve_static(const Eigen::SparseMatrix<double>& stiffness, const Eigen::VectorXd& force,
                                          const Constraints& constraints);

}  // namespace sunder::simulation
