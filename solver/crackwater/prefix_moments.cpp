/// The loss over any range of a crack from prefix sums over blocks of segments.

#include <algorithm>
#include <cmath>

#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/segment_table.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

namespace {

/// The first of [from, to) for which `holds`, which is false up to there and true from there on.
template <class Predicate>
int first_where(int from, int to, Predicate&& holds) {
  while (from < to) {
    const int middle = from + (to - from) / 2;
    if (holds(middle)) {
      to = middle;
    } else {
      from = middle + 1;
    }
  }
  return from;
}

}  // namespace

Loss SegmentTable::prefix_loss(double c, int first, int last) const {
  const int begin = (first + block_size - 1) / block_size, end = last / block_size;
  if (begin >= end) return loss(c, first, last, true);
  Loss total;
  const auto turbulent = [&](int from, int to, double sign) {
    if (from >= to) return;
    const std::size_t k = static_cast<std::size_t>(from), l = static_cast<std::size_t>(to);
    const double c0 = sum0_[l] - sum0_[k], c1 = sum1_[l] - sum1_[k], c2 = sum2_[l] - sum2_[k];
    const double squares = (c0 * c - c1) * c - (c1 * c - c2);
    const double value_sign = numerics::planted_fault("crackwater/unsigned-flux") ? 1.0 : sign;
    total.add({value_sign * law_.turbulent * squares, 2.0 * law_.turbulent * std::abs(c0 * c - c1),
               std::abs(law_.turbulent * squares)});
  };
  const auto laminar = [&](int from, int to) {
    if (from >= to) return;
    const std::size_t k = static_cast<std::size_t>(from), l = static_cast<std::size_t>(to);
    const double c0 = sum0_[l] - sum0_[k], value = law_.laminar * (c0 * c - (sum1_[l] - sum1_[k]));
    total.add({value, law_.laminar * c0, std::abs(value)});
  };
  const double critical = law_.critical_flux;
  const auto low = [&](int b) { return c - block_high_[static_cast<std::size_t>(b)]; };  // least flux in a block
  const auto high = [&](int b) { return c - block_low_[static_cast<std::size_t>(b)]; };
  const auto sweep = [&](int from, int to) {
    if (from < to) total.add(loss(c, from * block_size, to * block_size, true));
  };

  if (first < begin * block_size) total.add(loss(c, first, begin * block_size, true));
  if (never_closing() || never_opening()) {
    // forwards turbulent, changing, laminar, changing, backwards turbulent; or the other way round
    const bool falling = never_closing();
    const double sign = falling ? 1.0 : -1.0;
    const auto beyond = [&](int b) { return falling ? low(b) > critical : high(b) < -critical; };
    const auto back = [&](int b) { return falling ? high(b) < -critical : low(b) > critical; };
    const auto within = [&](int b) { return falling ? high(b) <= critical : low(b) >= -critical; };
    const auto leaving = [&](int b) { return falling ? low(b) < -critical : high(b) > critical; };
    const int a = first_where(begin, end, [&](int b) { return !beyond(b); });
    const int d = first_where(a, end, within);
    const int e = first_where(d, end, leaving);
    const int f = first_where(e, end, back);
    turbulent(begin, a, sign);
    sweep(a, d);
    laminar(d, e);
    sweep(e, f);
    turbulent(f, end, -sign);
  } else {
    for (int b = begin; b < end; ++b) {
      if (low(b) > critical) {
        turbulent(b, b + 1, 1.0);
      } else if (high(b) < -critical) {
        turbulent(b, b + 1, -1.0);
      } else if (low(b) >= -critical && high(b) <= critical) {
        laminar(b, b + 1);
      } else {
        sweep(b, b + 1);
      }
    }
  }
  if (end * block_size < last) total.add(loss(c, end * block_size, last, true));
  return total;
}

}  // namespace sunder::crackwater
