#include "solver/sbfem/ring_doubling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;

struct Ring {
  MatrixXd A, B, C;  // K00, K11, K01; of A and B the lower triangle is kept up
};

Ring ring(const MatrixXd& E0, const MatrixXd& F, const MatrixXd& E2, double h) {
  const MatrixXd stiff = E0 / h + (h / 4.0) * E2, symmetric = 0.5 * (F + F.transpose());
  return {stiff - symmetric, stiff + symmetric, (h / 4.0) * E2 - E0 / h + 0.5 * (F.transpose() - F)};
}

/// λ_max ≈ √(largest eigenvalue of E0⁻¹ E2) by a few power steps: it chooses the shift and needs one digit.
double largest_exponent(const MatrixXd& E2, const Eigen::LLT<MatrixXd>& E0) {
  constexpr int power_steps = 6;
  // A start that is not orthogonal to smooth or to oscillating modes, the same in every run.
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(E2.rows(), 1.0, 2.0);
  for (Eigen::Index i = 1; i < x.size(); i += 2) x[i] = -x[i];
  double largest = 1.0;
  for (int step = 0; step < power_steps; ++step) {
    const Eigen::VectorXd next = E0.solve(E2 * x);
    largest = next.norm() / x.norm();
    x = next / next.norm();
  }
  return std::sqrt(largest);
}

/// Glues the stack to itself. False where S is not positive definite. `outer_only` leaves A and C as they are: all that
/// the last merge owes is B.
bool merge(Ring& stack, Eigen::LLT<MatrixXd>& factor, bool outer_only) {
  factor.compute((stack.A + stack.B).selfadjointView<Eigen::Lower>());
  if (factor.info() != Eigen::Success) return false;
  const MatrixXd Y = factor.matrixL().solve(stack.C);
  stack.B.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose(), -1.0);
  if (outer_only) return true;
  const MatrixXd X = factor.matrixL().solve(stack.C.transpose());
  stack.A.selfadjointView<Eigen::Lower>().rankUpdate(X.transpose(), -1.0);
  stack.C.noalias() = -X.transpose() * Y;
  return true;
}

}  // namespace

RiccatiSolution ring_doubling(const MatrixXd& E0, const MatrixXd& F, const MatrixXd& E2) {
  RiccatiSolution result;
  Eigen::LLT<MatrixXd> factor(E0);
  if (factor.info() != Eigen::Success) {
    result.positive_definite = false;
    return result;
  }
  const double largest = std::max(1.0, largest_exponent(E2, factor));
  const double nearly = ring_doubling_nearly / largest;
  Ring stack = ring(E0, F, E2, 2.0 / std::min(std::sqrt(largest), ring_doubling_largest_shift));
  while (result.positive_definite) {
    const double coupling = stack.C.norm(), size = stack.B.diagonal().norm();
    if (!std::isfinite(coupling) || !std::isfinite(size)) {
      result.positive_definite = false;
      break;
    }
    result.converged = coupling <= ring_doubling_finished * size;
    if (result.converged || result.iterations == ring_doubling_most_merges) break;
    const bool last = coupling <= nearly * size;
    result.positive_definite = merge(stack, factor, last);
    ++result.iterations;
    if (last) {
      result.converged = result.positive_definite;
      break;
    }
  }
  result.K = stack.B.selfadjointView<Eigen::Lower>();
  return result;
}

}  // namespace sunder::sbfem
