/// Prefix sums of the segments' coefficients: the loss over any range of a crack whose V is monotone in O(log n).
///
/// With C_j = Σ ∫ V^j w⁻³ ds over a range of one regime, the loss is ± b (C_0 c² - 2 C_1 c + C_2) or a (C_0 c - C_1). The ranges
/// are found by bisection for V = c ± q_c; the one or two segments that hold those points are cut as in the sweep.

#include <algorithm>
#include <cmath>

#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/crackwater/segment_table.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

namespace {
constexpr int block_size = 64;
}

void SegmentTable::fill_prefix() {
  CompensatedSum total0, total1, total2;
  for (int block = 0; block < count_; block += block_size) {
    const double base0 = total0.value(), base1 = total1.value(), base2 = total2.value();
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    for (int i = block; i < std::min(block + block_size, count_); ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      const double v = middle_[k], a0 = loss_.a0[k], a1 = loss_.a1[k];
      c0 += a0;
      c1 += a0 * v + a1;
      c2 += v * (a0 * v + 2.0 * a1) + loss_.a2[k];
      sum0_[k + 1] = base0 + c0;
      sum1_[k + 1] = base1 + c1;
      sum2_[k + 1] = base2 + c2;
    }
    total0.add(c0);
    total1.add(c1);
    total2.add(c2);
  }
}

SegmentTable::Totals SegmentTable::prefix_totals() const {
  const std::size_t last = static_cast<std::size_t>(count_);
  return {sum0_[last], sum1_[last], sum2_[last]};
}

Loss SegmentTable::prefix_loss(double c, int first, int last) const {
  // With V falling the crack is looked at with the signs of V and c changed: φ is odd.
  const double mirror = never_closing() ? 1.0 : -1.0;
  const bool flat = quadrature_ == Quadrature::midpoint;
  const auto low = [&](int i) { return mirror * (flat ? middle_[static_cast<std::size_t>(i)] : change_[static_cast<std::size_t>(i)]); };
  const auto high = [&](int i) {
    return mirror * (flat ? middle_[static_cast<std::size_t>(i)] : change_[static_cast<std::size_t>(i) + 1]);
  };
  const auto first_where = [&](int from, auto&& holds) {
    int length = last - from;
    while (length > 0) {
      const int half = length / 2;
      if (holds(from + half)) {
        length = half;
      } else {
        from += half + 1;
        length -= half + 1;
      }
    }
    return from;
  };
  const double at = mirror * c, down = at - law_.critical_flux, up = at + law_.critical_flux;
  // [first, a) turbulent forwards, [a, b) holds q = q_c, [b, e) laminar, [e, f) holds q = -q_c, [f, last) turbulent backwards
  const int a = first_where(first, [&](int i) { return flat ? high(i) >= down : high(i) > down; });
  const int b = flat ? a : first_where(a, [&](int i) { return low(i) >= down; });
  const int e = first_where(a, [&](int i) { return high(i) > up; });
  const int f = flat ? e : first_where(std::max(b, e), [&](int i) { return low(i) >= up; });

  Loss total;
  const auto add = [&](double value, double slope) {
    total.value += value;
    total.slope += slope;
    total.magnitude += std::abs(value);
  };
  const auto turbulent = [&](int from, int to, double sign) {
    if (from >= to) return;
    const std::size_t k = static_cast<std::size_t>(from), l = static_cast<std::size_t>(to);
    const double c0 = sum0_[l] - sum0_[k], c1 = mirror * (sum1_[l] - sum1_[k]), c2 = sum2_[l] - sum2_[k];
    const double value_sign = numerics::planted_fault("crackwater/unsigned-flux") ? mirror : sign;
    add(value_sign * law_.turbulent * ((c0 * at - c1) * at - (c1 * at - c2)), sign * 2.0 * law_.turbulent * (c0 * at - c1));
  };
  turbulent(first, a, 1.0);
  turbulent(f, last, -1.0);
  if (b < e) {
    const std::size_t k = static_cast<std::size_t>(b), l = static_cast<std::size_t>(e);
    const double c0 = sum0_[l] - sum0_[k], c1 = mirror * (sum1_[l] - sum1_[k]);
    add(law_.laminar * (c0 * at - c1), law_.laminar * c0);
  }
  const auto cut_range = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      const Loss part = cut_loss(i, c);
      total.value += mirror * part.value;
      total.slope += part.slope;
      total.magnitude += part.magnitude;
    }
  };
  cut_range(a, b);
  cut_range(std::max(b, e), f);
  total.value *= mirror;
  return total;
}

}  // namespace sunder::crackwater
