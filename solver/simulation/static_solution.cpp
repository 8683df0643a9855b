#include "solver/simulation/static_solution.hpp"

namespace sunder::simulation {

StaticSolution solve_static(const Eigen::SparseMatrix<double>& stiffness, const Eigen::VectorXd& force,
                            const Constraints& constraints) {
  StaticSolution solution;
  Eigen::SparseMatrix<double> constrained = stiffness;
  Eigen::VectorXd right_side = force;
  const double scale = stiffness.diagonal().cwiseAbs().mean();  // keeps the identity rows among the other pivots
  eliminate(constraints, scale, constrained, right_side);

  const numerics::SymmetricFactor factor(constrained, {.block = 2});
  solution.status = factor.status();
  solution.factor_entries = factor.entries();
  if (solution.status != numerics::FactorStatus::factorised) {
    solution.failed_dof = factor.failed_row();
    solution.displacement = constraints.displacement;
    solution.reaction = Eigen::VectorXd::Zero(force.size());
    return solution;
  }
  solution.pivot_ratio = factor.pivot_ratio();

  Eigen::VectorXd& u = solution.displacement;
  u = right_side;
  factor.solve_in_place(u);
  Eigen::VectorXd correction = right_side - constrained.selfadjointView<Eigen::Lower>() * u;
  factor.solve_in_place(correction);
  u += correction;

  solution.reaction = stiffness.selfadjointView<Eigen::Lower>() * u - force;
  double unbalanced = 0.0;
  for (Eigen::Index dof = 0; dof < force.size(); ++dof) {
    if (!constraints.fixed[dof]) unbalanced += solution.reaction[dof] * solution.reaction[dof];
  }
  const double scale_of_forces = force.norm() + solution.reaction.norm();
  solution.residual = scale_of_forces > 0.0 ? std::sqrt(unbalanced) / scale_of_forces : 0.0;
  return solution;
}

}  // namespace sunder::simulation
