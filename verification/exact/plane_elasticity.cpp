#include "verification/exact/plane_elasticity.hpp"

#include <stdexcept>

namespace sunder::exact {
namespace {

struct Jet {
  Complex value, first, second;
};

/// Horner's rule for a polynomial and its first two derivatives.
Jet evaluate(const std::vector<Complex>& coefficients, Complex z) {
  Jet jet{};
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
    jet.second = jet.second * z + 2.0 * jet.first;
    jet.first = jet.first * z + jet.value;
    jet.value = jet.value * z + *c;
  }
  return jet;
}

}  // namespace

PlaneBody plane_strain(double youngs_modulus, double poisson_ratio) {
  return {0.5 * youngs_modulus / (1.0 + poisson_ratio), 3.0 - 4.0 * poisson_ratio};
}

PlaneBody plane_stress(double youngs_modulus, double poisson_ratio) {
  return {0.5 * youngs_modulus / (1.0 + poisson_ratio), (3.0 - poisson_ratio) / (1.0 + poisson_ratio)};
}

double effective_modulus(const PlaneBody& body) {
  return 8.0 * body.shear_modulus / (body.kolosov + 1.0);
}

Complex traction(const PlaneStress& stress, Complex normal) {
  return {stress.xx * normal.real() + stress.xy * normal.imag(), stress.xy * normal.real() + stress.yy * normal.imag()};
}

Complex displacement(const PolynomialField& field, const PlaneBody& body, Complex z) {
  const Jet phi = evaluate(field.phi, z), psi = evaluate(field.psi, z);
  return (body.kolosov * phi.value - z * std::conj(phi.first) - std::conj(psi.value)) / (2.0 * body.shear_modulus);
}

PlaneStress stress(const PolynomialField& field, Complex z) {
  const Jet phi = evaluate(field.phi, z), psi = evaluate(field.psi, z);
  const double sum = 4.0 * phi.first.real();
  const Complex difference = 2.0 * (std::conj(z) * phi.second + psi.first);
  return {0.5 * (sum - difference.real()), 0.5 * (sum + difference.real()), 0.5 * difference.imag()};
}

PolynomialField polynomial_field(int degree, int part, double magnitude) {
  if (degree < 1 || part < 0 || part > 3)
    throw std::invalid_argument("polynomial_field: degree >= 1 and part 0 … 3 are needed");
  std::vector<Complex> coefficients(static_cast<std::size_t>(degree) + 1);
  coefficients.back() = part % 2 == 0 ? Complex(magnitude, 0.0) : Complex(0.0, magnitude);
  return part < 2 ? PolynomialField{coefficients, {}} : PolynomialField{{}, coefficients};
}

}  // namespace sunder::exact
