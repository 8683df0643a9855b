#pragma once
/// Which pairs of crack faces touch, where the answer of the structure is not symmetric because water takes part in it.
///
/// Finds λ with  0 ≤ λ  ⊥  q + M λ ≥ 0.  Pairs that break a sign change sides all together while their number falls;
/// after `patience` exchanges without a new low only the last of them does [Júdice & Pires 1994], which ends where M is
/// a P-matrix [Murty 1974]: symmetric positive definite ones are, and so is the structure's answer as long as water
/// resists closing.

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace sunder::faces {

enum class ComplementarityStatus {
  solved,
  singular,       ///< pairs that touch cannot be told apart: the block of M belonging to them has no inverse
  not_converged,  ///< `max_exchanges` reached: M is no P-matrix
};

/// Solves one problem after the other of at most `largest` pairs; the pairs that touched are the next problem's first
/// guess. Allocates nothing in `solve`.
class ComplementarityProblem {
 public:
  explicit ComplementarityProblem(Eigen::Index largest);

  /// Is told which columns of M are read next, and may write them then: few pairs touch, and a column can be dear.
  using Columns = std::function<void(std::span<const Eigen::Index>)>;

  /// `M` (n, n), `q` (n); finite, M in the columns that are read. Overwrites `lambda` (n); it is 0 where no column was
  /// asked for.
  [[nodiscard]] ComplementarityStatus solve(const Eigen::Ref<const Eigen::MatrixXd>& M,
                                            const Eigen::Ref<const Eigen::VectorXd>& q,
                                            Eigen::Ref<Eigen::VectorXd> lambda, const Columns& will_read = {});

  int exchanges() const { return exchanges_; }  ///< of the last solve
  void forget() { touching_.assign(touching_.size(), 0); }
  /// Of the last problem, the next one's first guess (largest): 1 where a pair touches.
  const std::vector<char>& touching() const { return touching_; }
  void begin_with(const std::vector<char>& touching) { touching_ = touching; }
  bool touches(Eigen::Index pair) const { return touching_[static_cast<std::size_t>(pair)] != 0; }

 private:
  std::vector<char> touching_;
  std::vector<Eigen::Index> active_;
  Eigen::MatrixXd block_;
  Eigen::VectorXd right_, slack_;
  int exchanges_ = 0;
};

}  // namespace sunder::faces
