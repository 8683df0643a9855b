// How the forces of a solved contact follow a small change of what acts on the body.
#include <algorithm>

#include "solver/contact/contact_solver.hpp"

namespace sunder::contact {

/// Overwrites change_ with the change of the free forces that follows a change of the load, and of no other force.
void ContactSolver::answer_of_free() noexcept {
  const FreeFactor& factor = minimum_.factor();
  const std::span<const int> members = factor.members();
  for (std::size_t p = 0; p < members.size(); ++p) free_change_[p] = -change_[members[p]];
  factor.solve_in_place(free_change_.head(factor.count()));
  change_.setZero();
  for (std::size_t p = 0; p < members.size(); ++p) change_[members[p]] = free_change_[p];
}

bool ContactSolver::differentiate(Eigen::Ref<Eigen::MatrixXd> change) noexcept {
  bool converged = true;
  for (Eigen::Index column = 0; column < change.cols(); ++column) {
    bound_change_.setZero();
    double before = 0.0;
    for (int i = 0;; ++i) {
      change_ = change.col(column);
      if (i > 0) change_.noalias() += minimum_.matrix().rightCols(n_) * bound_change_;
      answer_of_free();
      if (!with_friction()) break;
      double difference = 0.0;
      for (int pair = 0; pair < n_; ++pair) {
        const double sign = sliding_sign(pair), slides = sign * options_.friction_coefficient * change_[pair];
        if (sign == 0.0) continue;
        difference = std::max(difference, std::abs(slides - bound_change_[pair]));
        bound_change_[pair] = slides;
        change_[n_ + pair] = slides;
      }
      if (i == 0) before = difference;
      if (!(difference > options_.friction_tolerance * before)) break;
      if (i == options_.friction_iterations) {
        converged = false;
        break;
      }
    }
    change.col(column) = change_;
  }
  return converged;
}

/// The sign of τ where the pair slides, 0 where it sticks or is open.
double ContactSolver::sliding_sign(int pair) const noexcept {
  if (minimum_.is_free(n_ + pair) || !(bound_[pair] > 0.0)) return 0.0;
  return minimum_.at_upper(n_ + pair) ? 1.0 : -1.0;
}

}  // namespace sunder::contact
