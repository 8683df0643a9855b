#include "solver/numerics/factor_panels.hpp"

#include <algorithm>

namespace sunder::numerics {
namespace {

using Eigen::Index;

constexpr Index together = 8;  ///< right sides that share a pass
constexpr Index few = 2;       ///< right sides for which single passes are cheaper than one of eight

/// Four doubles anywhere in memory.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

inline Four load(const double* at) {
  return *reinterpret_cast<const Four*>(at);
}
inline void store(double* at, Four value) {
  *reinterpret_cast<Four*>(at) = value;
}
inline double sum(Four value) {
  return (value[0] + value[1]) + (value[2] + value[3]);
}

struct Panel {
  const double* Q;
  Index rows, columns;  // w + m, w
  const int* row;       // (rows), the first `columns` are its own
  Index first;          // its first own row

  Panel(const FactorPanels& panels, int s)
      : Q(panels.values + panels.first_value[s]),
        rows(panels.first_row[s + 1] - panels.first_row[s]),
        columns(panels.first_column[s + 1] - panels.first_column[s]),
        row(panels.row.data() + panels.first_row[s]),
        first(panels.first_column[s]) {}
};

/// result[i] = Σ_j Q_ij b_j for 4·fours rows at once.
template <int fours>
inline void tile_times(const double* Q, Index rows, Index columns, const double* b, double* result) {
  Four sums[fours] = {};
  for (Index j = 0; j < columns; ++j, Q += rows) {
    for (int k = 0; k < fours; ++k) sums[k] += load(Q + 4 * k) * b[j];
  }
  for (int k = 0; k < fours; ++k) store(result + 4 * k, sums[k]);
}

void times(const Panel& panel, const double* b, double* result) {
  Index i = 0;
  // above the diagonal nothing stands
  const auto columns = [&](Index end) { return std::min(panel.columns, end); };
  for (; i + 16 <= panel.rows; i += 16) tile_times<4>(panel.Q + i, panel.rows, columns(i + 16), b, result + i);
  for (; i + 8 <= panel.rows; i += 8) tile_times<2>(panel.Q + i, panel.rows, columns(i + 8), b, result + i);
  for (; i + 4 <= panel.rows; i += 4) tile_times<1>(panel.Q + i, panel.rows, columns(i + 4), b, result + i);
  for (; i < panel.rows; ++i) {
    double value = 0.0;
    for (Index j = 0; j < panel.columns; ++j) value += panel.Q[i + j * panel.rows] * b[j];
    result[i] = value;
  }
}

/// x[j] = Σ_{i >= first} Q_ij v_i for some columns at once.
template <int columns>
inline void tile_transposed_times(const double* Q, Index rows, Index first_row, const double* v, double* x) {
  Four even[columns] = {}, odd[columns] = {};
  Index i = first_row;
  for (; i + 8 <= rows; i += 8) {
    const Four first = load(v + i), second = load(v + i + 4);
    for (int k = 0; k < columns; ++k) {
      even[k] += load(Q + k * rows + i) * first;
      odd[k] += load(Q + k * rows + i + 4) * second;
    }
  }
  if (i + 4 <= rows) {
    const Four first = load(v + i);
    for (int k = 0; k < columns; ++k) even[k] += load(Q + k * rows + i) * first;
    i += 4;
  }
  for (int k = 0; k < columns; ++k) {
    double value = sum(even[k] + odd[k]);
    for (Index rest = i; rest < rows; ++rest) value += Q[k * rows + rest] * v[rest];
    x[k] = value;
  }
}

void transposed_times(const Panel& panel, const double* v, double* x) {
  Index j = 0;
  for (; j + 4 <= panel.columns; j += 4) tile_transposed_times<4>(panel.Q + j * panel.rows, panel.rows, j, v, x + j);
  for (; j + 2 <= panel.columns; j += 2) tile_transposed_times<2>(panel.Q + j * panel.rows, panel.rows, j, v, x + j);
  if (j < panel.columns) tile_transposed_times<1>(panel.Q + j * panel.rows, panel.rows, j, v, x + j);
}

void solve_one(const FactorPanels& panels, double* values, double* x, double* t) {
  const Index n = std::ssize(panels.order);
  for (Index k = 0; k < n; ++k) x[k] = values[panels.order[k]];
  for (int s = 0; s < panels.count(); ++s) {
    const Panel panel(panels, s);
    times(panel, x + panel.first, t);
    std::copy_n(t, panel.columns, x + panel.first);
    for (Index i = panel.columns; i < panel.rows; ++i) x[panel.row[i]] += t[i];
  }
  for (int s = panels.count() - 1; s >= 0; --s) {
    const Panel panel(panels, s);
    std::copy_n(x + panel.first, panel.columns, t);
    for (Index i = panel.columns; i < panel.rows; ++i) t[i] = x[panel.row[i]];
    transposed_times(panel, t, x + panel.first);
  }
  for (Index k = 0; k < n; ++k) values[panels.order[k]] = x[k];
}

/// into[p] = Σ_q Q(p, q) from[q], p = 0 … tile - 1, of rows of eight; Q(p, q) stands at Q[p · along + q · across].
template <int tile>
inline void eight_products(const double* Q, Index along, Index across, Index terms, const double* from, double* into) {
  Four low[tile] = {}, high[tile] = {};
  for (Index q = 0; q < terms; ++q, Q += across, from += together) {
    const Four first = load(from), second = load(from + 4);
    for (int p = 0; p < tile; ++p) {
      low[p] += Q[p * along] * first;
      high[p] += Q[p * along] * second;
    }
  }
  for (int p = 0; p < tile; ++p) {
    store(into + p * together, low[p]);
    store(into + p * together + 4, high[p]);
  }
}

/// [y; δ] = Q b₁ and x₁ = Qᵀ v of eight right sides, without what stands above the diagonal.
void eight_times(const Panel& panel, const double* b, double* result) {
  Index i = 0;
  for (; i + 4 <= panel.rows; i += 4)
    eight_products<4>(panel.Q + i, 1, panel.rows, std::min(panel.columns, i + 4), b, result + i * together);
  for (; i < panel.rows; ++i)
    eight_products<1>(panel.Q + i, 1, panel.rows, std::min(panel.columns, i + 1), b, result + i * together);
}

void eight_transposed_times(const Panel& panel, const double* v, double* x) {
  const auto column = [&](Index j) { return panel.Q + j * panel.rows + j; };
  Index j = 0;
  for (; j + 4 <= panel.columns; j += 4)
    eight_products<4>(column(j), panel.rows, 1, panel.rows - j, v + j * together, x + j * together);
  for (; j < panel.columns; ++j)
    eight_products<1>(column(j), panel.rows, 1, panel.rows - j, v + j * together, x + j * together);
}

/// As `solve_one` for up to eight columns of B; those that are missing are 0.
void solve_eight(const FactorPanels& panels, Eigen::Ref<Eigen::MatrixXd> B, double* x, double* t) {
  const Index n = std::ssize(panels.order);
  for (Index k = 0; k < n; ++k) {
    for (Index c = 0; c < together; ++c) x[k * together + c] = c < B.cols() ? B(panels.order[k], c) : 0.0;
  }
  for (int s = 0; s < panels.count(); ++s) {
    const Panel panel(panels, s);
    double* own = x + panel.first * together;
    eight_times(panel, own, t);
    std::copy_n(t, panel.columns * together, own);
    for (Index i = panel.columns; i < panel.rows; ++i) {
      double* into = x + panel.row[i] * together;
      store(into, load(into) + load(t + i * together));
      store(into + 4, load(into + 4) + load(t + i * together + 4));
    }
  }
  for (int s = panels.count() - 1; s >= 0; --s) {
    const Panel panel(panels, s);
    double* own = x + panel.first * together;
    std::copy_n(own, panel.columns * together, t);
    for (Index i = panel.columns; i < panel.rows; ++i)
      std::copy_n(x + panel.row[i] * together, together, t + i * together);
    eight_transposed_times(panel, t, own);
  }
  for (Index k = 0; k < n; ++k) {
    for (Index c = 0; c < B.cols(); ++c) B(panels.order[k], c) = x[k * together + c];
  }
}

}  // namespace

void invert_diagonal_blocks(const FactorPanels& panels) {
  Eigen::MatrixXd inverse;
  for (int s = 0; s < panels.count(); ++s) {
    const Index columns = panels.first_column[s + 1] - panels.first_column[s];
    const Index rows = panels.first_row[s + 1] - panels.first_row[s];
    Eigen::Map<Eigen::MatrixXd> panel(panels.values + panels.first_value[s], rows, columns);
    auto diagonal = panel.topRows(columns);
    auto below = panel.bottomRows(rows - columns);
    diagonal.triangularView<Eigen::Lower>().solveInPlace<Eigen::OnTheRight>(below);
    below = -below;
    inverse.setIdentity(columns, columns);
    diagonal.triangularView<Eigen::Lower>().solveInPlace(inverse);
    diagonal = inverse;
  }
}

void solve_with_panels(const FactorPanels& panels, Eigen::Ref<Eigen::MatrixXd> B, PanelWork& work) {
  const std::size_t n = panels.order.size();
  const std::size_t columns = B.cols() <= few ? 1 : together;
  if (work.unknowns.size() < columns * n) {
    std::size_t most_rows = 0;
    for (int s = 0; s < panels.count(); ++s)
      most_rows = std::max<std::size_t>(most_rows, panels.first_row[s + 1] - panels.first_row[s]);
    work.unknowns.resize(columns * n);
    work.rows.resize(columns * most_rows);
  }
  if (B.cols() <= few) {
    for (Index c = 0; c < B.cols(); ++c) solve_one(panels, B.col(c).data(), work.unknowns.data(), work.rows.data());
    return;
  }
  for (Index first = 0; first < B.cols(); first += together)
    solve_eight(panels, B.middleCols(first, std::min(together, B.cols() - first)), work.unknowns.data(),
                work.rows.data());
}

}  // namespace sunder::numerics
