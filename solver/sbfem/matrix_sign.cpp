#include "solver/sbfem/matrix_sign.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;

double log_determinant(const Eigen::LLT<MatrixXd>& factor) {
  return 2.0 * factor.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

RiccatiSolution matrix_sign(MatrixXd E0, MatrixXd F, MatrixXd E2) {
  // Quadratic convergence: after a distance of 1e-8 one more step, unscaled, reaches round-off.
  constexpr double nearly = 1e-8;
  constexpr int most_steps = 60;
  const auto m = static_cast<double>(E0.rows());
  RiccatiSolution result;
  bool last = false;
  while (!result.converged && result.iterations < most_steps) {
    const Eigen::LLT<MatrixXd> factor0(E0), factor2(E2);
    result.positive_definite = factor0.info() == Eigen::Success && factor2.info() == Eigen::Success;
    if (!result.positive_definite) return result;
    const double c = last ? 1.0 : std::exp((log_determinant(factor0) - log_determinant(factor2)) / (2.0 * m));
    const MatrixXd alpha = E0 / c, beta = c * E2, N = F - F.transpose();
    const Eigen::LLT<MatrixXd> S(alpha + beta);
    if (S.info() != Eigen::Success) {
      result.positive_definite = false;
      return result;
    }
    const MatrixXd a = S.matrixL().solve(alpha), b = S.matrixL().solve(beta);
    const MatrixXd f = S.matrixL().solve(F), ft = S.matrixL().solve(F.transpose()), n = f - ft;
    E0 = a.transpose() * b;
    E0 = (E0 + E0.transpose()).eval();
    F.noalias() = b.transpose() * f + a.transpose() * ft;
    E2 = 0.5 * (alpha + beta - n.transpose() * n);
    ++result.iterations;
    result.converged = last;
    last = (E0 - E2).norm() + (F - F.transpose()).norm() <= nearly * (E0.norm() + F.norm());
  }
  const MatrixXd K = E0 + F;
  result.asymmetry = (K - K.transpose()).norm() / K.norm();
  result.K = 0.5 * (K + K.transpose());
  return result;
}

}  // namespace sunder::sbfem
