#pragma once
/// M_k(τ) = ∫₋₁¹ y^k / (1 + τ y)³ dy, k = 0 … 6: what a power of the position contributes to the pressure loss of a segment
/// whose aperture tapers linearly from 1 - τ to 1 + τ times its middle value.
///
/// Integration by parts gives k M_{k-1} + (k - 2) τ M_k = B_k with B_k = (1+τ)⁻² - (-1)^k (1-τ)⁻². Run downwards the recurrence
/// shrinks an error by |τ|(k-2)/k a step, so it is started above with zero and forgets that: no logarithm, no cancellation for
/// little taper. For |τ| > 0.8 (apertures beyond 1 : 9) it is run upwards from M_2, which is then the stable direction.

#include <array>
#include <cmath>

namespace sunder::crackwater {

inline constexpr int moment_count = 7;

/// The start of the downward recurrence that leaves an error below 1e-16 in every moment, for tapers up to |τ| ≤ 0.8.
inline int moment_start(double largest_taper) {
  if (largest_taper <= 1e-3) return 11;
  if (largest_taper <= 0.05) return 17;
  if (largest_taper <= 0.4) return 44;
  return 166;
}

/// Downward recurrence for a number or a vector of numbers; `closeness` is 1 - τ², > 0. `start` may be a compile-time constant.
template <class Real, class Start>
inline void downward_moments(Real taper, Real closeness, Start start, Real* moments) {
  const Real scale = 1.0 / (closeness * closeness);
  const Real odd = 2.0 * (2.0 - closeness) * scale;  // B_k, k odd; 1 + τ² = 2 - (1 - τ²)
  const Real even = -4.0 * taper * scale;            // B_k, k even, without the cancellation of its two terms
  Real moment = taper * 0.0;
#pragma GCC unroll 16
  for (int k = start; k >= moment_count; --k) {
    moment = ((k % 2 == 1 ? odd : even) - (k - 2.0) * taper * moment) * (1.0 / k);
  }
#pragma GCC unroll 16
  for (int k = moment_count - 1; k >= 1; --k) {
    moments[k] = moment;
    moment = ((k % 2 == 1 ? odd : even) - (k - 2.0) * taper * moment) * (1.0 / k);
  }
  moments[0] = 2.0 * scale;  // exact
}

/// For any taper |τ| < 1, given by the two apertures themselves so that nothing is lost where one is far the smaller.
inline std::array<double, moment_count> inverse_cube_moments(double first, double last) {
  std::array<double, moment_count> m{};
  const double sum = first + last;
  const double taper = (last - first) / sum;
  const double closeness = 4.0 * (first / sum) * (last / sum);
  if (std::abs(taper) <= 0.8) {
    downward_moments(taper, closeness, moment_start(std::abs(taper)), m.data());
    return m;
  }
  const double scale = 1.0 / (closeness * closeness);
  const double odd = 2.0 * (2.0 - closeness) * scale, even = -4.0 * taper * scale;
  m[0] = 2.0 * scale;
  m[1] = even / 2.0;
  m[2] = (std::log(last / first) / taper - 4.0 / closeness + 2.0 * scale) / (taper * taper);
  for (int k = 3; k < moment_count; ++k) {
    m[static_cast<std::size_t>(k)] =
        ((k % 2 == 1 ? odd : even) - k * m[static_cast<std::size_t>(k - 1)]) / ((k - 2.0) * taper);
  }
  return m;
}

}  // namespace sunder::crackwater
