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

// Terms that leave less than 1e-16 of the series: little_taper^(2 · 4) and some_taper^(2 · 7), times at most 120.
inline constexpr double little_taper = 4e-3, some_taper = 0.05;
inline constexpr int terms_for_little_taper = 4, terms_for_some_taper = 7;

/// What the formulas ask of two apertures, for one division.
template <class Real>
struct Taper {
  Real inverse_sum;        ///< 1/(w0 + w1)
  Real taper;              ///< τ
  Real inverse_closeness;  ///< 1/(1 - τ²) = (w0 + w1)²/(4 w0 w1)
};

template <class Real>
inline Taper<Real> taper_of(Real first, Real last) {
  const Real total = first + last, product = first * last, inverse = 1.0 / (total * product);
  const Real inverse_sum = product * inverse;
  return {inverse_sum, (last - first) * inverse_sum, 0.25 * total * total * (total * inverse)};
}

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

/// For a number or a vector of numbers.
template <int terms, class Real>
inline void moments_of_little_taper(const Taper<Real>& of, Real* m) {
  const Real taper = of.taper, square = taper * taper;
  const Real scale = 2.0 * (of.inverse_closeness * of.inverse_closeness);
  m[0] = scale;
  m[1] = -taper * scale;
  m[2] = moment_series<2, 0, terms>(square);
  m[3] = -taper * moment_series<3, 0, terms>(square);
  m[4] = moment_series<4, 0, terms>(square);
  m[5] = -taper * moment_series<5, 0, terms>(square);
  m[6] = moment_series<6, 0, terms>(square);
}

/// For more than some taper, given by the two apertures themselves so that nothing is lost where one is far the
/// smaller.
std::array<double, moment_count> moments_of_much_taper(double first, double last);

/// For any taper |τ| < 1.
inline std::array<double, moment_count> inverse_cube_moments(double first, double last, const Taper<double>& of) {
  const double size = std::abs(of.taper);
  std::array<double, moment_count> m;
  if (size <= little_taper) {
    moments_of_little_taper<terms_for_little_taper>(of, m.data());
  } else if (size <= some_taper) {
    moments_of_little_taper<terms_for_some_taper>(of, m.data());
  } else {
    m = moments_of_much_taper(first, last);
  }
  return m;
}

}  // namespace sunder::crackwater
