#include "solver/sbfem/ring_doubling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;

/// A stack of rings. Of A = K00 and B = K11 the lower triangle is kept up; with C = K01, W = [Cᵀ C] side by side, so
/// that a merge is one factorisation, one triangular solve and one symmetric product.
struct Stack {
  MatrixXd A, B;  // (m, m)
  MatrixXd W;     // (m, 2m)
  MatrixXd G;     // (2m, 2m) Wᵀ S⁻¹ W of the last merge
};

Stack first_ring(const MatrixXd& E0, const MatrixXd& F, const MatrixXd& E2, double h) {
  const auto m = E0.rows();
  Stack stack;
  const MatrixXd e0 = E0 / h, e2 = (h / 4.0) * E2, transposed = 0.5 * F.transpose(), f = 0.5 * F;
  stack.A = e0 + e2 - f - transposed;
  stack.B = e0 + e2 + f + transposed;
  stack.W.resize(m, 2 * m);
  stack.W.leftCols(m) = e2 - e0 + f - transposed;
  stack.W.rightCols(m) = e2 - e0 + transposed - f;
  stack.G.resize(2 * m, 2 * m);
  return stack;
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
bool merge(Stack& stack, Eigen::LLT<MatrixXd>& factor, bool outer_only) {
  const auto m = stack.A.rows();
  factor.compute(stack.A + stack.B);  // reads the lower triangle only
  if (factor.info() != Eigen::Success) return false;
  if (outer_only) {
    auto Y = stack.W.rightCols(m);
    factor.matrixL().solveInPlace(Y);
    stack.B.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose(), -1.0);
    return true;
  }
  factor.matrixL().solveInPlace(stack.W);
  stack.G.setZero();
  stack.G.selfadjointView<Eigen::Lower>().rankUpdate(stack.W.transpose());
  stack.A.triangularView<Eigen::Lower>() -= stack.G.topLeftCorner(m, m);
  stack.B.triangularView<Eigen::Lower>() -= stack.G.bottomRightCorner(m, m);
  stack.W.leftCols(m) = -stack.G.bottomLeftCorner(m, m);
  stack.W.rightCols(m) = -stack.G.bottomLeftCorner(m, m).transpose();
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
  Stack stack = first_ring(E0, F, E2, 2.0 / std::min(std::sqrt(largest), ring_doubling_largest_shift));
  while (result.positive_definite) {
    const double coupling = stack.W.rightCols(E0.rows()).norm(), size = stack.B.diagonal().norm();
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
