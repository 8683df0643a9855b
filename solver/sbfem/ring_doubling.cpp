#include "solver/sbfem/ring_doubling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
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

/// The two thicknesses 2/s whose shifts damp [smallest, largest] best [Wachspress 1963].
std::array<double, 2> thicknesses(double smallest, double largest, int shifts) {
  const double geometric = std::sqrt(smallest * largest);
  if (shifts == 1) return {2.0 / geometric, 2.0 / geometric};
  const double w = std::sqrt(geometric * 0.5 * (smallest + largest));
  const double spread = std::sqrt(std::max(0.0, w * w - geometric * geometric));
  return {2.0 / (w + spread), 2.0 / (w - spread)};
}

/// Glues `inner` inside `outer` and leaves the result in `inner`. False where S is not positive definite.
/// `outer_only` leaves A and C as they are: all that the last merge owes is B.
bool merge(Ring& inner, const Ring& outer, Eigen::LLT<MatrixXd>& factor, bool outer_only) {
  factor.compute((inner.B + outer.A).selfadjointView<Eigen::Lower>());
  if (factor.info() != Eigen::Success) return false;
  const MatrixXd Y = factor.matrixL().solve(outer.C);
  inner.B = outer.B;
  inner.B.selfadjointView<Eigen::Lower>().rankUpdate(Y.transpose(), -1.0);
  if (outer_only) return true;
  const MatrixXd X = factor.matrixL().solve(inner.C.transpose());
  inner.A.selfadjointView<Eigen::Lower>().rankUpdate(X.transpose(), -1.0);
  inner.C.noalias() = -X.transpose() * Y;
  return true;
}

}  // namespace

RiccatiSolution ring_doubling(const MatrixXd& E0, const MatrixXd& F, const MatrixXd& E2,
                              const RingDoublingOptions& options) {
  // ‖C‖ ≤ finished ‖B‖: another merge would change B by ‖C‖² only. Below `nearly` one merge of B alone finishes.
  constexpr double finished = 1e-11, nearly = 2e-5;
  RiccatiSolution result;
  Eigen::LLT<MatrixXd> factor(E0);
  if (factor.info() != Eigen::Success) {
    result.positive_definite = false;
    return result;
  }
  const double smallest = options.smallest_exponent;
  const double largest = std::max(largest_exponent(E2, factor), 2.0 * smallest);
  const int shifts = options.shifts == 0 ? 1 : options.shifts;
  const auto [h1, h2] = thicknesses(smallest, largest, shifts);
  Ring stack = ring(E0, F, E2, h1);
  if (shifts == 2) {
    result.positive_definite = merge(stack, ring(E0, F, E2, h2), factor, false);
    ++result.iterations;
  }
  while (result.positive_definite) {
    const double coupling = stack.C.norm(), size = MatrixXd(stack.B.selfadjointView<Eigen::Lower>()).norm();
    if (!std::isfinite(coupling) || !std::isfinite(size)) {
      result.positive_definite = false;
      break;
    }
    result.converged = coupling <= finished * size;
    if (result.converged || result.iterations == options.most_merges) break;
    const bool last = coupling <= nearly * size;
    result.positive_definite = merge(stack, Ring(stack), factor, last);
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
