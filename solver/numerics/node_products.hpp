#pragma once
/// Products of two symmetric matrices with one vector each, in one pass: stiffness and mass of a body whose nodes have
/// two unknowns. Both have the pattern of the mesh; one list of 2×2 blocks of the lower triangle serves both, and each
/// block is read once for itself and its transpose. The order of summation is fixed: same bits in every run.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace sunder::numerics {

class NodeProducts {
 public:
  /// Lower triangles (2n, 2n), compressed; the pattern is the union of both. Throws std::invalid_argument where they
  /// are not square, of one size, and even.
  NodeProducts(const Eigen::SparseMatrix<double>& first, const Eigen::SparseMatrix<double>& second);

  /// first_x = A₁ x and second_z = A₂ z, all (2n); results must not be operands. Allocates nothing.
  void multiply(const Eigen::VectorXd& x, const Eigen::VectorXd& z, Eigen::VectorXd& first_x,
                Eigen::VectorXd& second_z) const;

 private:
  std::vector<int> column_start_, row_;              // (n + 1), (blocks): the first block of a column is its diagonal
  Eigen::Matrix<double, 4, Eigen::Dynamic> blocks_;  // (4, 2 blocks): first and second in turn, column by column
};

}  // namespace sunder::numerics
