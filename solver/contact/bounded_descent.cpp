// The descent that ends wherever block pivoting may not; see bounded_minimum.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/contact/bounded_minimum.hpp"

namespace sunder::contact {

void BoundedMinimum::go_to_bounds() {
  forget();
  x_ = lower_;
}

/// The bound that the free unknowns, moving by up to `longest` · step_, meet first; with them `entering` moves.
BoundedMinimum::Block BoundedMinimum::first_bound(double longest, int entering, double entering_step) const {
  Block block{longest, -1};
  const auto meet = [&](int i, double step) {
    if (step == 0.0) return;
    const double room = std::max(((step < 0.0 ? lower_[i] : upper_[i]) - x_[i]) / step, 0.0);
    if (room < block.fraction) block = {room, i};
  };
  const std::span<const int> members = factor_.members();
  for (std::size_t p = 0; p < members.size(); ++p) meet(members[p], step_[p]);
  if (entering >= 0) meet(entering, entering_step);
  return block;
}

/// Takes a free unknown that has met a bound out of the factor and sets it there.
void BoundedMinimum::take_out(const Block& block) {
  const std::span<const int> members = factor_.members();
  const int p = static_cast<int>(std::find(members.begin(), members.end(), block.unknown) - members.begin());
  place_[block.unknown] = step_[p] < 0.0 ? Place::lower : Place::upper;
  x_[block.unknown] = step_[p] < 0.0 ? lower_[block.unknown] : upper_[block.unknown];
  factor_.remove(p);
}

/// Moves to the minimum over the free unknowns, of which those that meet a bound cease to be free. False where the
/// pivots ran out.
bool BoundedMinimum::settle(int entered, int& pivots_left) {
  for (bool refined = false;;) {
    if (pivots_left-- <= 0) return false;
    update_gradient();
    step_to_free_minimum();
    const Block block = first_bound(1.0, -1, 0.0);
    const std::span<const int> members = factor_.members();
    for (std::size_t p = 0; p < members.size(); ++p) x_[members[p]] += block.fraction * step_[p];
    if (block.fraction > 0.0) {
      std::replace(refused_.begin(), refused_.end(), Refusal::until_next_move, Refusal::no);
    }
    if (block.unknown >= 0) {
      // By round-off of a nearly dependent row the entered unknown may want to turn back at once.
      if (block.fraction == 0.0 && block.unknown == entered) refused_[entered] = Refusal::until_next_move;
      take_out(block);
    } else if (refined) {
      update_gradient();
      return true;
    } else {
      refined = true;
    }
  }
}

/// Frees one unknown; where it depends on the free ones, moves along the direction without stiffness until it does not.
MinimumStatus BoundedMinimum::enter(int entering, int& pivots_left) {
  const double direction = gradient_[entering] < 0.0 ? 1.0 : -1.0;
  while (!factor_.append(M_, entering)) {
    if (pivots_left-- <= 0) return MinimumStatus::not_found;
    const std::span<const int> members = factor_.members();
    for (std::size_t p = 0; p < members.size(); ++p) step_[p] = -direction * M_(members[p], entering);
    factor_.solve_in_place(step_.head(factor_.count()));
    const Block block = first_bound(std::numeric_limits<double>::infinity(), entering, direction);
    if (block.unknown < 0 || !std::isfinite(block.fraction)) {
      refused_[entering] = Refusal::for_good;
      return MinimumStatus::none;
    }
    for (std::size_t p = 0; p < members.size(); ++p) x_[members[p]] += block.fraction * step_[p];
    x_[entering] += block.fraction * direction;
    if (block.unknown == entering) {
      place_[entering] = direction > 0.0 ? Place::upper : Place::lower;
      x_[entering] = direction > 0.0 ? upper_[entering] : lower_[entering];
      return MinimumStatus::found;
    }
    take_out(block);
  }
  place_[entering] = Place::free;
  return MinimumStatus::found;
}

/// The unknown at a bound with the largest pull inwards, measured in its round-off; -1 where none is pulled.
int BoundedMinimum::most_wrong() const {
  int worst = -1;
  double strongest = 0.0;
  for (int i = 0; i < n_; ++i) {
    if (refused_[i] != Refusal::no || !pulled_inwards(i)) continue;
    const double pull = std::abs(gradient_[i]) / gradient_round_off(i);
    if (pull > strongest) {
      strongest = pull;
      worst = i;
    }
  }
  return worst;
}

MinimumStatus BoundedMinimum::descend(int& pivots) {
  const int most = 40 * (n_ + 4);  // an unknown enters a few times at most; round-off alone can use them up
  int left = most, entered = -1;
  MinimumStatus status = MinimumStatus::found;
  std::fill(refused_.begin(), refused_.end(), Refusal::no);
  go_to_bounds();
  for (;;) {
    if (!settle(entered, left)) {
      status = MinimumStatus::not_found;
      break;
    }
    entered = most_wrong();
    if (entered < 0) break;
    const MinimumStatus entering = enter(entered, left);
    if (entering != MinimumStatus::found) status = entering;
    if (entering == MinimumStatus::not_found) break;
  }
  update_gradient();
  pivots += most - left;
  return status;
}

}  // namespace sunder::contact
