#include "solver/numerics/ordered_schur.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

/// X (p, q) and γ of A11 X - X A22 = γ A12 by full pivoting on the Kronecker form of order p q <= 4.
Small exchange_basis(const Small& A11, const Small& A22, const Small& A12) {
  const Index p = A11.rows(), q = A22.rows();
  Small kronecker = Small::Zero(p * q, p * q);
  for (Index j = 0; j < q; ++j) {
    kronecker.block(j * p, j * p, p, p) += A11;
    for (Index k = 0; k < q; ++k) {
      for (Index i = 0; i < p; ++i) kronecker(j * p + i, k * p + i) -= A22(k, j);
    }
  }
  const Eigen::FullPivLU<Small> factor(kronecker);
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1> x =
      factor.solve(Eigen::Map<const Eigen::VectorXd>(Small(A12).data(), p * q));
  // [-X; γ I] scaled so that neither part overflows.
  const double gamma = 1.0 / std::max(1.0, x.cwiseAbs().maxCoeff());
  Small basis(p + q, q);
  basis.topRows(p) = -gamma * Eigen::Map<const MatrixXd>(x.data(), p, q);
  basis.bottomRows(q) = gamma * Small::Identity(q, q);
  return basis;
}

/// Exchanges the block of order p at `at` with the block of order q behind it. False where round-off would be exceeded.
bool exchange(MatrixXd& T, MatrixXd& U, Index at, Index p, Index q, double norm) {
  const Index n = T.rows(), size = p + q;
  const Small basis = exchange_basis(T.block(at, at, p, p), T.block(at + p, at + p, q, q), T.block(at, at + p, p, q));
  if (!basis.allFinite()) return false;
  const Eigen::HouseholderQR<Small> qr(basis);
  const Small Q = qr.householderQ() * Small::Identity(size, size);
  const Small block = Q.transpose() * T.block(at, at, size, size) * Q;
  // The part that should vanish is dropped: it must be round-off of the whole matrix.
  if (!(block.bottomLeftCorner(p, q).norm() <= 20.0 * std::numeric_limits<double>::epsilon() * norm)) return false;
  T.block(at, at, size, n - at) = (Q.transpose() * T.block(at, at, size, n - at)).eval();
  T.block(0, at, at + size, size) = (T.block(0, at, at + size, size) * Q).eval();
  T.block(at + q, at, p, q).setZero();
  U.middleCols(at, size) = (U.middleCols(at, size) * Q).eval();
  return true;
}

struct Block {
  Index size;
  bool wanted;
};

std::vector<Block> blocks_of(const MatrixXd& T, const std::function<bool(double, double)>& wanted) {
  std::vector<Block> blocks;
  for (Index i = 0; i < T.rows();) {
    if (i + 1 == T.rows() || T(i + 1, i) == 0.0) {
      blocks.push_back({1, wanted(T(i, i), 0.0)});
      i += 1;
      continue;
    }
    const double mean = 0.5 * (T(i, i) + T(i + 1, i + 1)), half = 0.5 * (T(i, i) - T(i + 1, i + 1));
    const double product = half * half + T(i, i + 1) * T(i + 1, i);
    // A real pair that was not split: both are on the same side or the pair is asked by its mean.
    blocks.push_back({2, wanted(mean, product < 0.0 ? std::sqrt(-product) : 0.0)});
    i += 2;
  }
  return blocks;
}

}  // namespace

OrderedSchur ordered_schur(const MatrixXd& A, const std::function<bool(double, double)>& wanted) {
  OrderedSchur result;
  if (!A.allFinite()) {
    result.status = SchurStatus::not_converged;
    return result;
  }
  const Eigen::RealSchur<MatrixXd> schur(A);
  if (schur.info() != Eigen::Success) {
    result.status = SchurStatus::not_converged;
    return result;
  }
  result.T = schur.matrixT();
  result.U = schur.matrixU();
  std::vector<Block> blocks = blocks_of(result.T, wanted);
  const double norm = result.T.norm();
  std::size_t front = 0;  // blocks before this one are wanted
  Index front_row = 0, row = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block block = blocks[b];
    const Index own_row = row;
    row += block.size;
    if (!block.wanted) continue;
    // Moves up past every unwanted block in between.
    Index at = own_row;
    for (std::size_t k = b; k > front; --k) {
      at -= blocks[k - 1].size;
      if (!exchange(result.T, result.U, at, blocks[k - 1].size, block.size, norm)) {
        result.status = SchurStatus::swap_refused;
        return result;
      }
      std::swap(blocks[k - 1], blocks[k]);
    }
    ++front;
    front_row += block.size;
  }
  result.selected = static_cast<int>(front_row);
  return result;
}

Eigen::VectorXd balance(MatrixXd& A) {
  const Index n = A.rows();
  Eigen::VectorXd D = Eigen::VectorXd::Ones(n);
  constexpr int most_sweeps = 100;
  bool changed = A.allFinite();
  for (int sweep = 0; changed && sweep < most_sweeps; ++sweep) {
    changed = false;
    for (Index i = 0; i < n; ++i) {
      const double column = A.col(i).norm(), row = A.row(i).norm();
      if (column == 0.0 || row == 0.0) continue;
      const double power = std::exp2(std::round(0.5 * std::log2(row / column)));
      // Worth the change only where row and column together shrink by 5 %.
      if (column * power + row / power >= 0.95 * (column + row)) continue;
      A.col(i) *= power;
      A.row(i) /= power;
      D[i] *= power;
      changed = true;
    }
  }
  return D;
}

}  // namespace sunder::numerics
