#pragma once
/// Is this a field of plane elasticity? Hooke's law and equilibrium by differences of the displacement and of the
/// stress.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "verification/exact/plane_elasticity.hpp"

namespace sunder::exact {

struct Field {
  std::function<Complex(Complex)> displacement;  ///< [m]
  std::function<PlaneStress(Complex)> stress;    ///< [Pa]
  Complex body_force{};                          ///< [N/m³]
};

/// Fourth-order central difference with step h.
template <class Value>
Value slope(const std::function<Value(double)>& f, double h) {
  return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}

/// `size` is a length over which the field varies by its own magnitude. With h = size / 1000 the difference quotient is
/// off by about h⁴ / 30 · f⁽⁵⁾ = 1e-12 · (up to 8·7·6·5·4 for degree 8) / 30 and by round-off 1e-16 / h: tolerance 1e-8
/// of the largest stress.
inline void expect_elastic(const Field& field, const PlaneBody& body, Complex z, double size) {
  const double h = 1e-3 * size;
  const auto along = [&](Complex direction) {
    return slope<Complex>([&](double t) { return field.displacement(z + t * direction); }, h);
  };
  const Complex dx = along({1.0, 0.0}), dy = along({0.0, 1.0});
  const double e_xx = dx.real(), e_yy = dy.imag(), e_xy = 0.5 * (dx.imag() + dy.real());
  const PlaneStress s = field.stress(z);
  const double largest = std::max(
      {std::abs(s.xx), std::abs(s.yy), std::abs(s.xy), body.shear_modulus * std::max(std::abs(dx), std::abs(dy))});
  const double tolerance = 1e-8 * largest;
  EXPECT_NEAR(s.xx + s.yy, 4.0 * body.shear_modulus / (body.kolosov - 1.0) * (e_xx + e_yy),
              tolerance / (body.kolosov - 1.0));
  EXPECT_NEAR(s.yy - s.xx, 2.0 * body.shear_modulus * (e_yy - e_xx), tolerance);
  EXPECT_NEAR(s.xy, 2.0 * body.shear_modulus * e_xy, tolerance);

  const auto row = [&](bool second) {
    const auto part = [&](double t, Complex direction, bool y) {
      const PlaneStress at = field.stress(z + t * direction);
      return second ? (y ? at.yy : at.xy) : (y ? at.xy : at.xx);
    };
    return slope<double>(
               [&](double t) {
                 return part(t, {1.0, 0.0}, false);
               },
               h) +
           slope<double>(
               [&](double t) {
                 return part(t, {0.0, 1.0}, true);
               },
               h);
  };
  EXPECT_NEAR(row(false) + field.body_force.real(), 0.0, tolerance / size);
  EXPECT_NEAR(row(true) + field.body_force.imag(), 0.0, tolerance / size);
}

}  // namespace sunder::exact
