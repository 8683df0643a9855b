/// Wet regions of a crack that opens here and closes there: found one after the other from the upstream mouth.

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;
using numerics::Residual;

namespace {
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

/// m of a void at y: V plus the flux that runs down an inclined crack at p = 0.
double PressureSolver::free_constant(int i, double y) const {
  const double rise = table_.weight(i + 1) - table_.weight(i);
  if (table_.flat()) {
    const double v = table_.middle_change(i);
    // in a march the void may hold little water: it stands where it is not pressed
    return rise == 0.0 || table_.marching() ? v
                                            : v + flux_of_resistance(table_.law(), -rise / table_.loss_coefficient(i));
  }
  const Segment segment = table_.segment(i);
  const double v = segment.middle + y * (segment.linear + y * segment.quadratic);
  if (rise == 0.0) return v;
  const double w = aperture(segment, y);
  return v + flux_of_resistance(table_.law(), -rise / segment.length * w * w * w);
}

/// The lowest local minimum of p behind `start` for the constant c; the end counts as one, less the pressure there.
PressureSolver::Minimum PressureSolver::lowest(Location start, double start_pressure, double c) {
  ++profile_.residual_evaluations;
  const int n = table_.count();
  profile_.gradient_evaluations += n - start.segment;
  Minimum minimum;
  minimum.residual.value = std::numeric_limits<double>::infinity();
  double p = start_pressure, slope = 0.0, magnitude = upstream_ + downstream_ + table_.climb();
  bool falling = false, risen = false;
  const auto candidate = [&](Location at, double value, bool at_end) {
    // A region behind a void starts where q = 0; by its round-off p may seem to fall there before it rises: no minimum.
    if (!at_end && !risen && start_pressure == 0.0 && std::abs(value) <= round_off(magnitude)) return;
    if (value > minimum.residual.value) return;  // of equal ones the last
    minimum.residual = {value, -slope, round_off(magnitude)};
    minimum.at = at;
    minimum.at_end = at_end;
  };
  const auto step = [&](Location from, double loss, double loss_slope) {
    if (falling && !(loss > 0.0)) candidate(from, p, false);
    falling = loss > 0.0;
    risen = risen || loss < 0.0;
    p -= loss;
    slope += loss_slope;
    magnitude += std::abs(loss);
  };
  for (int i = start.segment; i < n; ++i) {
    const double from = i == start.segment ? start.y : -1.0;
    const double rise = table_.weight(i + 1) - table_.weight(i);
    if (from == -1.0 && !table_.may_turn(i, c) && (rise == 0.0 || table_.flat())) {
      const double d = c - table_.middle_change(i);
      const FlowLaw& law = table_.law();
      const double single = table_.single_loss(i, c), a0 = table_.loss_coefficient(i);
      // the exact slope of a tapered segment differs from this by its A_1; Newton only steers by it
      step({i, -1.0}, single + rise, resistance_slope(law, d) * a0);
      continue;
    }
    if (!(from < 1.0)) continue;
    const Pieces pieces = cut(table_.segment(i), table_.law(), c, from, 1.0, stationary_point(i, c));
    for (int k = 0; k < pieces.count; ++k) {
      const Piece& piece = pieces.piece[static_cast<std::size_t>(k)];
      step({i, piece.start}, piece.loss + 0.5 * rise * (piece.end - piece.start),
           piece.slope + (k == 0 ? pieces.cut_slope : 0.0));
    }
  }
  candidate({n - 1, 1.0}, p - downstream_, true);
  return minimum;
}

/// Where the free constant of a void stops growing behind `from`: water closes in there. The crack's end if nowhere.
Location PressureSolver::first_descent(Location from) const {
  const int n = table_.count();
  if (table_.flat() || table_.inclined()) {
    double before = free_constant(from.segment, from.y);
    for (int i = from.segment; i < n; ++i) {
      const double start = i == from.segment ? from.y : -1.0;
      if (free_constant(i, start) < before) return {i, start};
      before = free_constant(i, 1.0);
      if (before < free_constant(i, start)) return {i, start};
    }
    return {n - 1, 1.0};
  }
  for (int i = from.segment; i < n; ++i) {
    const double start = i == from.segment ? from.y : -1.0;
    if (!(start < 1.0)) continue;
    const Segment s = table_.segment(i);
    if (s.linear + 2.0 * s.quadratic * start < 0.0) return {i, start};
    if (s.linear + 2.0 * s.quadratic < 0.0) return {i, std::clamp(-0.5 * s.linear / s.quadratic, start, 1.0)};
  }
  return {n - 1, 1.0};
}

/// The first point from `from` on where the free constant reaches c; `to` where it does not before.
Location PressureSolver::rise_to(Location from, Location to, double c) const {
  for (int i = from.segment; i <= to.segment; ++i) {
    const double start = i == from.segment ? from.y : -1.0;
    const double stop = i == to.segment ? to.y : 1.0;
    if (!(start < stop)) continue;
    if (free_constant(i, start) >= c) return {i, start};
    if (table_.flat()) continue;
    std::array<double, 2> y{};
    if (!table_.inclined()) {
      if (crossings(table_.segment(i), c, start, stop, y) > 0) return {i, y[0]};
      continue;
    }
    if (free_constant(i, stop) < c) continue;
    double low = start, high = stop;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (free_constant(i, middle) >= c ? high : low) = middle;
    }
    return {i, high};
  }
  return to;
}

void PressureSolver::solve_general() {
  const int n = table_.count();
  const Location mouth{0, -1.0}, end{n - 1, 1.0};
  const auto normal = [&](Location at) {
    return at.y == 1.0 && at.segment + 1 < n ? Location{at.segment + 1, -1.0} : at;
  };
  Location from = mouth;
  const double cap = open_ ? std::numeric_limits<double>::infinity() : table_.tip_change();
  double previous = 0.0;
  for (bool at_mouth = true;; at_mouth = false) {
    Location bound = mouth;
    bool at_end = false;
    double lower = 0.0, upper = 0.0;
    if (at_mouth) {
      std::tie(lower, upper) = flux_bracket();
      if (upstream_ == 0.0) {  // no water above the mouth: none comes in, and p rises from there or the crack is void
        upper = free_constant(0, -1.0);
        const Minimum dry = lowest(mouth, 0.0, upper);
        if (dry.residual.value >= -dry.residual.floor) {
          previous = upper;
          continue;
        }
      }
    } else {
      bound = first_descent(from);
      at_end = bound.segment == n - 1 && bound.y == 1.0;
      // at a closed tip the void may end in a half segment that closes
      const bool closing_tip = !open_ && table_.flat() && table_.tip_change() < free_constant(n - 1, 1.0);
      if (at_end && !closing_tip && (!open_ || downstream_ == 0.0)) return;
      lower = previous;  // m never falls; at a node of a march it may step up to less than its free value
      // just before the descent, which may be a step between two segments
      const Location before =
          bound.y == -1.0 && bound.segment > from.segment ? Location{bound.segment - 1, 1.0} : bound;
      upper = std::max(lower, free_constant(before.segment, before.y));
    }
    const auto start_of = [&](double c) { return at_mouth ? mouth : rise_to(from, bound, c); };
    const double start_pressure = at_mouth ? upstream_ : 0.0;
    const auto minimum_of = [&](double c) { return lowest(start_of(c), start_pressure, c); };
    if (!at_mouth && !at_end) {
      const auto positive = [](const Minimum& minimum) { return minimum.residual.value >= -minimum.residual.floor; };
      // An island too small to press; or, on a slope, water that what comes down cannot press, whatever the flux: the
      // slope's head would have to stand there, which a front between nodes cannot say. No pressure, on behind it.
      const bool unpressed = table_.inclined() && !planted_fault("crackwater/foot-of-a-slope-pressed");
      if (positive(lowest(bound, 0.0, upper)) || (unpressed && !positive(minimum_of(lower)))) {
        if (bound.segment + 1 >= n) return;
        from = rise_to({bound.segment + 1, -1.0}, end, upper);
        previous = upper;
        if (from.y == 1.0 && from.segment == n - 1) return;
        continue;
      }
    }
    auto residual = [&](double c, bool) { return minimum_of(c).residual; };
    Region region;
    bool tip = false;
    if (cap <= upper && cap >= lower) {
      const Minimum full = minimum_of(cap);
      tip = full.residual.value >= -full.residual.floor;
      upper = cap;
      if (tip) region.constant = region.constant_beyond = cap;
    }
    if (!tip) region = find(numerics::RootFunction(residual), lower, upper);
    Minimum minimum = minimum_of(region.constant);
    if (region.share > 0.0) {
      const Minimum beyond = minimum_of(region.constant_beyond);
      if (minimum.at_end != beyond.at_end || std::abs(minimum.at.segment - beyond.at.segment) > 1) {
        // No regime jump: the region ends so close behind its start that the flux has no digits for it. It ends at the
        // minimum that has just formed, where p is nil by any measure of the pressures elsewhere.
        minimum = beyond;
        region.constant = region.constant_beyond;
        region.share = 0.0;
        profile_.at_regime_jump = false;
      }
    }
    region.start = start_of(region.constant);
    region.start_pressure = start_pressure;
    region.end = tip || minimum.at_end ? end : minimum.at;
    region.closed = tip;
    region.to_mouth = !tip && minimum.at_end && open_;
    place(region);
    const Location next = normal(region.end);
    if (tip || minimum.at_end) return;
    if (!at_mouth && !(table_.position(next) > table_.position(from))) {
      profile_.status = ProfileStatus::not_converged;
      return;
    }
    from = next;
    previous = region.constant_beyond;
  }
}

}  // namespace sunder::crackwater
