#include "solver/simulation/static_solution.hpp"

namespace sunder::simulation {
namespace {

/// Eliminates in place; the scale keeps the identity rows among the other pivots.
const Eigen::SparseMatrix<double>& eliminated(const Constraints& constraints, Eigen::SparseMatrix<double>& lower,
                                              Eigen::VectorXd& force) {
  eliminate(constraints, lower.diagonal().cwiseAbs().mean(), lower, force);
  return lower;
}

}  // namespace

StaticEquations::StaticEquations(const Eigen::SparseMatrix<double>& stiffness, const Constraints& constraints)
    : stiffness_(&stiffness),
      constraints_(&constraints),
      constrained_(stiffness),
      prescribed_(Eigen::VectorXd::Zero(stiffness.rows())),
      factor_(eliminated(constraints, constrained_, prescribed_), {.block = 2}) {}

Eigen::VectorXd StaticEquations::right_side(const Eigen::VectorXd& force) const {
  Eigen::VectorXd sum = force + prescribed_;
  for (Eigen::Index dof = 0; dof < sum.size(); ++dof) {
    if (constraints_->fixed[dof]) sum[dof] = prescribed_[dof];
  }
  return sum;
}

StaticSolution StaticEquations::without_answer() const {
  StaticSolution solution;
  solution.status = factor_.status();
  solution.factor_entries = factor_.entries();
  solution.failed_dof = factor_.failed_row();
  solution.displacement = constraints_->displacement;
  solution.reaction = Eigen::VectorXd::Zero(prescribed_.size());
  return solution;
}

StaticSolution StaticEquations::solve(const Eigen::VectorXd& force) const {
  if (!ready()) return without_answer();
  Eigen::VectorXd u = right_side(force);
  factor_.solve_in_place(u);
  return refine(std::move(u), force);
}

StaticSolution StaticEquations::refine(Eigen::VectorXd displacement, const Eigen::VectorXd& force) const {
  if (!ready()) return without_answer();
  StaticSolution solution;
  solution.factor_entries = factor_.entries();
  solution.pivot_ratio = factor_.pivot_ratio();
  solution.displacement = std::move(displacement);
  Eigen::VectorXd& u = solution.displacement;
  Eigen::VectorXd correction = right_side(force) - constrained_.selfadjointView<Eigen::Lower>() * u;
  factor_.solve_in_place(correction);
  u += correction;

  solution.reaction = stiffness_->selfadjointView<Eigen::Lower>() * u - force;
  double unbalanced = 0.0;
  for (Eigen::Index dof = 0; dof < force.size(); ++dof) {
    if (!constraints_->fixed[dof]) unbalanced += solution.reaction[dof] * solution.reaction[dof];
  }
  const double scale_of_forces = force.norm() + solution.reaction.norm();
  solution.residual = scale_of_forces > 0.0 ? std::sqrt(unbalanced) / scale_of_forces : 0.0;
  return solution;
}

StaticSolution solve_static(const Eigen::SparseMatrix<double>& stiffness, const Eigen::VectorXd& force,
                            const Constraints& constraints) {
  return StaticEquations(stiffness, constraints).solve(force);
}

}  // namespace sunder::simulation
