#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/foundation/impulse_response.hpp"

namespace sunder::foundation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// A x + x Aᵀ = R for A = A0 + shift, from the Schur form A0 = Q T Q*: T y + y T* + 2 shift y = Q* R Q, column by
/// column from the last. R symmetric.
class ShiftedLyapunov {
 public:
  explicit ShiftedLyapunov(const MatrixXd& A0) : schur_(A0.cast<std::complex<double>>()) {}

  MatrixXd solve(double shift, const MatrixXd& R) const {
    const MatrixXcd& Q = schur_.matrixU();
    const MatrixXcd& T = schur_.matrixT();
    const Index n = T.rows();
    MatrixXcd y = Q.adjoint() * R * Q;
    for (Index j = n - 1; j >= 0; --j) {
      for (Index k = j + 1; k < n; ++k) y.col(j) -= std::conj(T(j, k)) * y.col(k);
      MatrixXcd triangle = T;
      triangle.diagonal().array() += std::conj(T(j, j)) + 2.0 * shift;
      triangle.triangularView<Eigen::Upper>().solveInPlace(y.col(j));
    }
    const MatrixXd x = (Q * y * Q.adjoint()).real();
    return 0.5 * (x + x.transpose());
  }

 private:
  Eigen::ComplexSchur<MatrixXcd> schur_;
};

/// What stays the same in all steps.
struct March {
  MatrixXd e1, e2, m0;  ///< e1 - 1, e2 - e1 e1ᵀ, c²
  double dt;

  /// The equation at t with the convolution known: right side for m's own terms.
  MatrixXd known(double t, const MatrixXd& convolution, const MatrixXd& integral) const {
    MatrixXd right = 0.5 * t * t * e2 + m0 - convolution - e1 * integral - integral * e1.transpose();
    return 0.5 * (right + right.transpose());
  }
};

/// The first step is quadratic in m_1: Newton from m_0. Residual: ½(m_0 + m_1) m_1 + ½(m_1 - m_0) m_0 … with m' * m =
/// (m_1 - m_0)(m_0 + m_1)/2.
MatrixXd first_step(const March& march, const MatrixXd& start) {
  const double t = march.dt;
  MatrixXd m = start;
  for (int i = 0; i < 30; ++i) {
    const MatrixXd convolution = start * m + 0.5 * (m - start) * (m + start);
    const MatrixXd integral = 0.5 * t * (start + m);
    const MatrixXd residual = march.known(t, convolution, integral) - t * m;
    const MatrixXd A = 0.5 * (start + m) + 0.5 * t * march.e1;
    const MatrixXd change = ShiftedLyapunov(A).solve(0.5 * t, residual);
    m += change;
    if (change.norm() <= 1e-13 * m.norm()) break;
  }
  return m;
}

}  // namespace

ImpulseSamples march_impulse_response(const UnboundedDomain& domain, double time_step, int count) {
  if (!(time_step > 0.0)) throw std::invalid_argument("time_step must be > 0");
  if (count < 1) throw std::invalid_argument("count = " + std::to_string(count) + ", accepted is >= 1");
  const Index n = domain.size();
  const MatrixXd one = MatrixXd::Identity(n, n), start = domain.c.asDiagonal();
  const March march{domain.e1 - one, domain.e2 - domain.e1 * domain.e1.transpose(), start * start,
                    time_step / domain.time};

  std::vector<MatrixXd> m{start, first_step(march, start)};
  const ShiftedLyapunov lyapunov(0.5 * (m[0] + m[1]) + 0.5 * march.dt * march.e1);
  MatrixXd integral = 0.5 * march.dt * (m[0] + m[1]);
  for (int step = 2; step <= count; ++step) {
    const double t = step * march.dt;
    // What does not hold m_step: (m_1 - m_0) m_{step-1} / 2 - m_{step-1} (m_0 + m_1) / 2 + Σ of the steps between.
    MatrixXd convolution = 0.5 * (m[1] - m[0]) * m[step - 1];
    convolution.noalias() -= 0.5 * m[step - 1] * (m[0] + m[1]);
    for (int k = 2; k < step; ++k) {
      convolution.noalias() += (m[k] - m[k - 1]) * (0.5 * (m[step - k] + m[step - k + 1]));
    }
    const MatrixXd so_far = integral + 0.5 * march.dt * m[step - 1];
    m.push_back(lyapunov.solve(0.5 * t, march.known(t, convolution, so_far)));
    integral = so_far + 0.5 * march.dt * m[step];
  }
  ImpulseSamples result;
  for (const MatrixXd& sample : m) {
    if (!sample.allFinite()) {
      result.status = StiffnessStatus::not_finite;
      result.M.clear();
      return result;
    }
    result.M.push_back(domain.time * (domain.F * sample * domain.F.transpose()));
  }
  return result;
}

}  // namespace sunder::foundation
