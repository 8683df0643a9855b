#include "solver/foundation/unbounded_domain.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::foundation {
namespace {

using Eigen::MatrixXd;

constexpr int series_terms = 24;  // divergent in the end: dynamic_stiffness chooses how many it uses

/// x with c x + x c = right, c diagonal.
MatrixXd lyapunov(const Eigen::VectorXd& c, const MatrixXd& right) {
  const Eigen::Index n = c.size();
  return right.array() / (c.replicate(1, n) + c.transpose().replicate(n, 1)).array();
}

/// The coefficient of σ^{2-m}, m >= 2, of the equation:
/// c s_m + s_m c = (2 - m) s_{m-1} - Σ_{i=1}^{m-1} g_i g_{m-i}ᵀ + [m = 2] e2, with s_0 = c, s_1 = k, s_{1+j} = a_j and
/// g_1 = k + e1, g_i = s_i.
std::vector<MatrixXd> series_of(const UnboundedDomain& domain) {
  std::vector<MatrixXd> g{domain.k + domain.e1};  // g_1, g_2, …
  for (int m = 2; m < 2 + series_terms; ++m) {
    MatrixXd right = m == 2 ? domain.e2 : MatrixXd((2.0 - m) * g.back());
    for (int i = 1; i < m; ++i) right.noalias() -= g[i - 1] * g[m - i - 1].transpose();
    g.push_back(lyapunov(domain.c, 0.5 * (right + right.transpose())));
  }
  return {g.begin() + 1, g.end()};
}

}  // namespace

UnboundedDomain unbounded_domain(const sbfem::Coefficients& coefficients) {
  if (coefficients.M0.size() == 0) {
    throw std::invalid_argument("density of the unbounded domain = 0, accepted is > 0: without inertia no wave");
  }
  const Eigen::LLT<MatrixXd> E0(coefficients.E0);
  if (E0.info() != Eigen::Success) throw std::invalid_argument("E0 of the unbounded domain is not positive definite");
  const auto normal = [&](const MatrixXd& X) -> MatrixXd {  // U⁻ᵀ X U⁻¹
    const MatrixXd left = E0.matrixL().solve(X);
    return E0.matrixL().solve(left.transpose()).transpose();
  };
  const MatrixXd m0 = normal(coefficients.M0);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(0.5 * (m0 + m0.transpose()));
  if (modes.info() != Eigen::Success || !(modes.eigenvalues()[0] > 0.0)) {
    throw std::invalid_argument("M0 of the unbounded domain is not positive definite");
  }
  const MatrixXd& V = modes.eigenvectors();

  UnboundedDomain domain;
  domain.F.noalias() = E0.matrixL() * V;
  domain.c = modes.eigenvalues().cwiseSqrt();
  domain.time = domain.c.maxCoeff();
  domain.c /= domain.time;
  domain.e1.noalias() = V.transpose() * normal(coefficients.E1) * V;
  if (numerics::planted_fault("foundation/e1-transposed")) domain.e1.transposeInPlace();
  domain.e2.noalias() = V.transpose() * normal(coefficients.E2) * V;
  domain.e2 = (0.5 * (domain.e2 + domain.e2.transpose())).eval();
  const MatrixXd e1c = domain.e1 * domain.c.asDiagonal();
  domain.k = lyapunov(domain.c, MatrixXd(domain.c.asDiagonal()) - e1c - e1c.transpose());
  if (numerics::planted_fault("foundation/asymptote-sign")) domain.k = -domain.k;
  domain.series = series_of(domain);
  return domain;
}

}  // namespace sunder::foundation
