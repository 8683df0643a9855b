#include "solver/crackwater/inverse_cube_moments.hpp"

namespace sunder::crackwater {

std::array<double, moment_count> moments_of_much_taper(double first, double last) {
  std::array<double, moment_count> m{};
  const double inverse = 1.0 / (first + last);
  const double taper = (last - first) * inverse;
  const double closeness = 4.0 * (first * inverse) * (last * inverse);
  const double scale = 1.0 / (closeness * closeness);
  const double odd = 2.0 * (2.0 - closeness) * scale;  // B_k, k odd; 1 + τ² = 2 - (1 - τ²)
  const double even = -4.0 * taper * scale;            // B_k, k even, without the cancellation of its two terms
  m[0] = 2.0 * scale;
  m[1] = even / 2.0;
  const double size = std::abs(taper);
  if (size > 0.8) {
    m[2] = (std::log(last / first) / taper - 4.0 / closeness + 2.0 * scale) / (taper * taper);
    for (int k = 3; k < moment_count; ++k) {
      const std::size_t at = static_cast<std::size_t>(k);
      m[at] = ((k % 2 == 1 ? odd : even) - k * m[at - 1]) / ((k - 2.0) * taper);
    }
    return m;
  }
  double moment = 0.0;
  for (int k = size <= 0.4 ? 46 : 166; k > 2; --k) {  // 0.4^40 and 0.8^160 are below 1e-15 · (k/166)²
    if (k < moment_count) m[static_cast<std::size_t>(k)] = moment;
    moment = ((k % 2 == 1 ? odd : even) - (k - 2.0) * taper * moment) / k;
  }
  m[2] = moment;
  return m;
}

}  // namespace sunder::crackwater
