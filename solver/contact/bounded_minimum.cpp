#include "solver/contact/bounded_minimum.hpp"

#include <algorithm>
#include <limits>

namespace sunder::contact {
namespace {

/// Steps of block pivoting without fewer wrong unknowns than ever before, after which it is taken to cycle.
constexpr int patience = 4;

}  // namespace

void BoundedMinimum::resize(int n) {
  n_ = n;
  unit_ = 8.0 * (n + 8) * std::numeric_limits<double>::epsilon();
  M_.setZero(n, n);
  for (Eigen::VectorXd* v : {&root_, &q_, &lower_, &upper_, &x_, &gradient_, &step_}) v->setZero(n);
  factor_.reserve(n);
  place_.assign(static_cast<std::size_t>(n), Place::lower);
  refused_.assign(static_cast<std::size_t>(n), Refusal::no);
  in_factor_.assign(static_cast<std::size_t>(n), 0);
  members_.reserve(static_cast<std::size_t>(n));
  factor_is_current_ = false;
}

void BoundedMinimum::set_matrix(const Eigen::MatrixXd& F, const Eigen::VectorXd& D) {
  M_ = F;
  set_diagonal(F, D);
}

void BoundedMinimum::set_diagonal(const Eigen::MatrixXd& F, const Eigen::VectorXd& D) {
  M_.diagonal() = F.diagonal() + D;
  root_ = M_.diagonal().cwiseSqrt();
  factor_is_current_ = false;
}

void BoundedMinimum::forget() {
  std::fill(place_.begin(), place_.end(), Place::lower);
  factor_.clear();
  factor_is_current_ = true;
}

double BoundedMinimum::gradient_round_off(int i) const {
  return unit_ * (std::abs(q_[i]) + root_[i] * weight_);
}

void BoundedMinimum::update_gradient() {
  gradient_ = q_;
  gradient_.noalias() += M_ * x_;
  weight_ = root_.dot(x_.cwiseAbs());
}

bool BoundedMinimum::pulled_inwards(int i) const {
  if (place_[i] == Place::free || !(lower_[i] < upper_[i])) return false;
  const double inwards = place_[i] == Place::lower ? -gradient_[i] : gradient_[i];
  return inwards > gradient_round_off(i);
}

/// A few unknowns are exchanged one by one, many are factorised anew: about where the two cost the same.
bool BoundedMinimum::prepare_factor() {
  members_.clear();
  for (int i = 0; i < n_; ++i) {
    if (place_[i] == Place::free) members_.push_back(i);
  }
  std::fill(in_factor_.begin(), in_factor_.end(), char{0});
  int staying = 0;
  for (const int i : factor_.members()) {
    in_factor_[i] = 1;
    if (place_[i] == Place::free) ++staying;
  }
  const int changes = factor_.count() - staying + static_cast<int>(members_.size()) - staying;
  if (!factor_is_current_ || 8 * changes > factor_.count() + 8) {
    return factor_is_current_ = factor_.factorise(M_, members_);
  }
  for (int p = factor_.count() - 1; p >= 0; --p) {
    if (place_[factor_.members()[p]] != Place::free) factor_.remove(p);
  }
  for (const int i : members_) {
    if (in_factor_[i] == 0 && !factor_.append(M_, i)) return factor_is_current_ = false;
  }
  return true;
}

/// step_ = -M_ff⁻¹ gradient_f.
void BoundedMinimum::step_to_free_minimum() {
  const std::span<const int> members = factor_.members();
  for (std::size_t p = 0; p < members.size(); ++p) step_[p] = -gradient_[members[p]];
  factor_.solve_in_place(step_.head(factor_.count()));
}

void BoundedMinimum::minimise_over_free() {
  for (int i = 0; i < n_; ++i) {
    x_[i] = place_[i] == Place::free ? 0.0 : place_[i] == Place::lower ? lower_[i] : upper_[i];
  }
  update_gradient();
  const std::span<const int> members = factor_.members();
  for (int pass = 0; pass < 2; ++pass) {  // the second, an iterative refinement, where round-off is exceeded
    step_to_free_minimum();
    for (std::size_t p = 0; p < members.size(); ++p) x_[members[p]] += step_[p];
    update_gradient();
    const bool exact = std::all_of(members.begin(), members.end(),
                                   [&](int i) { return std::abs(gradient_[i]) <= gradient_round_off(i); });
    if (exact) return;
  }
}

/// Turns every unknown that stands wrong; how many did.
int BoundedMinimum::turn_wrong_ones() {
  int wrong = 0;
  for (int i = 0; i < n_; ++i) {
    if (place_[i] == Place::free) {
      const double round_off = unit_ * weight_ / root_[i];
      if (x_[i] < lower_[i] - round_off) {
        place_[i] = Place::lower;
      } else if (x_[i] > upper_[i] + round_off) {
        place_[i] = Place::upper;
      } else {
        continue;
      }
    } else if (pulled_inwards(i)) {
      place_[i] = Place::free;
    } else {
      continue;
    }
    ++wrong;
  }
  return wrong;
}

bool BoundedMinimum::pivot_in_blocks(MinimumReport& report) {
  int fewest = n_ + 1, left = patience;
  while (left > 0) {
    if (!prepare_factor()) return false;
    minimise_over_free();
    ++report.pivots;
    const int wrong = turn_wrong_ones();
    if (wrong == 0) return true;
    if (wrong < fewest) {
      fewest = wrong;
      left = patience;
    } else {
      --left;
    }
  }
  return false;
}

MinimumReport BoundedMinimum::solve(const Eigen::VectorXd& q, const Eigen::VectorXd& lower,
                                    const Eigen::VectorXd& upper) noexcept {
  q_ = q;
  lower_ = lower;
  upper_ = upper;
  MinimumReport report;
  for (int i = 0; i < n_; ++i) {  // a bound may have moved since the last solve
    if (!(lower_[i] < upper_[i]) || (place_[i] == Place::upper && !std::isfinite(upper_[i]))) place_[i] = Place::lower;
  }
  if (!pivot_in_blocks(report)) {
    report.descended = true;
    report.status = descend(report.pivots);
  }
  x_ = x_.cwiseMax(lower_).cwiseMin(upper_);        // free unknowns beyond a bound by round-off
  if (!x_.allFinite() || !gradient_.allFinite()) {  // overflow
    go_to_bounds();
    update_gradient();
    report.status = MinimumStatus::not_found;
  }
  return report;
}

}  // namespace sunder::contact
