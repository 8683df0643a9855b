#pragma once
/// The vector between bounds with the least energy: what all models of contact come down to.
///
///     minimise ½ xᵀ M x + qᵀ x   over   lower ≤ x ≤ upper,   M symmetric positive semidefinite
///
/// With lower = 0 and no upper bound this is the complementarity problem 0 ≤ x ⊥ q + M x ≥ 0.
///
/// Two methods on one Cholesky factor of the free unknowns (contact/free_factor.hpp):
///   1. Block pivoting [Júdice & Pires 1994]: all unknowns beyond a bound go to it, all at a bound that are pulled
///      inwards are freed, at once. From the last answer a few steps suffice, mostly one. It may cycle, so it goes on
///      only while the number of wrong unknowns has fallen within the last `patience` steps.
///   2. Else an active-set descent [Lawson & Hanson 1995, ch. 23; bounds on both sides, and singular M, added here]:
///   one
///      unknown is freed at a time, and steps end at the first bound they meet. Each minimum over a free set lies
///      strictly lower than the one before, so that none returns: the descent ends. Where the entering unknown depends
///      on the free ones, x moves along the direction without stiffness until it meets a bound; where it meets none,
///      the energy has no minimum.
///
/// What counts as round-off, with r_i = √M_ii and t = 8 (n + 8) eps: in the gradient t (|q_i| + r_i Σ r_j |x_j|), in x
/// t Σ r_j |x_j| / r_i. Both are free of units and of the scale of single unknowns.

#include <Eigen/Core>
#include <vector>

#include "solver/contact/free_factor.hpp"

namespace sunder::contact {

enum class MinimumStatus {
  found,
  none,       ///< the energy falls without end along a direction that meets no bound; x is best in all others
  not_found,  ///< the pivots ran out by round-off; x is the best so far
};

struct MinimumReport {
  MinimumStatus status = MinimumStatus::found;
  int pivots = 0;  ///< steps of both methods
  bool descended = false;
};

class BoundedMinimum {
 public:
  /// Room for n unknowns, all at their lower bound; the only call that allocates.
  void resize(int n);

  /// M = F (n, n) + diag(D) (n). Keeps which unknowns are free, forgets their factor. Entries of F must be finite and
  /// symmetric, those of D ≥ 0.
  void set_matrix(const Eigen::MatrixXd& F, const Eigen::VectorXd& D);
  /// Only D has changed since F was given.
  void set_diagonal(const Eigen::MatrixXd& F, const Eigen::VectorXd& D);

  /// Where the next solve begins: nothing free.
  void forget();

  /// Precondition: finite q, lower ≤ upper, lower finite; upper may be infinite. Where both are equal x stays there.
  MinimumReport solve(const Eigen::VectorXd& q, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) noexcept;

  const Eigen::VectorXd& x() const { return x_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }  ///< q + M x
  bool is_free(int i) const { return place_[i] == Place::free; }
  bool at_upper(int i) const { return place_[i] == Place::upper; }
  const FreeFactor& factor() const { return factor_; }
  const Eigen::MatrixXd& matrix() const { return M_; }

 private:
  enum class Place : char { lower, upper, free };

  bool prepare_factor();
  void minimise_over_free();
  void step_to_free_minimum();
  void update_gradient();
  double gradient_round_off(int i) const;
  bool pulled_inwards(int i) const;
  int turn_wrong_ones();
  bool pivot_in_blocks(MinimumReport& report);

  struct Block {
    double fraction;  ///< of the step up to the bound
    int unknown;      ///< that meets it; -1: none
  };
  MinimumStatus descend(int& pivots);
  bool settle(int entered, int& pivots_left);
  MinimumStatus enter(int entering, int& pivots_left);
  Block first_bound(double longest, int entering, double entering_step) const;
  void take_out(const Block& block);
  int most_wrong() const;
  void go_to_bounds();

  int n_ = 0;
  Eigen::MatrixXd M_;
  Eigen::VectorXd root_, q_, lower_, upper_, x_, gradient_;
  Eigen::VectorXd step_;  ///< of the free unknowns, in the order of the factor
  double weight_ = 0.0;   ///< Σ r_j |x_j|
  double unit_ = 0.0;     ///< t
  FreeFactor factor_;
  std::vector<Place> place_;
  enum class Refusal : char { no, until_next_move, for_good };
  std::vector<Refusal> refused_;  ///< descent: freeing it leads nowhere
  std::vector<int> members_;
  std::vector<char> in_factor_;
  bool factor_is_current_ = false;
};

}  // namespace sunder::contact
