#include "solver/numerics/supernodal_values.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace sunder::numerics {
namespace {

using Eigen::Index;
using Panel = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// CHOLMOD's arrays by name.
struct Shape {
  std::span<const int> first;       // (supernodes + 1): the first column of each
  std::span<const int> rows_start;  // (supernodes + 1): where its rows begin
  std::span<const int> values;      // (supernodes + 1): where its panel begins
  const int* rows;
  double* x;

  explicit Shape(const cholmod_factor& factor)
      : first(static_cast<const int*>(factor.super), factor.nsuper + 1),
        rows_start(static_cast<const int*>(factor.pi), factor.nsuper + 1),
        values(static_cast<const int*>(factor.px), factor.nsuper + 1),
        rows(static_cast<const int*>(factor.s)),
        x(static_cast<double*>(factor.x)) {}

  int count() const { return static_cast<int>(first.size()) - 1; }
  int columns(int s) const { return first[s + 1] - first[s]; }
  std::span<const int> rows_of(int s) const {
    return {rows + rows_start[s], static_cast<std::size_t>(rows_start[s + 1] - rows_start[s])};
  }
  double* panel(int s) const { return x + values[s]; }
};

struct Entry {
  int row, column;
  double value;
};

/// The entries of the matrix by supernode, in the factor's order.
struct Entries {
  std::vector<int> start;  // (supernodes + 1)
  std::vector<Entry> all;
};

Entries entries_by_supernode(const Eigen::SparseMatrix<double>& lower, const cholmod_factor& factor, const Shape& shape,
                             const std::vector<int>& supernode_of) {
  const auto* order = static_cast<const int*>(factor.Perm);
  std::vector<int> place(factor.n);
  for (std::size_t i = 0; i < factor.n; ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  Entries entries;
  entries.start.assign(static_cast<std::size_t>(shape.count()) + 1, 0);
  const auto visit = [&](const auto& take) {
    for (int column = 0; column < lower.outerSize(); ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
        if (entry.row() < column) continue;
        const int a = place[static_cast<std::size_t>(entry.row())], b = place[static_cast<std::size_t>(column)];
        take(std::max(a, b), std::min(a, b), entry.value());
      }
    }
  };
  visit([&](int, int column, double) { ++entries.start[static_cast<std::size_t>(supernode_of[column]) + 1]; });
  for (std::size_t s = 1; s < entries.start.size(); ++s) entries.start[s] += entries.start[s - 1];
  entries.all.resize(static_cast<std::size_t>(entries.start.back()));
  std::vector<int> next(entries.start.begin(), entries.start.end() - 1);
  visit([&](int row, int column, double value) {
    entries.all[static_cast<std::size_t>(next[static_cast<std::size_t>(supernode_of[column])]++)] = {row, column,
                                                                                                     value};
  });
  return entries;
}

/// L Lᵀ = A in place on the lower triangle of the first columns of a panel. -1, or the first column without a positive
/// pivot.
int dense_cholesky(Eigen::Ref<Eigen::MatrixXd> A) {
  constexpr Index block = 32;
  const Index n = A.cols();
  for (Index from = 0; from < n; from += block) {
    const Index size = std::min(block, n - from), rest = n - from - size;
    auto D = A.block(from, from, size, size);
    for (Index j = 0; j < size; ++j) {
      if (!(D(j, j) > 0.0)) return static_cast<int>(from + j);
      const double root = std::sqrt(D(j, j));
      D.col(j).tail(size - j) /= root;
      for (Index k = j + 1; k < size; ++k) D.col(k).tail(size - k) -= D(k, j) * D.col(j).tail(size - k);
    }
    if (rest == 0) continue;
    auto below = A.block(from + size, from, rest, size);
    D.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    A.bottomRightCorner(rest, rest).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
  }
  return -1;
}

/// Rows of an update that lie side by side in the panel which it goes to: a node's unknowns at least.
struct Run {
  std::size_t begin, end;  // in the update
  std::size_t place;       // of the first in the panel
};

/// The update's rows from `begin` on, which are among the panel's; both lists ascend.
void find_runs(std::span<const int> rows, std::size_t begin, std::span<const int> of_panel, std::vector<Run>& runs) {
  runs.clear();
  std::size_t at = 0;
  for (std::size_t i = begin; i < rows.size(); ++i, ++at) {
    const bool apart = runs.empty() || of_panel[at] != rows[i];
    while (of_panel[at] != rows[i]) ++at;
    if (apart) runs.push_back({.begin = i, .end = i, .place = at});
    runs.back().end = i + 1;
  }
}

/// Subtracts the update of one supernode, (m, m) on its rows below the diagonal block, from the supernodes above.
void subtract_update(const Shape& shape, const std::vector<int>& supernode_of, std::span<const int> rows,
                     const Panel& update, std::vector<Run>& runs) {
  const std::size_t m = rows.size();
  for (std::size_t begin = 0; begin < m;) {
    const int target = supernode_of[rows[begin]], first = shape.first[target], end_column = shape.first[target + 1];
    std::size_t end = begin;
    while (end < m && rows[end] < end_column) ++end;
    const std::span<const int> of_target = shape.rows_of(target);
    find_runs(rows, begin, of_target, runs);
    std::size_t skipped = 0;
    for (std::size_t j = begin; j < end; ++j) {
      double* column = shape.panel(target) + static_cast<std::size_t>(rows[j] - first) * of_target.size();
      const double* from = update.data() + j * m;
      while (runs[skipped].end <= j) ++skipped;
      for (std::size_t r = skipped; r < runs.size(); ++r) {
        const Run& run = runs[r];
        const std::size_t i = std::max(run.begin, j);
        double* to = column + (run.place + i - run.begin);
        for (std::size_t k = i; k < run.end; ++k) to[k - i] -= from[k];
      }
    }
    begin = end;
  }
}

}  // namespace

int supernodal_values(const Eigen::SparseMatrix<double>& lower, cholmod_factor& factor) {
  const Shape shape(factor);
  std::vector<int> supernode_of(factor.n), position(factor.n);
  Index largest_update = 0;
  for (int s = 0; s < shape.count(); ++s) {
    for (int column = shape.first[s]; column < shape.first[s + 1]; ++column) supernode_of[column] = s;
    largest_update = std::max(largest_update, std::ssize(shape.rows_of(s)) - shape.columns(s));
  }
  std::fill_n(shape.x, factor.xsize, 0.0);
  const Entries entries = entries_by_supernode(lower, factor, shape, supernode_of);
  std::vector<Run> runs;
  std::vector<double> update(static_cast<std::size_t>(largest_update * largest_update));
  for (int s = 0; s < shape.count(); ++s) {
    const std::span<const int> rows = shape.rows_of(s);
    const Index n = shape.columns(s), height = std::ssize(rows), m = height - n;
    for (Index i = 0; i < height; ++i) position[rows[i]] = static_cast<int>(i);
    Panel panel(shape.panel(s), height, n, Eigen::OuterStride<>(height));
    for (int e = entries.start[s]; e < entries.start[s + 1]; ++e) {
      const Entry& entry = entries.all[static_cast<std::size_t>(e)];
      panel(position[entry.row], entry.column - shape.first[s]) += entry.value;
    }
    const int failed = dense_cholesky(panel.topRows(n));
    if (failed >= 0) return shape.first[s] + failed;
    if (m == 0) continue;
    auto below = panel.bottomRows(m);
    panel.topRows(n).triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    Panel product(update.data(), m, m, Eigen::OuterStride<>(m));
    product.triangularView<Eigen::Lower>() = below * below.transpose();
    subtract_update(shape, supernode_of, rows.subspan(static_cast<std::size_t>(n)), product, runs);
  }
  return -1;
}

}  // namespace sunder::numerics
