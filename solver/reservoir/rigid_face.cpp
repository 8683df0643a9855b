#include "solver/reservoir/rigid_face.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// Newton's method on z cos z + i b sin z, which has no poles; from a nearby start.
bool newton(double b, Complex& z) {
  const Complex ib(0.0, b);
  for (int i = 0; i < 40; ++i) {
    // divided by the larger of the exponentials, so that large imaginary parts do not overflow
    const Complex sine = std::sin(z), cosine = std::cos(z);
    const Complex change = (z * cosine + ib * sine) / (cosine - z * sine + ib * cosine);
    z -= change;
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag())) return false;
    if (std::abs(change) <= 1e-15 * std::abs(z)) return true;
  }
  return false;
}

}  // namespace

bool depth_eigenvalues(double kappa, double bottom_damping, int count, Complex* z) {
  const double b = kappa * bottom_damping;
  for (int n = 0; n < count; ++n) {
    z[n] = (n + 0.5) * pi;
    if (b == 0.0) continue;
    // by continuation in b: a step moves the root by about i db/z, to be small against the distance π of the roots
    const int steps = 1 + static_cast<int>(4.0 * b / std::abs(z[n]));
    for (int k = 1; k <= steps; ++k)
      if (!newton(b * k / steps, z[n])) return false;
  }
  return true;
}

RigidFaceResponse rigid_face_response(double kappa, double bottom_damping, int terms) {
  if (!(kappa >= 0.0) || !std::isfinite(kappa))
    throw std::invalid_argument("rigid_face_response: kappa = " + std::to_string(kappa) + " must be finite and >= 0");
  if (!(bottom_damping >= 0.0) || !std::isfinite(bottom_damping))
    throw std::invalid_argument("rigid_face_response: bottom_damping = " + std::to_string(bottom_damping) +
                                " must be finite and >= 0");
  if (terms < 1) throw std::invalid_argument("rigid_face_response: terms must be >= 1");
  RigidFaceResponse response;
  // the rest of the series is that of z >> κ
  const int count = std::max(terms, static_cast<int>(std::fmin(10.0 * kappa, 1e7)));
  std::vector<Complex> z(static_cast<std::size_t>(count));
  if (!depth_eigenvalues(kappa, bottom_damping, count, z.data())) {
    response.status = SeriesStatus::root_not_found;
    return response;
  }
  Complex last_pressure = 0.0;
  for (const Complex& zn : z) {
    const Complex difference = (zn - kappa) * (zn + kappa);
    if (std::abs(zn - kappa) <= 4.0 * std::numeric_limits<double>::epsilon() * kappa &&
        !numerics::planted_fault("reservoir/resonance-not-named")) {
      response.status = SeriesStatus::infinite;
      return response;
    }
    Complex root = std::sqrt(difference);
    if (root.real() == 0.0 && root.imag() < 0.0) root = -root;  // exp(iωt): the wave that runs away
    if (numerics::planted_fault("reservoir/series-root-branch") && difference.real() < 0.0) root = std::conj(root);
    const Complex I = (1.0 - std::cos(zn)) / zn, N = 0.5 * (1.0 - std::sin(2.0 * zn) / (2.0 * zn));
    response.force += I * I / (N * root);
    last_pressure = I * std::sin(zn) / (N * root);
    response.base_pressure += last_pressure;
  }
  const double terms_used = count;
  response.force += 1.0 / (pi * pi * pi * terms_used * terms_used);
  response.base_pressure -= 0.5 * last_pressure;  // alternating series: half the last term
  return response;
}

double rigid_face_impulse(double T) {
  if (!(T >= 0.0) || !std::isfinite(T))
    throw std::invalid_argument("rigid_face_impulse: T = " + std::to_string(T) + " must be finite and >= 0");
  if (T <= 2.0) return 1.0 - 2.0 * T / pi;
  constexpr int terms = 100'000;
  double sum = 0.0;
  for (int n = terms - 1; n >= 0; --n) {
    const double z = (n + 0.5) * pi;
    sum += 2.0 / (z * z) * ::j0(z * T);
  }
  return sum;
}

double absorbing_face_impulse(double T, double bottom_damping) {
  if (!(T >= 0.0) || !(T <= 1.0))
    throw std::invalid_argument("absorbing_face_impulse: T = " + std::to_string(T) + " must be 0 … 1");
  if (!(bottom_damping >= 0.0) || !std::isfinite(bottom_damping))
    throw std::invalid_argument("absorbing_face_impulse: bottom_damping must be finite and >= 0");
  // u = tan φ: β = ∫₀^{π/2} qc cos²φ / (1 + qc cos φ) dφ, smooth
  const numerics::QuadratureRule rule = numerics::gauss_legendre(40);
  double beta = 0.0;
  for (Eigen::Index g = 0; g < rule.points.size(); ++g) {
    const double cosine = std::cos(0.25 * pi * (1.0 + rule.points[g]));
    beta += 0.25 * pi * rule.weights[g] * bottom_damping * cosine * cosine / (1.0 + bottom_damping * cosine);
  }
  return 1.0 - 2.0 / pi * (1.0 + beta) * T;
}

}  // namespace sunder::reservoir
