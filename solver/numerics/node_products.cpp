#include "solver/numerics/node_products.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver/numerics/lanes.hpp"

namespace sunder::numerics {
namespace {

using Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;
using Four = Lanes::Vector;  // a 2×2 block, column by column, or what a node has of two vectors

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

inline const Four& four(const VectorPair& values, Index column) {
  return *reinterpret_cast<const Four*>(values.data() + 4 * column);
}
inline Four& four(VectorPair& values, Index column) {
  return *reinterpret_cast<Four*>(values.data() + 4 * column);
}

/// One matrix times both vectors, column by column of its lower triangle.
struct Column {
  Four along_x, along_y;                  // x and y of the column's node, each twice for each of two vectors
  Four from_x = Four{}, from_y = Four{};  // what its rows x and y gain of the nodes below: parts to be summed

  explicit Column(Four x)
      : along_x(__builtin_shufflevector(x, x, 0, 0, 2, 2)), along_y(__builtin_shufflevector(x, x, 1, 1, 3, 3)) {}

  /// B x_j
  Four times(Four block) const {
    return __builtin_shufflevector(block, block, 0, 1, 0, 1) * along_x +
           __builtin_shufflevector(block, block, 2, 3, 2, 3) * along_y;
  }
  /// y_i += B x_j, and y_j gains Bᵀ x_i
  void apply(Four block, Four x_i, Four& y_i) {
    const Four left = __builtin_shufflevector(block, block, 0, 1, 0, 1);
    const Four right = __builtin_shufflevector(block, block, 2, 3, 2, 3);
    y_i += left * along_x + right * along_y;
    from_x += left * x_i;
    from_y += right * x_i;
  }
  Four gained() const {
    return __builtin_shufflevector(from_x, from_y, 0, 4, 2, 6) + __builtin_shufflevector(from_x, from_y, 1, 5, 3, 7);
  }
};

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

void NodeProducts::multiply(const VectorPair& x, const VectorPair& z, VectorPair& first_x, VectorPair& second_z) const {
  first_x.setZero(4, x.cols());
  second_z.setZero(4, z.cols());
  const auto* blocks = reinterpret_cast<const Four*>(blocks_.data());
  const auto nodes = static_cast<int>(column_start_.size()) - 1;
  for (int j = 0; j < nodes; ++j) {
    Column first(four(x, j)), second(four(z, j));
    Index b = column_start_[static_cast<std::size_t>(j)];
    const Index end = column_start_[static_cast<std::size_t>(j) + 1];
    const Four of_first = first.times(blocks[2 * b]), of_second = second.times(blocks[2 * b + 1]);  // the diagonal
    for (++b; b < end; ++b) {
      const Index i = row_[static_cast<std::size_t>(b)];
      first.apply(blocks[2 * b], four(x, i), four(first_x, i));
      second.apply(blocks[2 * b + 1], four(z, i), four(second_z, i));
    }
    four(first_x, j) += of_first + first.gained();
    four(second_z, j) += of_second + second.gained();
  }
}

}  // namespace sunder::numerics
