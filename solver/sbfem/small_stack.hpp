#pragma once
/// A stack of rings (ring_doubling.hpp) of up to some hundred unknowns, kept so that its merges fill the vector units.
///
/// Everything is row-major with rows padded to whole vectors of four. Elimination works on [S | Y | X] at once,
/// upwards: the factor S = Uᵀ U and the solutions U⁻ᵀ C, U⁻ᵀ Cᵀ appear in place, by the same inner product of columns
/// as Wᵀ W. At this size that is two to three times as fast as general matrix routines, which pack and dispatch first.

#include <Eigen/Core>
#include <vector>

#include "solver/numerics/lanes.hpp"

namespace sunder::sbfem {

class SmallStack {
 public:
  /// One ring of thickness h.
  SmallStack(const Eigen::MatrixXd& E0, const Eigen::MatrixXd& F, const Eigen::MatrixXd& E2, double h);

  double coupling() const;                    ///< ‖C‖
  double size() const;                        ///< ‖diag B‖
  [[nodiscard]] bool merge(bool outer_only);  ///< glues the stack to itself; false where S is not positive definite
  Eigen::MatrixXd stiffness() const;          ///< B (m, m), symmetric

 private:
  using Rows = std::vector<numerics::Lanes>;
  void eliminate_block(int block, int last_column);
  bool factor_diagonal(int block);
  void store_products(bool outer_only);

  int order_, width_;  // m; vectors in a row of m
  Rows A_, B_, C_;     // (4 width_, width_); of A and B the upper triangle is kept up
  Rows work_;          // (4 width_, 3 width_): [S | Y | X]
};

}  // namespace sunder::sbfem
