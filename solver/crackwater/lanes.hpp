#pragma once
/// Four numbers at a time, in GCC's and Clang's vector notation: the sweeps over segments must not depend on whether a compiler
/// feels like vectorising, and their sums must come out in the same order everywhere.

#include <cstring>

namespace sunder::crackwater {

inline constexpr int lane_count = 4;
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = long long __attribute__((vector_size(32)));

inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}
inline void store(double* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }
inline Lanes broadcast(double value) { return Lanes{value, value, value, value}; }
inline double sum(Lanes lanes) { return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]); }
inline bool any(LaneMask mask) { return ((mask[0] | mask[1]) | (mask[2] | mask[3])) != 0; }
inline Lanes magnitude(Lanes lanes) { return lanes < 0.0 ? -lanes : lanes; }

/// A running sum that keeps what rounding drops [Neumaier 1974].
class CompensatedSum {
 public:
  void add(double value) {
    const double total = sum_ + value;
    const double part = total - sum_;
    rest_ += (sum_ - (total - part)) + (value - part);
    sum_ = total;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0.0, rest_ = 0.0;
};

}  // namespace sunder::crackwater
