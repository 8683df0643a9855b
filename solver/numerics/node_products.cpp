#include "solver/numerics/node_products.hpp"

#include <algorithm>
#include <stdexcept>

namespace sunder::numerics {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Four = Eigen::Array4d;  // a 2×2 block, column by column
using Two = Eigen::Array2d;

/// Rows of node `column` in the lower triangle of either matrix, ascending, the column itself first.
std::vector<int> rows_of(const Sparse& first, const Sparse& second, int column) {
  std::vector<int> rows{column};
  for (const Sparse* matrix : {&first, &second}) {
    for (const int k : {2 * column, 2 * column + 1}) {
      for (Sparse::InnerIterator entry(*matrix, k); entry; ++entry)
        if (entry.row() >= k) rows.push_back(static_cast<int>(entry.row()) / 2);
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// y_i += B x_j, and y_j gains Bᵀ x_i in `gained` (two halves to be summed).
inline void apply(const Four& block, const Two& x_j, const double* x_i, double* y_i, Four& gained) {
  Eigen::Map<Two> into(y_i);
  into += block.head<2>() * x_j[0] + block.tail<2>() * x_j[1];
  Four twice;
  twice << x_i[0], x_i[1], x_i[0], x_i[1];
  gained += block * twice;
}

}  // namespace

NodeProducts::NodeProducts(const Sparse& first, const Sparse& second) {
  if (first.rows() != first.cols() || second.rows() != first.rows() || second.cols() != first.rows() ||
      first.rows() % 2 != 0) {
    throw std::invalid_argument("NodeProducts: two square matrices of one even size are needed");
  }
  const int nodes = static_cast<int>(first.rows()) / 2;
  column_start_.push_back(0);
  for (int node = 0; node < nodes; ++node) {
    const std::vector<int> rows = rows_of(first, second, node);
    row_.insert(row_.end(), rows.begin(), rows.end());
    column_start_.push_back(static_cast<int>(row_.size()));
  }
  blocks_.setZero(4, 2 * std::ssize(row_));
  const Sparse* matrices[] = {&first, &second};
  for (int which = 0; which < 2; ++which) {
    for (int k = 0; k < 2 * nodes; ++k) {
      const auto begin = row_.begin() + column_start_[k / 2], end = row_.begin() + column_start_[k / 2 + 1];
      for (Sparse::InnerIterator entry(*matrices[which], k); entry; ++entry) {
        if (entry.row() < k) continue;
        const int i = static_cast<int>(entry.row());
        const Index block = 2 * (std::lower_bound(begin, end, i / 2) - row_.begin()) + which;
        blocks_(2 * (k % 2) + i % 2, block) = entry.value();
        if (i / 2 == k / 2) blocks_(2 * (i % 2) + k % 2, block) = entry.value();  // a diagonal block is whole
      }
    }
  }
}

void NodeProducts::multiply(const VectorXd& x, const VectorXd& z, VectorXd& first_x, VectorXd& second_z) const {
  first_x.setZero(x.size());
  second_z.setZero(z.size());
  const auto nodes = static_cast<int>(column_start_.size()) - 1;
  for (int j = 0; j < nodes; ++j) {
    const Two x_j = x.segment<2>(2 * j), z_j = z.segment<2>(2 * j);
    Four first_gained = Four::Zero(), second_gained = Four::Zero();
    for (int b = column_start_[static_cast<std::size_t>(j)]; b < column_start_[static_cast<std::size_t>(j) + 1]; ++b) {
      const int i = row_[static_cast<std::size_t>(b)];
      const Four first = blocks_.col(2 * b), second = blocks_.col(2 * b + 1);
      if (i == j) {  // a symmetric block counts once
        first_x.segment<2>(2 * j).array() += first.head<2>() * x_j[0] + first.tail<2>() * x_j[1];
        second_z.segment<2>(2 * j).array() += second.head<2>() * z_j[0] + second.tail<2>() * z_j[1];
        continue;
      }
      apply(first, x_j, x.data() + 2 * i, first_x.data() + 2 * i, first_gained);
      apply(second, z_j, z.data() + 2 * i, second_z.data() + 2 * i, second_gained);
    }
    first_x[2 * j] += first_gained[0] + first_gained[1];
    first_x[2 * j + 1] += first_gained[2] + first_gained[3];
    second_z[2 * j] += second_gained[0] + second_gained[1];
    second_z[2 * j + 1] += second_gained[2] + second_gained[3];
  }
}

}  // namespace sunder::numerics
