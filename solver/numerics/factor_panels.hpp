#pragma once
/// Solving with a supernodal Cholesky factor many times: its panels are turned once into partitioned inverses, after
/// which both substitutions are products of a dense panel and a vector.
///
/// A supernode of w columns with the factor's blocks L₁₁ (w, w) and L₂₁ (m, w) becomes, in place,
///
///     Q = [L₁₁⁻¹; -L₂₁ L₁₁⁻¹]   (w + m, w)
///
/// and with it   [y; δ] = Q b₁, b₂ += δ   forwards,   x₁ = Qᵀ [y; x₂]   backwards
/// [Alvarado, Pothen & Schreiber 1993, section 2]. There is no recurrence within a supernode for the processor to wait
/// for, and no memory beside the factor's. Only the diagonal blocks of single supernodes are inverted: the residual
/// grows by their condition, the root of that of a few neighbouring nodes, not by the whole matrix's.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sunder::numerics {

/// A supernodal factor of n rows. Supernode s has the columns first_column[s] … first_column[s + 1] - 1; its rows,
/// beginning with its own columns, are row[first_row[s]] … row[first_row[s + 1] - 1]; its panel, column by column,
/// begins at values[first_value[s]].
struct FactorPanels {
  std::span<const int> first_column, first_row;  ///< (supernodes + 1)
  std::span<const int> first_value;              ///< (supernodes)
  std::span<const int> row;
  std::span<const int> order;  ///< (n) row k of the factor is row order[k] of the matrix
  double* values = nullptr;

  int count() const { return static_cast<int>(first_column.size()) - 1; }
};

/// Turns every panel [L₁₁; L₂₁] into Q; what stands above the diagonals of L₁₁ becomes 0. The sign of Q's lower part is
/// such that it is added.
void invert_diagonal_blocks(const FactorPanels& panels);

/// Memory of the solutions, kept from one to the next.
struct PanelWork {
  std::vector<double> unknowns, rows;
};

/// B (n, columns) := A⁻¹ B by inverted panels. Eight right sides share one pass over the panels. Allocates nothing
/// where `work` has solved for as many columns before. The same bits in every run.
void solve_with_panels(const FactorPanels& panels, Eigen::Ref<Eigen::MatrixXd> B, PanelWork& work);

}  // namespace sunder::numerics
