#pragma once
/// Flexibilities for the tests, and the complementarity problem solved by trying every set of pairs.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace sunder::contact::tests {

/// Numbers in -1 … 1, the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(static_cast<std::int64_t>(state_)) * 0x1p-63;
  }

 private:
  std::uint64_t state_;
};

/// G Gᵀ with G (n, rank): singular where rank < n.
inline Eigen::MatrixXd random_flexibility(int n, int rank, Random& random) {
  Eigen::MatrixXd G(n, rank);
  for (int j = 0; j < rank; ++j) {
    for (int i = 0; i < n; ++i) G(i, j) = random.next();
  }
  return G * G.transpose();
}

inline Eigen::VectorXd random_vector(int n, Random& random) {
  Eigen::VectorXd v(n);
  for (int i = 0; i < n; ++i) v[i] = random.next();
  return v;
}

/// Like that of a crack face: a point force moves the face by the logarithm of the distance, here smoothed by the
/// spacing; positive definite, every pair feels every other.
inline Eigen::MatrixXd face_flexibility(int n) {
  Eigen::MatrixXd F(n, n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) F(i, j) = std::log(2.0 * n / std::hypot(i - j, 0.5));
  }
  return 1e-10 * F;
}

/// 0 ≤ λ ⊥ q + M λ ≥ 0 by trying all 2ⁿ sets. M must be positive definite. Empty where round-off hides the answer.
inline Eigen::VectorXd by_enumeration(const Eigen::MatrixXd& M, const Eigen::VectorXd& q) {
  const int n = static_cast<int>(q.size());
  for (int set = 0; set < (1 << n); ++set) {
    Eigen::MatrixXd closed = M;  // rows and columns of open pairs are those of the identity: their force is zero
    Eigen::VectorXd lambda = -q;
    for (int i = 0; i < n; ++i) {
      if ((set >> i & 1) != 0) continue;
      closed.row(i).setZero();
      closed.col(i).setZero();
      closed(i, i) = 1.0;
      lambda[i] = 0.0;
    }
    closed.llt().solveInPlace(lambda);
    const Eigen::VectorXd gap = q + M * lambda;
    bool right = lambda.minCoeff() >= 0.0;
    for (int i = 0; i < n; ++i) right = right && ((set >> i & 1) != 0 || gap[i] >= 0.0);
    if (right) return lambda;
  }
  return {};
}

}  // namespace sunder::contact::tests
