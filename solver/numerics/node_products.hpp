#pragma once
/// Products of two symmetric matrices with two vectors each, in one pass: stiffness and mass of a body whose nodes have
/// two unknowns. Both have the pattern of the mesh; one list of 2×2 blocks of the lower triangle serves both, and each
/// block is read once, for itself and its transpose and for both vectors. The order of summation is fixed: same bits in
/// every run.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace sunder::numerics {

/// Two vectors (2n) node by node: column i holds both unknowns of node i in the first, then in the second.
using VectorPair = Eigen::Matrix<double, 4, Eigen::Dynamic>;

class NodeProducts {
 public:
  /// Lower triangles (2n, 2n), compressed; the pattern is the union of both. Throws std::invalid_argument where they
  /// are not square, of one size, and even.
  NodeProducts(const Eigen::SparseMatrix<double>& first, const Eigen::SparseMatrix<double>& second);

  /// first_x = A₁ x and second_z = A₂ z, all (4, n), for both vectors of x and of z; results must not be operands.
  /// Allocates nothing where they have their size.
  void multiply(const VectorPair& x, const VectorPair& z, VectorPair& first_x, VectorPair& second_z) const;

 private:
  std::vector<int> column_start_, row_;              // (n + 1), (blocks): the first block of a column is its diagonal
  Eigen::Matrix<double, 4, Eigen::Dynamic> blocks_;  // (4, 2 blocks): first and second in turn, column by column
};

}  // namespace sunder::numerics
