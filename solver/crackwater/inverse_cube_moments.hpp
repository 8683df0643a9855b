#pragma once
/// M_k(τ) = ∫₋₁¹ y^k / (1 + τ y)³ dy, k = 0 … 6: what a power of the position contributes to the pressure loss of a
/// segment whose aperture tapers linearly from 1 - τ to 1 + τ times its middle value.
///
/// For little taper the power series in τ, in closed form for k = 0 and 1:
/// M_k = Σ_j (-τ)^j (j+1)(j+2)/(k+j+1) over the j for which k + j is even. Otherwise integration by parts gives
/// k M_{k-1} + (k - 2) τ M_k = B_k with B_k = (1+τ)⁻² - (-1)^k (1-τ)⁻². Run downwards the recurrence shrinks an error
/// by |τ|(k-2)/k a step, so it is started above with zero and forgets that: no logarithm and no cancellation. For |τ| >
/// 0.8 (apertures beyond 1 : 9) it is run upwards from M_2, which is then the stable direction.

#include <array>
#include <cmath>
#include <cstddef>

namespace sunder::crackwater {

inline constexpr int moment_count = 7;

// Terms that leave less than 1e-17 of the series: little_taper^(2 · 3) and some_taper^(2 · 7), times at most 120.
inline constexpr double little_taper = 1e-3, some_taper = 0.05;
inline constexpr int terms_for_little_taper = 3, terms_for_some_taper = 7;

/// Σ_n c_n x^n of the even or odd j's: j = 2n for even k, 2n + 1 for odd k.
template <int k, int n, int terms, class Real>
inline Real moment_series(Real square) {
  constexpr int j = 2 * n + k % 2;
  constexpr double c = (j + 1.0) * (j + 2.0) / (k + j + 1.0);
  if constexpr (n + 1 == terms) {
    return c + 0.0 * square;
  } else {
    return c + square * moment_series<k, n + 1, terms>(square);
  }
}

/// For a number or a vector of numbers; `closeness` is 1 - τ².
template <int terms, class Real>
inline void moments_of_little_taper(Real taper, Real closeness, Real* m) {
  const Real scale = 2.0 / (closeness * closeness), square = taper * taper;
  m[0] = scale;
  m[1] = -taper * scale;
  m[2] = moment_series<2, 0, terms>(square);
  m[3] = -taper * moment_series<3, 0, terms>(square);
  m[4] = moment_series<4, 0, terms>(square);
  m[5] = -taper * moment_series<5, 0, terms>(square);
  m[6] = moment_series<6, 0, terms>(square);
}

/// For any taper |τ| < 1, given by the two apertures themselves so that nothing is lost where one is far the smaller.
inline std::array<double, moment_count> inverse_cube_moments(double first, double last) {
  std::array<double, moment_count> m{};
  const double inverse = 1.0 / (first + last);
  const double taper = (last - first) * inverse, size = std::abs(taper);
  const double closeness = 4.0 * (first * inverse) * (last * inverse);
  if (size <= little_taper) {
    moments_of_little_taper<terms_for_little_taper>(taper, closeness, m.data());
    return m;
  }
  if (size <= some_taper) {
    moments_of_little_taper<terms_for_some_taper>(taper, closeness, m.data());
    return m;
  }
  const double scale = 1.0 / (closeness * closeness);
  const double odd = 2.0 * (2.0 - closeness) * scale;  // B_k, k odd; 1 + τ² = 2 - (1 - τ²)
  const double even = -4.0 * taper * scale;            // B_k, k even, without the cancellation of its two terms
  m[0] = 2.0 * scale;
  m[1] = even / 2.0;
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
