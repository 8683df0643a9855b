/// A crack that closes nowhere: its pressure has one minimum, where the flux turns, so its fronts are found without a
/// scan.

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;
using numerics::Residual;

/// Where V = c, for a V that never falls from 0 < c < V(L) on; with the midpoint rule the node where V passes c.
Location PressureSolver::crossing_of(double c) const {
  int low = 0, high = table_.count() - 1;
  const bool flat = table_.flat();
  while (low < high) {
    const int middle = (low + high) / 2;
    if ((flat ? table_.middle_change(middle) : table_.change(middle + 1)) >= c) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  if (flat) return {low, table_.middle_change(low) >= c ? -1.0 : 1.0};
  std::array<double, 2> y{};
  if (crossings(table_.segment(low), c, -1.0, 1.0, y) > 0) return {low, y[0]};
  return {low, std::abs(table_.change(low) - c) < std::abs(table_.change(low + 1) - c) ? -1.0 : 1.0};
}

/// For a crack that never closes: p at its one minimum, or p(L) - p_down where that is lower.
Residual PressureSolver::front_residual(double c, bool wants_slope) {
  const int n = table_.count();
  const bool flat = table_.flat();
  const double furthest = flat ? table_.middle_change(n - 1) : table_.change(n);
  if (c >= furthest || c <= (flat ? table_.middle_change(0) : 0.0)) return through_residual(c, wants_slope);
  ++profile_.residual_evaluations;
  const Location at = crossing_of(c);
  Loss loss = range_loss(c, 0, at.segment, wants_slope);
  if (flat) {
    if (at.y > 0.0) loss.add(range_loss(c, at.segment, at.segment + 1, wants_slope));
  } else {
    loss.add(loss_between(table_.segment(at.segment), table_.law(), c, -1.0, at.y));
    ++profile_.gradient_evaluations;
  }
  const Residual front{upstream_ - loss.value, -loss.slope, round_off(loss.magnitude + upstream_)};
  if (!open_ || downstream_ == 0.0) return front;
  const Residual through = through_residual(c, wants_slope);
  return through.value < front.value ? through : front;
}

/// For a crack that never closes and has a void: p(L) - p_down of the water that enters downstream and reaches up to V
/// = c.
Residual PressureSolver::far_residual(double c, bool wants_slope) {
  ++profile_.residual_evaluations;
  const int n = table_.count();
  const Location at = crossing_of(c);
  const bool whole = at.y == -1.0;
  Loss loss = range_loss(c, whole ? at.segment : at.segment + 1, n, wants_slope);
  if (!whole && at.y < 1.0) {
    loss.add(loss_between(table_.segment(at.segment), table_.law(), c, at.y, 1.0));
    ++profile_.gradient_evaluations;
  }
  return {-downstream_ - loss.value, -loss.slope, round_off(loss.magnitude + downstream_)};
}

void PressureSolver::solve_never_closing() {
  const int n = table_.count();
  const bool clip = planted_fault("crackwater/clipped-cavitation"), flat = table_.flat();
  Region region;
  region.end = {n - 1, 1.0};
  region.start_pressure = upstream_;
  if (!open_) {
    const double tip = table_.tip_change();
    const Loss loss = range_loss(tip, 0, n, false);
    ++profile_.residual_evaluations;
    if (upstream_ - loss.value >= -round_off(loss.magnitude + upstream_) || clip) {
      region.constant = region.constant_beyond = tip;
      region.closed = true;
      place(region);
      return;
    }
  }
  use_prefix_ = options_.search == Search::prefix_moments;
  auto [lower, upper] = flux_bracket();
  if (!open_) upper = table_.tip_change();
  const Region pattern = region;
  const bool dry_mouth = upstream_ == 0.0 && !clip;
  const double nearest = flat ? table_.middle_change(0) : 0.0;
  if (dry_mouth) {
    // No water above the mouth: none comes in. What enters downstream may reach it, with q < 0 all along.
    if (!open_ || downstream_ == 0.0) return;
    if (through_residual(nearest, false).value < 0.0) upper = nearest;
  }
  if (dry_mouth && upper != nearest) {
    region.constant = nearest;
  } else if (clip || dry_mouth) {
    auto residual = [this](double c, bool wants_slope) { return through_residual(c, wants_slope); };
    region = find(numerics::RootFunction(residual), lower, upper);
  } else {
    auto residual = [this](double c, bool wants_slope) { return front_residual(c, wants_slope); };
    region = find(numerics::RootFunction(residual), lower, upper);
  }
  region.start_pressure = pattern.start_pressure;
  region.end = pattern.end;
  if (region.share > 0.0 && region.constant <= nearest && region.constant_beyond > nearest && !clip) {
    // the front lies so close to the mouth that the flux has no digits for it (see solve_general)
    region.constant = region.constant_beyond;
    region.share = 0.0;
    profile_.at_regime_jump = false;
  }
  const double c = region.constant;
  const double furthest = flat ? table_.middle_change(n - 1) : table_.change(n);
  bool through = clip || c >= furthest || (dry_mouth ? upper == nearest : c <= nearest);
  if (!through && !dry_mouth && open_ && downstream_ > 0.0) {  // which of the two minima was it?
    const Residual end = through_residual(c, false);
    const Residual lower_one = front_residual(c, false);
    through = end.value <= lower_one.value;
  }
  region.to_mouth = through && open_;
  if (!through) region.end = crossing_of(c);
  use_prefix_ = false;
  if (through || !dry_mouth) place(region);
  if (through || !open_ || downstream_ == 0.0) return;

  use_prefix_ = options_.search == Search::prefix_moments;
  auto far = [this](double constant, bool wants_slope) { return far_residual(constant, wants_slope); };
  Region second = find(numerics::RootFunction(far), c, furthest);
  use_prefix_ = false;
  second.start = crossing_of(second.constant);
  second.end = {n - 1, 1.0};
  second.to_mouth = true;
  place(second);
}

}  // namespace sunder::crackwater
