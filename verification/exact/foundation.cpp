#include "verification/exact/foundation.hpp"

#include <cmath>
#include <numbers>

namespace sunder::exact {
namespace {

using Complex = std::complex<double>;

/// H_n⁽²⁾(x) = J_n - i Y_n.
Complex hankel(int n, double x) {
  return {std::cyl_bessel_j(n, x), -std::cyl_neumann(n, x)};
}

/// K_n(i x) = -(π i/2) (-i)ⁿ H_n⁽²⁾(x).
Complex modified(int n, double x) {
  const Complex turn = n == 0 ? Complex(1.0) : Complex(0.0, -1.0);
  return Complex(0.0, -0.5 * std::numbers::pi) * turn * hankel(n, x);
}

}  // namespace

std::complex<double> rigid_disc_translation(double poisson_ratio, double a0) {
  const double ratio = std::sqrt((1.0 - 2.0 * poisson_ratio) / (2.0 - 2.0 * poisson_ratio));  // c_s / c_p
  const Complex a(0.0, a0), b(0.0, a0 * ratio);
  const Complex K0a = modified(0, a0), K1a = modified(1, a0), K0b = modified(0, a0 * ratio),
                K1b = modified(1, a0 * ratio);
  return std::numbers::pi * a * a * (4.0 * K1b * K1a + a * K1b * K0a + b * K0b * K1a) /
         (b * K0b * K1a + a * K1b * K0a + a * b * K0b * K0a);
}

std::complex<double> rigid_disc_rotation(double a0) {
  return 2.0 * std::numbers::pi * a0 * hankel(2, a0) / hankel(1, a0);
}

}  // namespace sunder::exact
