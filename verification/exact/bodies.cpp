#include "verification/exact/bodies.hpp"

namespace sunder::exact {

double effective_poisson_ratio(const PlaneBody& body) {
  return (3.0 - body.kolosov) / (1.0 + body.kolosov);
}

RingState ring_state(const Ring& ring, const PlaneBody& body, double radius) {
  const double a2 = ring.inner_radius * ring.inner_radius, b2 = ring.outer_radius * ring.outer_radius;
  const double A = (ring.inner_pressure * a2 - ring.outer_pressure * b2) / (b2 - a2);
  const double B = (ring.inner_pressure - ring.outer_pressure) * a2 * b2 / (b2 - a2);
  const double r2 = radius * radius;
  return {(0.5 * (body.kolosov - 1.0) * A * radius + B / radius) / (2.0 * body.shear_modulus), A - B / r2, A + B / r2};
}

Complex pure_bending(double curvature_stress, const PlaneBody& body, Complex z) {
  const double E = effective_modulus(body), nu = effective_poisson_ratio(body), x = z.real(), y = z.imag();
  return {curvature_stress * x * y / E, -0.5 * curvature_stress * (x * x + nu * y * y) / E};
}

Complex own_weight(double specific_weight, double height, const PlaneBody& body, Complex z) {
  const double E = effective_modulus(body), nu = effective_poisson_ratio(body), x = z.real(), y = z.imag();
  return {nu * specific_weight * x * (height - y) / E,
          0.5 * specific_weight * (y * y - 2.0 * height * y + nu * x * x) / E};
}

PlaneStress own_weight_stress(double specific_weight, double height, Complex z) {
  return {0.0, -specific_weight * (height - z.imag()), 0.0};
}

Complex end_loaded_cantilever(double force, double length, double height, const PlaneBody& body, Complex z) {
  const double E = effective_modulus(body), nu = effective_poisson_ratio(body), G = body.shear_modulus;
  const double I = height * height * height / 12.0, c2 = 0.25 * height * height, x = z.real(), y = z.imag();
  const double P = force;
  const double u = -P * x * x * y / (2.0 * E * I) - nu * P * y * y * y / (6.0 * E * I) + P * y * y * y / (6.0 * G * I) +
                   (P * length * length / (2.0 * E * I) - P * c2 / (2.0 * G * I)) * y;
  const double v = nu * P * x * y * y / (2.0 * E * I) + P * x * x * x / (6.0 * E * I) -
                   P * length * length * x / (2.0 * E * I) + P * length * length * length / (3.0 * E * I);
  return {u, v};
}

PlaneStress end_loaded_cantilever_stress(double force, double height, Complex z) {
  const double I = height * height * height / 12.0, x = z.real(), y = z.imag();
  return {-force * x * y / I, 0.0, -force * (0.25 * height * height - y * y) / (2.0 * I)};
}

}  // namespace sunder::exact
