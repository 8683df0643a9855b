/// The pressure along the crack once the wet regions and their fluxes are known.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/segment_pieces.hpp"

namespace sunder::crackwater {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

void PressureSolver::place(Region region) {
  if (region.share > 0.0) mix(region);
  (void)lay(region, region.constant, 1.0 - region.share);
  if (region.share > 0.0) {
    const double peak = peak_before_, position = peak_position_before_;
    (void)lay(region, region.constant_beyond, region.share);
    profile_.peak_pressure = peak;
    profile_.peak_position = position;
    note_mixed_extremes(region);
  }
  regions_.push_back(region);
}

/// Sets the share so that the pressures as they are laid, not as the search summed them, meet what is asked for at the
/// end.
void PressureSolver::mix(Region& region) {
  peak_before_ = profile_.peak_pressure;
  peak_position_before_ = profile_.peak_position;
  const double lowest = lowest_pressure_, target = region.to_mouth ? downstream_ : 0.0;
  const double below = lay(region, region.constant, 0.0) - target,
               above = lay(region, region.constant_beyond, 0.0) - target;
  if (below > 0.0 && above < 0.0) region.share = below / (below - above);
  const double left = (1.0 - region.share) * below + region.share * above;
  if (profile_.at_regime_jump) profile_.turbulent_share = region.share;
  profile_.residual = std::abs(left);
  lowest_pressure_ = lowest;
}

/// The peak of a mixed profile: at its nodes, and where the flux turns inside a segment that both profiles lose alike.
void PressureSolver::note_mixed_extremes(const Region& region) {
  PressureProfile& out = profile_;
  for (int i = region.start.segment; i <= region.end.segment; ++i) {
    const double p = out.pressure[static_cast<std::size_t>(i)];
    if (i > region.start.segment || region.start.y == -1.0) {
      if (p > out.peak_pressure) {
        out.peak_pressure = p;
        out.peak_position = table_.position(i);
      }
      if (table_.flat() || !table_.may_turn(i, region.constant)) continue;
      const Segment segment = table_.segment(i);
      const double end = i == region.end.segment ? region.end.y : 1.0;
      const Loss loss = loss_between(segment, table_.law(), region.constant, -1.0, end);
      const Loss beyond = loss_between(segment, table_.law(), region.constant_beyond, -1.0, end);
      if (std::abs(loss.value - beyond.value) <= 1e-9 * magnitude_) note_extremes(i, -1.0, end, region.constant, p);
    }
  }
}

/// y where friction and weight balance inside an inclined segment, so that p has an extremum there; NaN where it has
/// none.
double PressureSolver::stationary_point(int i, double c) const {
  const double rise = (table_.weight(i + 1) - table_.weight(i)) / table_.length(i);
  if (rise == 0.0 || table_.flat()) return nan;
  const Segment segment = table_.segment(i);
  const auto balance = [&](double y) {
    const double w = aperture(segment, y);
    return resistance(table_.law(), flux(segment, c, y)) + rise * w * w * w;
  };
  double low = -1.0, high = 1.0;
  const bool falls = balance(low) > 0.0;
  if (falls == (balance(high) > 0.0)) return nan;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    ((balance(middle) > 0.0) == falls ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Losses over a stretch of one segment that is cut where the flux turns or changes regime.
struct PressureSolver::Stretch {
  double loss = 0.0, magnitude = 0.0;  ///< [Pa], weight included
  double force = 0.0, moment = 0.0;    ///< of the pressure lost, about the segment's first node [N/m], [N]
};

PressureSolver::Stretch PressureSolver::cut_stretch(int i, double from, double to, double c) const {
  Stretch stretch;
  const Pieces pieces = cut(table_.segment(i), table_.law(), c, from, to, nan);
  const double half = 0.5 * table_.length(i), rise = table_.weight(i + 1) - table_.weight(i);
  for (int j = 0; j < pieces.count; ++j) {
    const Piece& piece = pieces.piece[static_cast<std::size_t>(j)];
    const double length = half * (piece.end - piece.start), offset = half * (1.0 + piece.start);
    const double weight = 0.5 * rise * (piece.end - piece.start);
    const double first = 0.5 * stretch.loss * length + piece.to_first + weight * length / 6.0;
    const double last = 0.5 * stretch.loss * length + piece.to_last + weight * length / 3.0;
    stretch.force += first + last;
    stretch.moment += offset * (first + last) + length * last;
    stretch.loss += piece.loss + weight;
    stretch.magnitude += std::abs(piece.loss) + std::abs(weight);
  }
  return stretch;
}

/// Pressures inside a segment that lie above the peak or below the lowest met so far.
void PressureSolver::note_extremes(int i, double from, double to, double c, double pressure) {
  const Pieces pieces = cut(table_.segment(i), table_.law(), c, from, to, stationary_point(i, c));
  const double half = 0.5 * table_.length(i), rise = table_.weight(i + 1) - table_.weight(i);
  for (int j = 0; j < pieces.count; ++j) {
    const Piece& piece = pieces.piece[static_cast<std::size_t>(j)];
    pressure -= piece.loss + 0.5 * rise * (piece.end - piece.start);
    lowest_pressure_ = std::min(lowest_pressure_, pressure);
    if (pressure > profile_.peak_pressure) {
      profile_.peak_pressure = pressure;
      profile_.peak_position = table_.position(i) + half * (1.0 + piece.end);
    }
  }
}

/// Part of a segment next to a front.
void PressureSolver::lay_part(int i, double from, double to, double c, double share, double& pressure) {
  const std::size_t k = static_cast<std::size_t>(i);
  note_extremes(i, from, to, c, pressure);
  const Stretch stretch = cut_stretch(i, from, to, c);
  const double half = 0.5 * table_.length(i), length = half * (to - from);
  const double force = pressure * length - stretch.force;
  const double moment = pressure * length * half * (1.0 + 0.5 * (from + to)) - stretch.moment;
  const double at_last = moment / table_.length(i);
  profile_.nodal_force[k] += share * (force - at_last);
  profile_.nodal_force[k + 1] += share * at_last;
  pressure -= stretch.loss;
  magnitude_ += stretch.magnitude;
}

/// Adds `share` of the profile of one constant; returns the pressure at the region's end.
double PressureSolver::lay(const Region& region, double c, double share) {
  PressureProfile& out = profile_;
  double p = region.start_pressure;
  magnitude_ = std::max(magnitude_, upstream_ + downstream_ + table_.climb());
  int first = region.start.segment;
  const bool inside = region.start.segment == region.end.segment;
  if (region.start.y > -1.0 || (inside && region.end.y < 1.0)) {
    if (region.start.y == -1.0) out.pressure[static_cast<std::size_t>(first)] += share * p;
    if (p > out.peak_pressure) {
      out.peak_pressure = p;
      out.peak_position = table_.position(region.start);
    }
    lay_part(first, region.start.y, inside ? region.end.y : 1.0, c, share, p);
    ++first;
    if (inside && region.end.y < 1.0) return p;
  }
  const int last = region.end.y == 1.0 ? region.end.segment + 1 : region.end.segment;
  lay_whole(first, last, c, share, p);
  if (region.end.y > -1.0 && region.end.y < 1.0) lay_part(last, -1.0, region.end.y, c, share, p);
  return p;
}

/// The segments [first, last) and their nodes, given the pressure at node `first`; block by block, to stay in the
/// cache.
void PressureSolver::lay_whole(int first, int last, double c, double share, double& pressure) {
  CompensatedSum total;
  total.add(pressure);
  for (int from = first; from < last; from += block_size) {
    lay_block(from, std::min(from + block_size, last), c, share, total);
  }
  pressure = total.value();
  profile_.pressure[static_cast<std::size_t>(last)] += share * pressure;
}

void PressureSolver::lay_block(int first, int last, double c, double share, CompensatedSum& pressure) {
  PressureProfile& out = profile_;
  table_.losses(c, first, last, loss_, to_first_, to_last_);
  const bool inclined = table_.inclined(), flat = table_.flat();
  std::array<int, block_size> turning;
  int turning_count = 0;
  const int looked_at = inclined || table_.may_turn_within(first, last, c) ? last : first;
  for (int i = first; i < looked_at; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    if (!table_.may_turn(i, c)) {
      if (!inclined) continue;
      const double h = table_.length(i), weight = table_.weight(i + 1) - table_.weight(i);
      loss_[k] += weight;
      to_first_[k] += weight * h / 6.0;
      to_last_[k] += weight * h / 3.0;
      if (!std::isnan(stationary_point(i, c))) turning[static_cast<std::size_t>(turning_count++)] = i;
      continue;
    }
    turning[static_cast<std::size_t>(turning_count++)] = i;
    const Stretch stretch = cut_stretch(i, -1.0, 1.0, c);
    loss_[k] = stretch.loss;
    magnitude_ += stretch.magnitude;
    to_last_[k] = stretch.moment / table_.length(i);
    to_first_[k] = stretch.force - to_last_[k];
  }
  std::array<double, block_size + 1> along;
  along[0] = pressure.value();
  block_prefix(
      0, last - first, [&](int i) { return -loss_[static_cast<std::size_t>(first + i)]; }, along.data(), pressure);
  const int count = last - first;
  const double* p = along.data();
  const double* h = table_.lengths().data() + first;
  const double *loss = loss_.data() + first, *to_first = to_first_.data() + first, *to_last = to_last_.data() + first;
  double *pressures = out.pressure.data() + first, *forces = out.nodal_force.data() + first;
  Lanes magnitudes = broadcast(0.0), lowest_lanes = broadcast(p[count]), highest_lanes = lowest_lanes;
  double magnitude = 0.0, lowest = p[count], highest = p[count];
  const auto one = [&](int i) {
    pressures[i] += share * p[i];
    magnitude += std::abs(loss[i]);
    lowest = std::min(lowest, p[i]);
    highest = std::max(highest, p[i]);
    if (flat) return;
    const double before = i > 0 ? 0.5 * p[i - 1] * h[i - 1] - to_last[i - 1] : 0.0;
    forces[i] += share * (0.5 * p[i] * h[i] - to_first[i] + before);
  };
  one(0);
  int i = 1;
  for (; i + lane_count <= count; i += lane_count) {
    const Lanes here = load(p + i);
    store(pressures + i, load(pressures + i) + share * here);
    magnitudes += sunder::crackwater::magnitude(load(loss + i));
    lowest_lanes = here < lowest_lanes ? here : lowest_lanes;
    highest_lanes = here > highest_lanes ? here : highest_lanes;
    if (flat) continue;
    const Lanes before = 0.5 * load(p + i - 1) * load(h + i - 1) - load(to_last + i - 1);
    store(forces + i, load(forces + i) + share * (0.5 * here * load(h + i) - load(to_first + i) + before));
  }
  for (; i < count; ++i) one(i);
  if (!flat) forces[count] += share * (0.5 * p[count - 1] * h[count - 1] - to_last[count - 1]);
  magnitude_ += magnitude + sum(magnitudes);
  lowest_pressure_ =
      std::min({lowest_pressure_, lowest, lowest_lanes[0], lowest_lanes[1], lowest_lanes[2], lowest_lanes[3]});
  highest = std::max({highest, highest_lanes[0], highest_lanes[1], highest_lanes[2], highest_lanes[3]});
  if (highest > out.peak_pressure) {
    out.peak_pressure = highest;
    const auto at = std::find(p, p + count + 1, highest) - p;
    out.peak_position = table_.position(first + static_cast<int>(at));
  }
  for (int k = 0; k < turning_count; ++k) {
    const int at = turning[static_cast<std::size_t>(k)];
    note_extremes(at, -1.0, 1.0, c, p[at - first]);
  }
}

}  // namespace sunder::crackwater
