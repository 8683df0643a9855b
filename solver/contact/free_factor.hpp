#pragma once
/// Cholesky factor of the rows and columns of a symmetric matrix that belong to a changing set of unknowns.
///
/// One unknown enters or leaves in O(m²) operations, m the size of the set: an entering one appends a row, a leaving
/// one turns the rows behind it back to a triangle [Golub 2013, §6.5.4]. Both are backward stable.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sunder::contact {

class FreeFactor {
 public:
  /// Room for sets of up to `most` unknowns; nothing is allocated afterwards.
  void reserve(int most);

  /// The set becomes empty.
  void clear() { count_ = 0; }

  /// Takes unknown `j` of M (n, n) into the set. False, and nothing is done, where row j depends on those in the set to
  /// round-off: its pivot is no more than 4 (m + 1) eps M_jj.
  bool append(const Eigen::MatrixXd& M, int j);

  /// Takes out the unknown at place `p` of `members`.
  void remove(int p);

  /// Makes the set `members` from nothing, in O(m³). False where one of them depends on those before it; the set then
  /// ends there.
  bool factorise(const Eigen::MatrixXd& M, std::span<const int> members);

  /// The unknowns in the set, in the order of the factor.
  std::span<const int> members() const { return {members_.data(), static_cast<std::size_t>(count_)}; }
  int count() const { return count_; }

  /// Overwrites b (m), in the order of `members`, with M_ff⁻¹ b.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const;

 private:
  bool independent(double pivot, double diagonal) const;

  Eigen::MatrixXd L_;  ///< lower triangle of its leading (m, m) block
  Eigen::VectorXd row_;
  std::vector<int> members_;
  int count_ = 0;
};

}  // namespace sunder::contact
