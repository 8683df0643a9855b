#include "solver/numerics/node_products.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sunder::numerics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A symmetric matrix (2n, 2n) in which node i meets i ± 1 and i ± `stride`, each of its 2×2 blocks full.
MatrixXd mesh_like(int nodes, int stride, double seed) {
  MatrixXd A = MatrixXd::Zero(2 * nodes, 2 * nodes);
  double value = seed;
  for (int i = 0; i < nodes; ++i) {
    for (const int j : {i, i - 1, i - stride}) {
      if (j < 0) continue;
      for (int r = 0; r < 2; ++r) {
        for (int c = 0; c < 2; ++c) A(2 * i + r, 2 * j + c) = value = std::fmod(value * 1.7 + 0.3, 2.0) - 1.0;
      }
    }
  }
  return A.selfadjointView<Eigen::Lower>();
}

VectorPair pair(const VectorXd& a, const VectorXd& b) {
  VectorPair both(4, a.size() / 2);
  both.topRows(2) = a.reshaped(2, a.size() / 2);
  both.bottomRows(2) = b.reshaped(2, b.size() / 2);
  return both;
}

TEST(NodeProducts, AreThoseOfTheDenseMatrices) {
  for (const int nodes : {1, 2, 9, 40}) {
    const MatrixXd A = mesh_like(nodes, 5, 0.1), B = mesh_like(nodes, 3, 0.7);  // patterns of their own
    const VectorXd x = VectorXd::LinSpaced(2 * nodes, -1.0, 2.0), z = x.cwiseAbs2() - 0.4 * x;
    const MatrixXd lower_A = A.triangularView<Eigen::Lower>(), lower_B = B.triangularView<Eigen::Lower>();
    const NodeProducts products(lower_A.sparseView(), lower_B.sparseView());
    const VectorXd w = x.reverse() - z, q = z.reverse() + x;
    VectorPair of_A, of_B;
    products.multiply(pair(x, w), pair(z, q), of_A, of_B);
    // a dozen terms of size 10 a row
    EXPECT_LT((of_A - pair(A * x, A * w)).cwiseAbs().maxCoeff(), 3e-14) << nodes;
    EXPECT_LT((of_B - pair(B * z, B * q)).cwiseAbs().maxCoeff(), 3e-14) << nodes;
  }
}

TEST(NodeProducts, DoNotReadAboveTheDiagonal) {
  const MatrixXd A = mesh_like(4, 2, 0.2);
  const MatrixXd lower = A.triangularView<Eigen::Lower>();
  const NodeProducts whole(A.sparseView(), A.sparseView()), half(lower.sparseView(), lower.sparseView());
  const VectorXd x = VectorXd::LinSpaced(8, 1.0, 2.0);
  const VectorPair twice = pair(x, x);
  VectorPair a, b, c, d;
  whole.multiply(twice, twice, a, b);
  half.multiply(twice, twice, c, d);
  EXPECT_EQ(a, c);
  EXPECT_EQ(b, d);
}

TEST(NodeProducts, RefuseSizesThatDoNotFit) {
  using Sparse = Eigen::SparseMatrix<double>;
  EXPECT_THROW((void)NodeProducts(Sparse(3, 3), Sparse(3, 3)), std::invalid_argument);
  EXPECT_THROW((void)NodeProducts(Sparse(4, 4), Sparse(2, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::numerics
