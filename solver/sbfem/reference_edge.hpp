#pragma once
/// The integrals over a straight edge that depend on its order alone.

#include <Eigen/Core>

namespace sunder::sbfem {

/// On a straight edge J_b is constant and x_b is linear in η, so every coefficient matrix is a few 2 × 2 blocks times
/// these numbers. N: Lagrange polynomials on the p + 1 Gauss-Lobatto points; ' = d/dη; all (p + 1, p + 1).
struct ReferenceEdge {
  int order = 0;
  Eigen::VectorXd points;   ///< (p + 1) Gauss-Lobatto points on [-1, 1]
  Eigen::MatrixXd NN;       ///< ∫ Nᵀ N dη
  Eigen::MatrixXd dNN[2];   ///< ∫ η^k N'ᵀ N dη, k = 0, 1
  Eigen::MatrixXd dNdN[3];  ///< ∫ η^k N'ᵀ N' dη, k = 0, 1, 2
};

/// 1 <= order <= 64; p + 1 Gauss points integrate degree 2p + 1 >= 2p exactly.
/// Throws std::invalid_argument where the order is out of range.
ReferenceEdge reference_edge(int order);

}  // namespace sunder::sbfem
