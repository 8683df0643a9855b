#include "verification/exact/cracks.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sunder::exact {
namespace {

using std::numbers::pi;

double square(double x) {
  return x * x;
}

void need_share(double x) {
  if (!(x > 0.0 && x < 1.0)) throw std::invalid_argument("a / W must lie between 0 and 1");
}

/// √(2 / (π x) tan(π x / 2))
double tangent_factor(double x) {
  need_share(x);
  return std::sqrt(2.0 / (pi * x) * std::tan(0.5 * pi * x));
}

}  // namespace

IntensityFactors inclined_crack(double tension, double half_length, double angle) {
  const double K = tension * std::sqrt(pi * half_length);
  return {K * square(std::sin(angle)), K * std::sin(angle) * std::cos(angle)};
}

IntensityFactors arc_crack_biaxial(double tension, double radius, double half_angle) {
  const double s = std::sin(0.5 * half_angle), c = std::cos(0.5 * half_angle);
  const double K = tension * std::sqrt(pi * radius * std::sin(half_angle)) / (1.0 + s * s);
  return {K * c, K * s};
}

IntensityFactors arc_crack_uniaxial(double tension, double radius, double half_angle) {
  const double s = std::sin(0.5 * half_angle), c = std::cos(0.5 * half_angle);
  const double K = 0.5 * tension * std::sqrt(pi * radius * std::sin(half_angle));
  const double share = (1.0 - s * s * c * c) / (1.0 + s * s);
  return {K * (share * c + std::cos(1.5 * half_angle)), K * (share * s + std::sin(1.5 * half_angle))};
}

double edge_tension_tada(double x) {
  const double s = 1.0 - std::sin(0.5 * pi * x);
  return tangent_factor(x) * (0.752 + 2.02 * x + 0.37 * s * s * s) / std::cos(0.5 * pi * x);
}

double edge_tension_gross_brown(double x) {
  need_share(x);
  return 1.12 + x * (-0.231 + x * (10.55 + x * (-21.72 + x * 30.39)));
}

double edge_bending_tada(double x) {
  const double s = 1.0 - std::sin(0.5 * pi * x);
  return tangent_factor(x) * (0.923 + 0.199 * s * s * s * s) / std::cos(0.5 * pi * x);
}

double centre_secant_tada(double x) {
  need_share(x);
  return (1.0 - 0.025 * x * x + 0.06 * x * x * x * x) / std::sqrt(std::cos(0.5 * pi * x));
}

double centre_secant_feddersen(double x) {
  need_share(x);
  return 1.0 / std::sqrt(std::cos(0.5 * pi * x));
}

double centre_koiter(double x) {
  need_share(x);
  return (1.0 + x * (-0.5 + x * (0.370 - 0.044 * x))) / std::sqrt(1.0 - x);
}

double double_edge_tada(double x) {
  const double c2 = square(std::cos(0.5 * pi * x));
  return (1.0 + 0.122 * c2 * c2) * tangent_factor(x);
}

double compact_tension(double x) {
  need_share(x);
  const double polynomial = 0.886 + x * (4.64 + x * (-13.32 + x * (14.72 - 5.6 * x)));
  return (2.0 + x) * polynomial / std::pow(1.0 - x, 1.5);
}

double three_point_bending(double x) {
  need_share(x);
  const double bracket = 1.99 - x * (1.0 - x) * (2.15 + x * (-3.93 + 2.7 * x));
  return 4.0 * 3.0 * std::sqrt(x) * bracket / (2.0 * (1.0 + 2.0 * x) * std::pow(1.0 - x, 1.5));
}

Complex tip_displacement(const TipField& field, const PlaneBody& body, double r, double theta) {
  const double k = body.kolosov, s = std::sin(0.5 * theta), c = std::cos(0.5 * theta), ct = std::cos(theta);
  const double singular = std::sqrt(r / (2.0 * pi)) / (2.0 * body.shear_modulus);
  const double linear = field.T * r / (8.0 * body.shear_modulus);
  return {
      singular * (field.K_I * c * (k - ct) + field.K_II * s * (k + 2.0 + ct)) + linear * (k + 1.0) * ct,
      singular * (field.K_I * s * (k - ct) - field.K_II * c * (k - 2.0 + ct)) + linear * (k - 3.0) * std::sin(theta)};
}

PlaneStress tip_stress(const TipField& field, double r, double theta) {
  const double s = std::sin(0.5 * theta), c = std::cos(0.5 * theta);
  const double s3 = std::sin(1.5 * theta), c3 = std::cos(1.5 * theta);
  const double K_I = field.K_I / std::sqrt(2.0 * pi * r), K_II = field.K_II / std::sqrt(2.0 * pi * r);
  return {K_I * c * (1.0 - s * s3) - K_II * s * (2.0 + c * c3) + field.T, K_I * c * (1.0 + s * s3) + K_II * s * c * c3,
          K_I * c * s * c3 + K_II * c * (1.0 - s * s3)};
}

double kink_angle(double K_I, double K_II) {
  if (!(K_I >= 0.0)) throw std::invalid_argument("kink_angle: K_I must be >= 0");
  if (K_II == 0.0) return 0.0;
  // With K_II > 0 the derivative K_I sin θ + K_II (3 cos θ - 1) is > 0 at 0 and < 0 at -acos(1/3), between which it has
  // one zero, the maximum; K_II < 0 mirrors it. acos(1/3) = 70.5288° is pure mode II.
  const long double ratio = K_I / static_cast<long double>(std::abs(K_II));
  long double low = 0.0L, high = std::acos(1.0L / 3.0L);  // of |θ|
  for (int i = 0; i < 120; ++i) {
    const long double angle = 0.5L * (low + high);
    const long double derivative = 3.0L * std::cos(angle) - 1.0L - ratio * std::sin(angle);
    (derivative > 0.0L ? low : high) = angle;
  }
  return static_cast<double>(K_II > 0.0 ? -low : low);
}

IntensityFactors kinked_cotterell_rice(const IntensityFactors& before, double theta) {
  const double s = std::sin(0.5 * theta), c = std::cos(0.5 * theta), s3 = std::sin(1.5 * theta),
               c3 = std::cos(1.5 * theta);
  return {0.25 * ((3.0 * c + c3) * before.K_I - 3.0 * (s + s3) * before.K_II),
          0.25 * ((s + s3) * before.K_I + (c + 3.0 * c3) * before.K_II)};
}

IntensityFactors kinked_amestoy_leblond(const IntensityFactors& before, double theta) {
  const double m = theta / pi, m2 = m * m, p2 = pi * pi, p4 = p2 * p2, p6 = p4 * p2;
  const double F11 =
      1.0 +
      m2 * (-3.0 * p2 / 8.0 + m2 * (p2 - 5.0 * p4 / 128.0 + m2 * (p2 / 9.0 - 11.0 * p4 / 72.0 + 119.0 * p6 / 15360.0)));
  const double F12 = m * (-1.5 * pi + m2 * (10.0 * pi / 3.0 + pi * p2 / 16.0));
  const double F21 = m * (0.5 * pi - m2 * (4.0 * pi / 3.0 + pi * p2 / 48.0));
  const double F22 = 1.0 + m2 * (-(4.0 + 3.0 * p2 / 8.0) + m2 * (8.0 / 3.0 + 29.0 * p2 / 18.0 - 5.0 * p4 / 128.0));
  return {F11 * before.K_I + F12 * before.K_II, F21 * before.K_I + F22 * before.K_II};
}

}  // namespace sunder::exact
