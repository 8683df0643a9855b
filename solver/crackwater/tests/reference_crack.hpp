#pragma once
/// The crack of the seed paper's section 4: 45 m, 0.10 m wide at the upstream mouth and 0.05 m at the downstream one,
/// under 50 m of water upstream, its upstream mouth opening at a given rate and its downstream one at rest.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "solver/crackwater/pressure_profile.hpp"

namespace sunder::crackwater::tests {

inline constexpr double reference_head = 490500.0;  // Pa: 50 m, ρ = 1000, g = 9.81

inline double relative(double value, double expected) {
  return std::abs(value - expected) / std::max(std::abs(expected), std::numeric_limits<double>::min());
}

struct Motion {
  std::vector<double> apertures, rates;
};

/// Linear between the mouths.
inline Motion linear_motion(int segments, double first, double last, double first_rate, double last_rate) {
  Motion motion;
  for (int i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / segments;
    motion.apertures.push_back((1.0 - x) * first + x * last);
    motion.rates.push_back((1.0 - x) * first_rate + x * last_rate);
  }
  return motion;
}

inline Motion reference_motion(int segments, double rate) {
  return linear_motion(segments, 0.10, 0.05, rate, 0.0);
}

inline constexpr Search all_searches[] = {Search::bisection, Search::itp, Search::toms748, Search::newton,
                                          Search::prefix_moments};

}  // namespace sunder::crackwater::tests
