#include "solver/crackwater/segment_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/crackwater/check.hpp"
#include "solver/crackwater/inverse_cube_moments.hpp"
#include "solver/crackwater/lanes.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

namespace {

/// α and β of a segment from its rates.
inline double linear_change(double length, double first_rate, double last_rate) {
  return 0.25 * length * (first_rate + last_rate);
}
inline double quadratic_change(double length, double first_rate, double last_rate) {
  return 0.125 * length * (last_rate - first_rate);
}

/// A_j from the moments, for numbers and lanes alike.
template <class Real>
struct LossCoefficients {
  Real a0, a1, a2;
};

template <class Real>
inline LossCoefficients<Real> coefficients(const Real* m, Real scale, Real alpha, Real beta) {
  return {scale * m[0], scale * (alpha * m[1] + beta * m[2]),
          scale * (alpha * (alpha * m[2] + 2.0 * beta * m[3]) + beta * beta * m[4])};
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
    climb_ += std::abs(law.weight * line.rises[i]);
  }
  aperture_.assign(nodes, 1.0);
  for (auto* values : {&rate_, &change_}) values->assign(nodes, 0.0);
  for (auto* values : {&middle_, &spread_, &a0_, &a1_, &a2_}) values->assign(segments, 0.0);
  const std::size_t blocks = (segments + block_size - 1) / block_size;
  for (auto* values : {&block_low_, &block_high_}) values->assign(blocks, 0.0);
  for (auto* values : {&sum0_, &sum1_, &sum2_}) values->assign(blocks + 1, 0.0);
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
  for (; i <= count_; ++i)
    all = all && apertures[static_cast<std::size_t>(i)] > 0.0 && apertures[static_cast<std::size_t>(i)] <= 1e300;
  return all;
}

bool SegmentTable::fill(std::span<const double> apertures, std::span<const double> rates) {
  steps_ = false;
  if (rates.size() != static_cast<std::size_t>(count_) + 1 || !take(apertures)) return false;
  std::copy(rates.begin(), rates.end(), rate_.begin());
  std::fill(rate_.begin() + count_ + 1, rate_.end(), 0.0);
  Lanes lanes_low = broadcast(rates[0]), lanes_high = lanes_low, nothing = broadcast(0.0);
  int node = 0;
  for (; node + lane_count <= count_ + 1; node += lane_count) {
    const Lanes v = load(&rate_[static_cast<std::size_t>(node)]);
    lanes_low = v < lanes_low ? v : lanes_low;
    lanes_high = v > lanes_high ? v : lanes_high;
    nothing += 0.0 * v;  // NaN where any rate is not finite
  }
  double least = std::min({lanes_low[0], lanes_low[1], lanes_low[2], lanes_low[3]});
  double greatest = std::max({lanes_high[0], lanes_high[1], lanes_high[2], lanes_high[3]});
  double check_sum = sum(nothing);
  for (; node <= count_; ++node) {
    const double v = rates[static_cast<std::size_t>(node)];
    least = std::min(least, v);
    greatest = std::max(greatest, v);
    check_sum += 0.0 * v;
  }
  if (!(check_sum == 0.0)) return false;
  least_rate_ = least;
  greatest_rate_ = greatest;
  if (planted_fault("crackwater/no-opening-rate")) {
    std::fill(rate_.begin(), rate_.end(), 0.0);
    least_rate_ = greatest_rate_ = 0.0;
  }
  CompensatedSum total;
  change_[0] = 0.0;
  for (int block = 0; block < count_; block += block_size) {  // block by block, so that all of it happens in the cache
    const int end = std::min(block + block_size, count_);
    block_prefix(
        block, end,
        [&](int i) {
          const std::size_t k = static_cast<std::size_t>(i);
          return 0.5 * length_[k] * (rate_[k] + rate_[k + 1]);
        },
        change_.data(), total);
    if (end == count_)
      std::fill(change_.begin() + count_ + 1, change_.end(), change_[static_cast<std::size_t>(count_)]);
    if (quadrature_ == Quadrature::midpoint) {
      fill_midpoint(block, end);
    } else {
      fill_moments(block, end);
    }
    fill_block(block, end);
  }
  if (never_closing() || never_opening()) {
    least_change_ = std::min(0.0, change_[static_cast<std::size_t>(count_)]);
    greatest_change_ = std::max(0.0, change_[static_cast<std::size_t>(count_)]);
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
  for (int i = 0; i < count_; ++i) {  // linear aperture, one flux a segment
    const std::size_t k = static_cast<std::size_t>(i);
    const double w0 = aperture_[k], w1 = aperture_[k + 1];
    a0_[k] = 0.5 * length_[k] * (w0 + w1) / (w0 * w0 * w1 * w1);
  }
  std::copy(changes.begin(), changes.end() - 1, middle_.begin());
  tip_step_ = changes.back();
  std::fill(spread_.begin(), spread_.end(), 0.0);
  for (auto* values : {&a1_, &a2_}) std::fill(values->begin(), values->end(), 0.0);
  for (int block = 0; block < count_; block += block_size) fill_block(block, std::min(block + block_size, count_));
  double check_sum = 0.0, before = changes[0];
  least_change_ = greatest_change_ = changes[0];
  least_rate_ = greatest_rate_ = 0.0;  // of their signs only: whether V ever falls or grows behind the mouth's node
  for (const double change : changes) {
    check_sum += 0.0 * change;
    least_change_ = std::min(least_change_, change);
    greatest_change_ = std::max(greatest_change_, change);
    least_rate_ = std::min(least_rate_, change - before);
    greatest_rate_ = std::max(greatest_rate_, change - before);
    before = change;
  }
  return check_sum == 0.0;
}

void SegmentTable::fill_midpoint(int first, int last) {
  for (int i = first; i < last; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double h = length_[k], wm = 0.5 * (aperture_[k] + aperture_[k + 1]);
    const double a = linear_change(h, rate_[k], rate_[k + 1]), b = quadratic_change(h, rate_[k], rate_[k + 1]);
    middle_[k] = change_[k] + a - b;
    a0_[k] = h / (wm * wm * wm);
  }
}

/// Regime ranges of a block and the prefix sums up to its end: of A_0, A_0 V + A_1, A_0 V² + 2 A_1 V + A_2.
void SegmentTable::fill_block(int first, int last) {
  Lanes low = broadcast(middle_[static_cast<std::size_t>(first)]), high = low;
  Lanes s0 = broadcast(0.0), s1 = s0, s2 = s0;
  int i = first;
  for (; i + lane_count <= last; i += lane_count) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Lanes v = load(&middle_[k]), d = load(&spread_[k]), a0 = load(&a0_[k]), a1 = load(&a1_[k]);
    low = v - d < low ? v - d : low;
    high = v + d > high ? v + d : high;
    s0 += a0;
    s1 += a0 * v + a1;
    s2 += v * (a0 * v + 2.0 * a1) + load(&a2_[k]);
  }
  double least = std::min({low[0], low[1], low[2], low[3]}), greatest = std::max({high[0], high[1], high[2], high[3]});
  double sum0 = sum(s0), sum1 = sum(s1), sum2 = sum(s2);
  for (; i < last; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double v = middle_[k];
    least = std::min(least, v - spread_[k]);
    greatest = std::max(greatest, v + spread_[k]);
    sum0 += a0_[k];
    sum1 += a0_[k] * v + a1_[k];
    sum2 += v * (a0_[k] * v + 2.0 * a1_[k]) + a2_[k];
  }
  const std::size_t block = static_cast<std::size_t>(first / block_size);
  block_low_[block] = least;
  block_high_[block] = greatest;
  sum0_[block + 1] = sum0_[block] + sum0;
  sum1_[block + 1] = sum1_[block] + sum1;
  sum2_[block + 1] = sum2_[block] + sum2;
}

template <int terms>
void SegmentTable::fill_four(int i) {
  const std::size_t k = static_cast<std::size_t>(i);
  const Lanes w0 = load(&aperture_[k]), w1 = load(&aperture_[k + 1]), h = load(&length_[k]);
  const Lanes v0 = load(&rate_[k]), v1 = load(&rate_[k + 1]);
  const Taper<Lanes> taper = taper_of(w0, w1);
  const Lanes inverse = taper.inverse_sum;
  Lanes m[moment_count];
  moments_of_little_taper<terms>(taper, m);
  const Lanes alpha = 0.25 * h * (v0 + v1), beta = 0.125 * h * (v1 - v0);
  const auto c = coefficients(m, 4.0 * h * (inverse * inverse * inverse), alpha, beta);
  store(&a0_[k], c.a0);
  store(&a1_[k], c.a1);
  store(&a2_[k], c.a2);
  store(&middle_[k], load(&change_[k]) + alpha - beta);
  store(&spread_[k], magnitude(alpha) + magnitude(beta));
}

void SegmentTable::fill_one(int i) {
  const std::size_t k = static_cast<std::size_t>(i);
  const double w0 = aperture_[k], w1 = aperture_[k + 1], h = length_[k];
  const Taper<double> taper = taper_of(w0, w1);
  const double inverse = taper.inverse_sum;
  const auto m = inverse_cube_moments(w0, w1, taper);
  const double alpha = linear_change(h, rate_[k], rate_[k + 1]), beta = quadratic_change(h, rate_[k], rate_[k + 1]);
  const auto c = coefficients(m.data(), 4.0 * h * (inverse * inverse * inverse), alpha, beta);
  a0_[k] = c.a0, a1_[k] = c.a1, a2_[k] = c.a2;
  middle_[k] = change_[k] + alpha - beta;
  spread_[k] = std::abs(alpha) + std::abs(beta);
}

void SegmentTable::fill_moments(int first, int last) {
  for (int i = first; i < last; i += lane_count) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Lanes w0 = load(&aperture_[k]), w1 = load(&aperture_[k + 1]);
    const Lanes difference = magnitude(w1 - w0), total = w0 + w1;
    if (!any(difference > little_taper * total)) {
      fill_four<terms_for_little_taper>(i);
    } else if (!any(difference > some_taper * total)) {
      fill_four<terms_for_some_taper>(i);
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
  return blocked_sum(
      first, last, [&](int i) { return a0_[static_cast<std::size_t>(i)]; },
      [&](int i) { return load(&a0_[static_cast<std::size_t>(i)]); });
}

}  // namespace sunder::crackwater
