#pragma once
/// Four numbers at a time, in GCC's and Clang's vector notation: the sweeps over segments must not depend on whether a
/// compiler feels like vectorising, and their sums must come out in the same order everywhere.

#include <cstring>

#include "solver/numerics/compensated_sum.hpp"

namespace sunder::crackwater {

using numerics::CompensatedSum;

inline constexpr int lane_count = 4;
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = decltype(Lanes{} < Lanes{});  ///< -1 where true

inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store(double* to, Lanes lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}
inline Lanes broadcast(double value) {
  return Lanes{value, value, value, value};
}
inline double sum(Lanes lanes) {
  return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
}
inline bool any(LaneMask mask) {
  return ((mask[0] | mask[1]) | (mask[2] | mask[3])) != 0;
}
inline LaneMask bits(Lanes lanes) {
  LaneMask mask;
  std::memcpy(&mask, &lanes, sizeof mask);
  return mask;
}
inline Lanes from_bits(LaneMask mask) {
  Lanes lanes;
  std::memcpy(&lanes, &mask, sizeof lanes);
  return lanes;
}
inline Lanes magnitude(Lanes lanes) {
  return from_bits(bits(lanes) & 0x7fffffffffffffffL);
}
/// -lanes where `sign` is negative (-0 included), lanes elsewhere.
inline Lanes negated_with(Lanes lanes, Lanes sign) {
  return from_bits(bits(lanes) ^ (bits(sign) & ~0x7fffffffffffffffL));
}
/// 0 where the mask holds.
inline Lanes cleared(Lanes lanes, LaneMask mask) {
  return from_bits(bits(lanes) & ~mask);
}

/// Sums run plainly within so many terms and compensated from one block to the next, so that their error does not grow
/// with the crack.
inline constexpr int block_size = 64;

/// Σ term(i), i in [first, last), with `term` for a number and for four at once.
template <class One, class Four>
double blocked_sum(int first, int last, One&& one, Four&& four) {
  CompensatedSum total;
  const int lanes_end = first + (last - first) / lane_count * lane_count;
  for (int block = first; block < lanes_end; block += block_size) {
    Lanes part = broadcast(0.0);
    const int end = block + block_size < lanes_end ? block + block_size : lanes_end;
    for (int i = block; i < end; i += lane_count) part += four(i);
    total.add(sum(part));
  }
  for (int i = lanes_end; i < last; ++i) total.add(one(i));
  return total.value();
}

/// sums[i + 1] = total + Σ term over [first, i], four at a time, for a stretch of at most a block; adds the stretch to
/// `total`.
template <class Term>
inline void block_prefix(int first, int last, Term&& term, double* sums, CompensatedSum& total) {
  const double base = total.value();
  double local = 0.0;
  int i = first;
  for (; i + lane_count <= last; i += lane_count) {
    const double t0 = term(i), t1 = term(i + 1), t2 = term(i + 2), t3 = term(i + 3);
    const double t01 = t0 + t1, t0123 = t01 + (t2 + t3);
    sums[i + 1] = base + (local + t0);
    sums[i + 2] = base + (local + t01);
    sums[i + 3] = base + (local + (t01 + t2));
    local += t0123;
    sums[i + 4] = base + local;
  }
  for (; i < last; ++i) {
    local += term(i);
    sums[i + 1] = base + local;
  }
  total.add(local);
  sums[last] = total.value();
}

}  // namespace sunder::crackwater
