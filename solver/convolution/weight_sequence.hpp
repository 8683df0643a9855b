#pragma once
/// The weights W_0 … W_N of a convolution: what a unit acceleration in one step does to the forces of that step and the
/// N that follow.

#include <Eigen/Core>

namespace sunder::convolution {

/// All weights symmetric; with `diagonal` only the diagonals are kept, n numbers a step instead of n². Beyond the last,
/// weights are zero.
struct WeightSequence {
  int size = 0;            ///< n, >= 1
  bool diagonal = false;   ///< W_j = diag(column j)
  Eigen::MatrixXd values;  ///< (n·n, N + 1) column-major matrices, or (n, N + 1) [kg/m]

  long long last() const { return values.cols() - 1; }  ///< N
  Eigen::Map<const Eigen::MatrixXd> dense(long long j) const { return {values.col(j).data(), size, size}; }
  Eigen::MatrixXd weight(long long j) const;  ///< (n, n), dense or diagonal
  double bytes() const { return 8.0 * static_cast<double>(values.size()); }
};

/// Throws std::invalid_argument where there is no weight, the shapes disagree, a value is not finite, or a weight is
/// not symmetric to 1e-9 of the largest entry of all.
void check(const WeightSequence& weights);

/// Weights 0 … `last` of `weights`, the rest forgotten; zero follows. For experiments with truncation.
[[nodiscard]] WeightSequence truncated(const WeightSequence& weights, long long last);

}  // namespace sunder::convolution
