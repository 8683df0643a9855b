#pragma once
/// Unilateral contact by the simplest method there is, to judge faster ones.

#include <Eigen/Core>

namespace sunder::exact {

struct Unilateral {
  Eigen::VectorXd force;  ///< λ ≥ 0
  double residual = 0.0;  ///< max |min(λ_i F_ii, g_i)| / max |g⁰|
  int sweeps = 0;
};

/// 0 ≤ λ ⊥ g⁰ + F λ ≥ 0 with F (n, n) symmetric positive definite, by projected Gauss-Seidel sweeps with
/// over-relaxation: each pair in turn takes the force that closes its own gap [Cryer 1971]. Until the residual is at
/// most `tolerance` or the sweeps run out. Converges always, slowly. `start` (n) ≥ 0.
Unilateral projected_gauss_seidel(const Eigen::MatrixXd& F, const Eigen::VectorXd& gap, const Eigen::VectorXd& start,
                                  double tolerance, int most_sweeps, double relaxation = 1.7);

}  // namespace sunder::exact
