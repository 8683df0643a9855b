#include "solver/crackwater/segment_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/crackwater/check.hpp"
#include "solver/crackwater/inverse_cube_moments.hpp"
#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

namespace {

/// Sums run plainly within so many segments and compensated from one to the next: the error does not grow with the crack.
constexpr int block_size = 64;

/// α and β of a segment from its rates.
inline double linear_change(double length, double first_rate, double last_rate) {
  return 0.25 * length * (first_rate + last_rate);
}
inline double quadratic_change(double length, double first_rate, double last_rate) {
  return 0.125 * length * (last_rate - first_rate);
}

/// A_j, and the same with the weights of the nodal forces, from the moments; for numbers and lanes alike.
template <class Real>
struct SegmentCoefficients {
  Real loss[3], to_first[3], to_last[3];
};

template <class Real>
inline SegmentCoefficients<Real> coefficients(const Real* m, Real scale, Real length, Real alpha, Real beta) {
  Real order[3][3];  // [weight y^k][A_j]
  for (int k = 0; k < 3; ++k) {
    order[k][0] = scale * m[k];
    order[k][1] = scale * (alpha * m[k + 1] + beta * m[k + 2]);
    order[k][2] = scale * (alpha * (alpha * m[k + 2] + 2.0 * beta * m[k + 3]) + beta * beta * m[k + 4]);
  }
  SegmentCoefficients<Real> c;
  const Real eighth = 0.125 * length;
  for (int j = 0; j < 3; ++j) {
    c.loss[j] = order[0][j];
    c.to_first[j] = eighth * (order[0][j] - 2.0 * order[1][j] + order[2][j]);  // ∫ N_a from here to the end: h (1 - y)²/8
    c.to_last[j] = eighth * (3.0 * order[0][j] - 2.0 * order[1][j] - order[2][j]);  // h (1 - y)(3 + y)/8
  }
  return c;
}

}  // namespace

CrackLine straight_crack(double length, int segments) {
  require_positive("length", length);
  if (segments < 1) refuse("segments", segments, ">= 1");
  return {std::vector<double>(static_cast<std::size_t>(segments), length / segments), {}};
}

void check(const CrackLine& line) {
  if (line.lengths.empty()) refuse("number of segments", 0, ">= 1");
  if (!line.rises.empty() && line.rises.size() != line.lengths.size()) {
    refuse("number of rises", static_cast<double>(line.rises.size()), "0 or the number of segments");
  }
  for (std::size_t i = 0; i < line.lengths.size(); ++i) {
    require_positive("lengths[" + std::to_string(i) + "]", line.lengths[i]);
    if (line.rises.empty()) continue;
    require_finite("rises[" + std::to_string(i) + "]", line.rises[i]);
    // a rise written as the difference of two heights may exceed the length by their round-off
    if (std::abs(line.rises[i]) > line.lengths[i] * (1.0 + 1e-9)) {
      refuse("rises[" + std::to_string(i) + "]", line.rises[i], "no longer than its segment");
    }
  }
}

SegmentTable::SegmentTable(const CrackLine& line, const FlowLaw& law, Quadrature quadrature)
    : count_(static_cast<int>(line.lengths.size())),
      padded_((count_ + lane_count - 1) / lane_count * lane_count),
      law_(law),
      quadrature_(quadrature) {
  check(line);
  if (planted_fault("crackwater/midpoint-for-exact")) quadrature_ = Quadrature::midpoint;
  const std::size_t segments = static_cast<std::size_t>(padded_), nodes = segments + 1;
  length_.assign(segments, 0.0);
  std::copy(line.lengths.begin(), line.lengths.end(), length_.begin());
  position_.assign(nodes, 0.0);
  weight_.assign(nodes, 0.0);
  CompensatedSum s, z;
  for (std::size_t i = 0; i < line.lengths.size(); ++i) {
    s.add(line.lengths[i]);
    position_[i + 1] = s.value();
    if (line.rises.empty()) continue;
    z.add(line.rises[i]);
    weight_[i + 1] = law.weight * z.value();
    inclined_ = inclined_ || law.weight * line.rises[i] != 0.0;
  }
  aperture_.assign(nodes, 1.0);
  for (auto* values : {&rate_, &change_, &sum0_, &sum1_, &sum2_}) values->assign(nodes, 0.0);
  for (auto* values : {&middle_, &spread_}) values->assign(segments, 0.0);
  for (auto* c : {&loss_, &to_first_, &to_last_}) {
    for (auto* values : {&c->a0, &c->a1, &c->a2}) values->assign(segments, 0.0);
  }
}

bool SegmentTable::take(std::span<const double> apertures) {
  if (apertures.size() != static_cast<std::size_t>(count_) + 1) return false;
  std::copy(apertures.begin(), apertures.end(), aperture_.begin());
  // Every comparison is false for NaN, so a NaN in any lane keeps `good` false there.
  LaneMask good{-1, -1, -1, -1};
  int i = 0;
  for (; i + lane_count <= count_ + 1; i += lane_count) {
    const Lanes w = load(&aperture_[static_cast<std::size_t>(i)]);
    good &= (w > 0.0) & (w <= 1e300);
  }
  bool all = !any(~good);
  for (; i <= count_; ++i) all = all && apertures[static_cast<std::size_t>(i)] > 0.0 && apertures[static_cast<std::size_t>(i)] <= 1e300;
  return all;
}

bool SegmentTable::fill(std::span<const double> apertures, std::span<const double> rates) {
  steps_ = false;
  if (rates.size() != static_cast<std::size_t>(count_) + 1 || !take(apertures)) return false;
  std::copy(rates.begin(), rates.end(), rate_.begin());
  std::fill(rate_.begin() + count_ + 1, rate_.end(), 0.0);
  double least = rates[0], greatest = rates[0], check_sum = 0.0;
  for (const double v : rates) {
    least = std::min(least, v);
    greatest = std::max(greatest, v);
    check_sum += 0.0 * v;  // NaN where any rate is not finite
  }
  if (!(check_sum == 0.0)) return false;
  least_rate_ = least;
  greatest_rate_ = greatest;
  if (planted_fault("crackwater/no-opening-rate")) {
    std::fill(rate_.begin(), rate_.end(), 0.0);
    least_rate_ = greatest_rate_ = 0.0;
  }
  CompensatedSum total;
  for (int block = 0; block < count_; block += block_size) {
    const double base = total.value();
    const int end = std::min(block + block_size, count_);
    double local = 0.0;
    for (int i = block; i < end; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      local += 0.5 * length_[k] * (rate_[k] + rate_[k + 1]);
      change_[k + 1] = base + local;
    }
    total.add(local);
    change_[static_cast<std::size_t>(end)] = total.value();
  }
  std::fill(change_.begin() + count_ + 1, change_.end(), change_[static_cast<std::size_t>(count_)]);
  if (quadrature_ == Quadrature::midpoint) {
    fill_midpoint();
  } else {
    fill_moments();
  }
  if (never_closing() || never_opening()) {
    const auto [low, high] = std::minmax(0.0, change_[static_cast<std::size_t>(count_)]);
    least_change_ = low;
    greatest_change_ = high;
    return true;
  }
  least_change_ = greatest_change_ = 0.0;
  for (int i = 0; i < count_; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    least_change_ = std::min({least_change_, change_[k + 1], middle_[k] - spread_[k]});
    greatest_change_ = std::max({greatest_change_, change_[k + 1], middle_[k] + spread_[k]});
  }
  return true;
}

bool SegmentTable::fill_steps(std::span<const double> apertures, std::span<const double> changes) {
  steps_ = true;
  if (changes.size() != static_cast<std::size_t>(count_) + 1 || !take(apertures)) return false;
  std::fill(rate_.begin(), rate_.end(), 0.0);
  fill_midpoint();
  // conductance as exact as the march allows: linear aperture, one flux a segment
  for (int i = 0; i < count_; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double w0 = aperture_[k], w1 = aperture_[k + 1];
    loss_.a0[k] = 0.5 * length_[k] * (w0 + w1) / (w0 * w0 * w1 * w1);
  }
  std::copy(changes.begin(), changes.end() - 1, middle_.begin());
  tip_step_ = changes.back();
  double check_sum = 0.0;
  least_change_ = greatest_change_ = changes[0];
  for (const double change : changes) {
    check_sum += 0.0 * change;
    least_change_ = std::min(least_change_, change);
    greatest_change_ = std::max(greatest_change_, change);
  }
  // a march takes the general path: neither sign is promised
  least_rate_ = -1.0;
  greatest_rate_ = 1.0;
  return check_sum == 0.0;
}

void SegmentTable::fill_midpoint() {
  for (int i = 0; i < count_; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double h = length_[k], wm = 0.5 * (aperture_[k] + aperture_[k + 1]);
    const double a = linear_change(h, rate_[k], rate_[k + 1]), b = quadratic_change(h, rate_[k], rate_[k + 1]);
    middle_[k] = change_[k] + a - b;
    spread_[k] = 0.0;
    loss_.a0[k] = h / (wm * wm * wm);
  }
}

template <int start>
void SegmentTable::fill_four(int i) {
  const std::size_t k = static_cast<std::size_t>(i);
  const Lanes w0 = load(&aperture_[k]), w1 = load(&aperture_[k + 1]), h = load(&length_[k]);
  const Lanes v0 = load(&rate_[k]), v1 = load(&rate_[k + 1]);
  const Lanes total = w0 + w1, inverse = 1.0 / total;
  const Lanes taper = (w1 - w0) * inverse, closeness = 4.0 * (w0 * inverse) * (w1 * inverse);
  Lanes m[moment_count];
  downward_moments(taper, closeness, std::integral_constant<int, start>{}, m);
  const Lanes alpha = 0.25 * h * (v0 + v1), beta = 0.125 * h * (v1 - v0);
  const auto c = coefficients(m, 4.0 * h * (inverse * inverse * inverse), h, alpha, beta);
  store(&loss_.a0[k], c.loss[0]);
  store(&loss_.a1[k], c.loss[1]);
  store(&loss_.a2[k], c.loss[2]);
  store(&to_first_.a0[k], c.to_first[0]);
  store(&to_first_.a1[k], c.to_first[1]);
  store(&to_first_.a2[k], c.to_first[2]);
  store(&to_last_.a0[k], c.to_last[0]);
  store(&to_last_.a1[k], c.to_last[1]);
  store(&to_last_.a2[k], c.to_last[2]);
  store(&middle_[k], load(&change_[k]) + alpha - beta);
  store(&spread_[k], magnitude(alpha) + magnitude(beta));
}

void SegmentTable::fill_one(int i) {
  const std::size_t k = static_cast<std::size_t>(i);
  const double w0 = aperture_[k], w1 = aperture_[k + 1], h = length_[k], wm = 0.5 * (w0 + w1);
  const auto m = inverse_cube_moments(w0, w1);
  const double alpha = linear_change(h, rate_[k], rate_[k + 1]), beta = quadratic_change(h, rate_[k], rate_[k + 1]);
  const auto c = coefficients(m.data(), 0.5 * h / (wm * wm * wm), h, alpha, beta);
  loss_.a0[k] = c.loss[0], loss_.a1[k] = c.loss[1], loss_.a2[k] = c.loss[2];
  to_first_.a0[k] = c.to_first[0], to_first_.a1[k] = c.to_first[1], to_first_.a2[k] = c.to_first[2];
  to_last_.a0[k] = c.to_last[0], to_last_.a1[k] = c.to_last[1], to_last_.a2[k] = c.to_last[2];
  middle_[k] = change_[k] + alpha - beta;
  spread_[k] = std::abs(alpha) + std::abs(beta);
}

void SegmentTable::fill_moments() {
  for (int i = 0; i < padded_; i += lane_count) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Lanes w0 = load(&aperture_[k]), w1 = load(&aperture_[k + 1]);
    const Lanes difference = magnitude(w1 - w0), total = w0 + w1;
    if (!any(difference > 1e-3 * total)) {
      fill_four<11>(i);
    } else if (!any(difference > 0.05 * total)) {
      fill_four<17>(i);
    } else {
      for (int j = i; j < std::min(i + lane_count, count_); ++j) fill_one(j);
    }
  }
}

Segment SegmentTable::segment(int i) const {
  const std::size_t k = static_cast<std::size_t>(i);
  const double h = length_[k];
  return {h,
          aperture_[k],
          aperture_[k + 1],
          middle_[k],
          flat() ? 0.0 : linear_change(h, rate_[k], rate_[k + 1]),
          flat() ? 0.0 : quadratic_change(h, rate_[k], rate_[k + 1])};
}

double SegmentTable::position(Location at) const {
  return position(at.segment) + 0.5 * (1.0 + at.y) * length(at.segment);
}

double SegmentTable::change(Location at) const {
  const Segment s = segment(at.segment);
  return s.middle + at.y * (s.linear + at.y * s.quadratic);
}

double SegmentTable::weight(Location at) const {
  return 0.5 * ((1.0 - at.y) * weight(at.segment) + (1.0 + at.y) * weight(at.segment + 1));
}

double SegmentTable::inverse_cubes(int first, int last) const {
  CompensatedSum total;
  for (int block = first; block < last; block += block_size) {
    double local = 0.0;
    for (int i = block; i < std::min(block + block_size, last); ++i) local += loss_.a0[static_cast<std::size_t>(i)];
    total.add(local);
  }
  return total.value();
}

bool SegmentTable::is_split(int i, double c) const {
  const std::size_t k = static_cast<std::size_t>(i);
  return std::abs(std::abs(c - middle_[k]) - law_.critical_flux) < spread_[k];
}

bool SegmentTable::may_turn(int i, double c) const {
  return std::abs(c - middle_[static_cast<std::size_t>(i)]) < spread_[static_cast<std::size_t>(i)] || is_split(i, c);
}

double SegmentTable::single_loss(int i, double c) const {
  const std::size_t k = static_cast<std::size_t>(i);
  const double d = c - middle_[k];
  if (std::abs(d) > law_.critical_flux) {
    const double sign = planted_fault("crackwater/unsigned-flux") ? 1.0 : std::copysign(1.0, d);
    return sign * law_.turbulent * ((loss_.a0[k] * d - 2.0 * loss_.a1[k]) * d + loss_.a2[k]);
  }
  return law_.laminar * (loss_.a0[k] * d - loss_.a1[k]);
}

Loss SegmentTable::cut_loss(int i, double c) const {
  const Pieces pieces = cut(segment(i), law_, c, -1.0, 1.0, std::numeric_limits<double>::quiet_NaN());
  Loss loss{0.0, pieces.cut_slope, 0.0};
  for (int k = 0; k < pieces.count; ++k) {
    loss.value += pieces.piece[static_cast<std::size_t>(k)].loss;
    loss.slope += pieces.piece[static_cast<std::size_t>(k)].slope;
    loss.magnitude += std::abs(pieces.piece[static_cast<std::size_t>(k)].loss);
  }
  return loss;
}

namespace {

/// The sweep over whole lanes of one block. Segments that must be cut add nothing and raise `split`.
struct LaneSums {
  Lanes value, slope, magnitude;
  LaneMask split;
};

struct SweepArrays {
  const double *middle, *spread, *a0, *a1, *a2;
};

template <bool wants_slope>
inline LaneSums sweep(const SweepArrays& at, const FlowLaw& law, double c, int first, int last) {
  LaneSums sums{broadcast(0.0), broadcast(0.0), broadcast(0.0), LaneMask{0, 0, 0, 0}};
  const Lanes critical = broadcast(law.critical_flux), zero = broadcast(0.0);
  const bool is_signed = !planted_fault("crackwater/unsigned-flux");
  for (int i = first; i < last; i += lane_count) {
    const Lanes d = c - load(at.middle + i), a0 = load(at.a0 + i), a1 = load(at.a1 + i), a2 = load(at.a2 + i);
    const Lanes size = magnitude(d);
    const LaneMask turbulent = size > critical;
    const LaneMask split = magnitude(size - critical) < load(at.spread + i);
    const Lanes once = a0 * d - a1;
    const Lanes square = law.turbulent * (once * d - (a1 * d - a2));
    const Lanes signed_square = is_signed ? (d < 0.0 ? -square : square) : square;
    const Lanes value = split ? zero : (turbulent ? signed_square : law.laminar * once);
    sums.value += value;
    sums.magnitude += magnitude(value);
    sums.split |= split;
    if constexpr (wants_slope) {
      const Lanes twice = 2.0 * law.turbulent * once;
      sums.slope += split ? zero : (turbulent ? (d < 0.0 ? -twice : twice) : law.laminar * a0);
    }
  }
  return sums;
}

}  // namespace

Loss SegmentTable::loss(double c, int first, int last, bool wants_slope) const {
  CompensatedSum value;
  Loss total;
  const auto add_one = [&](int i) {
    if (is_split(i, c)) {
      const Loss part = cut_loss(i, c);
      value.add(part.value);
      total.slope += part.slope;
      total.magnitude += part.magnitude;
      return;
    }
    const double part = single_loss(i, c);
    value.add(part);
    total.magnitude += std::abs(part);
    if (wants_slope) {
      const std::size_t k = static_cast<std::size_t>(i);
      const double d = c - middle_[k];
      total.slope += std::abs(d) > law_.critical_flux
                         ? 2.0 * law_.turbulent * std::copysign(1.0, d) * (loss_.a0[k] * d - loss_.a1[k])
                         : law_.laminar * loss_.a0[k];
    }
  };
  const SweepArrays at{middle_.data(), spread_.data(), loss_.a0.data(), loss_.a1.data(), loss_.a2.data()};
  const int lanes_end = first + (last - first) / lane_count * lane_count;
  for (int block = first; block < lanes_end; block += block_size) {
    const int end = std::min(block + block_size, lanes_end);
    const LaneSums sums = wants_slope ? sweep<true>(at, law_, c, block, end) : sweep<false>(at, law_, c, block, end);
    value.add(sum(sums.value));
    total.slope += sum(sums.slope);
    total.magnitude += sum(sums.magnitude);
    if (any(sums.split)) {
      for (int i = block; i < end; ++i) {
        if (is_split(i, c)) add_one(i);
      }
    }
  }
  for (int i = lanes_end; i < last; ++i) add_one(i);
  total.value = value.value();
  return total;
}

void SegmentTable::losses(double c, int first, int last, std::span<double> loss, std::span<double> to_first,
                          std::span<double> to_last) const {
  const auto apply = [&](const Coefficients& a, std::size_t k, double d) {
    if (std::abs(d) > law_.critical_flux) {
      const double sign = planted_fault("crackwater/unsigned-flux") ? 1.0 : std::copysign(1.0, d);
      return sign * law_.turbulent * ((a.a0[k] * d - a.a1[k]) * d - (a.a1[k] * d - a.a2[k]));
    }
    return law_.laminar * (a.a0[k] * d - a.a1[k]);
  };
  for (int i = first; i < last; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double d = c - middle_[k];
    loss[k] = apply(loss_, k, d);
    to_first[k] = apply(to_first_, k, d);
    to_last[k] = apply(to_last_, k, d);
  }
}

}  // namespace sunder::crackwater
