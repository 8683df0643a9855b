#include "solver/fracture/williams.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::fracture {
namespace {

/// Amplitude of a_n (mode I) or b_n (mode II), from what the field is normalised to.
double amplitude(const WilliamsField& field) {
  const double sign = field.mode == Mode::I ? 1.0 : -1.0;
  // σ_yy = a / √r = K_I / √(2πr) ahead of the tip
  if (field.n == 1)
    return sign / std::sqrt(numerics::planted_fault("fracture/factor-without-pi") ? 2.0 : 2.0 * std::numbers::pi);
  if (field.n == 2 && field.mode == Mode::I) return 0.25;  // σ_xx = 4 a
  return 1.0;
}

double kappa_of(const material::Isotropic& material) {
  if (numerics::planted_fault("fracture/plane-stress-kappa")) {
    return (3.0 - material.poisson_ratio) / (1.0 + material.poisson_ratio);
  }
  return material::kolosov_constant(material);
}

/// cos and sin of multiples of θ/2, which is all that Williams' fields are made of, from one evaluation.
class HalfAngles {
 public:
  explicit HalfAngles(double theta) : cosine_(std::cos(0.5 * theta)), sine_(std::sin(0.5 * theta)) {}

  /// {cos mθ/2, sin mθ/2}
  Eigen::Vector2d multiple(int m) const {
    double c = 1.0, s = 0.0;
    for (int i = 0; i < std::abs(m); ++i) {
      const double next = c * cosine_ - s * sine_;
      s = s * cosine_ + c * sine_;
      c = next;
    }
    return {c, m < 0 ? -s : s};
  }

 private:
  double cosine_, sine_;
};

/// (-1)ⁿ
double parity(int n) {
  return n % 2 == 0 ? 1.0 : -1.0;
}

}  // namespace

TipFrame tip_frame(const sbfem::Boundary& boundary) {
  if (!boundary.open) throw std::invalid_argument("tip_frame: the polygon is closed, accepted is an open one");
  const Eigen::Vector2d lower = boundary.nodes.col(0), upper = boundary.nodes.col(boundary.nodes.cols() - 1);
  const Eigen::Vector2d mouth = 0.5 * (lower + upper);
  if (!((lower - upper).norm() <= 1e-6 * mouth.norm())) {
    throw std::invalid_argument("tip_frame: the ends of the open boundary lie apart; accepted is one place for both");
  }
  Eigen::Vector2d ahead = -mouth.normalized();
  if (numerics::planted_fault("fracture/tip-frame-askew")) ahead = Eigen::Rotation2Dd(0.05) * ahead;
  TipFrame frame{.direction = std::atan2(ahead.y(), ahead.x()), .to_global = {}, .face_length = mouth.norm()};
  frame.to_global << ahead.x(), -ahead.y(), ahead.y(), ahead.x();
  return frame;
}

Eigen::Matrix2Xd polar_nodes(const sbfem::Boundary& boundary, const TipFrame& frame) {
  const Eigen::Matrix2Xd local = frame.to_global.transpose() * boundary.nodes;
  Eigen::Matrix2Xd polar(2, local.cols());
  for (Eigen::Index i = 0; i < local.cols(); ++i) {
    polar.col(i) << local.col(i).norm(), std::atan2(local(1, i), local(0, i));
  }
  // The two ends of the boundary share a place: only their order tells the faces apart.
  const double lower = numerics::planted_fault("fracture/lower-face-first") ? std::numbers::pi : -std::numbers::pi;
  polar(1, 0) = lower;
  polar(1, local.cols() - 1) = -lower;
  return polar;
}

Eigen::Vector2d displacement(const WilliamsField& field, const material::Isotropic& material, double r, double theta) {
  if (field.n == 2 && field.mode == Mode::II) return {-r * std::sin(theta), r * std::cos(theta)};
  const double lambda = 0.5 * field.n, kappa = kappa_of(material), even = parity(field.n);
  const double scale = amplitude(field) * std::pow(r, lambda) / (2.0 * material::shear_modulus(material));
  const HalfAngles angles(theta);
  const Eigen::Vector2d first = angles.multiple(field.n), second = angles.multiple(field.n - 4);
  const double c1 = first[0], s1 = first[1], c2 = second[0], s2 = second[1];
  if (field.mode == Mode::I) {
    return scale *
           Eigen::Vector2d((kappa + lambda + even) * c1 - lambda * c2, (kappa - lambda - even) * s1 + lambda * s2);
  }
  return scale *
         Eigen::Vector2d(-(kappa + lambda - even) * s1 + lambda * s2, (kappa - lambda + even) * c1 + lambda * c2);
}

Eigen::Vector3d stress(const WilliamsField& field, double r, double theta) {
  if (field.n == 2 && field.mode == Mode::II) return Eigen::Vector3d::Zero();
  const double lambda = 0.5 * field.n, even = parity(field.n);
  const double scale = amplitude(field) * lambda * std::pow(r, lambda - 1.0);
  const HalfAngles angles(theta);
  const Eigen::Vector2d first = angles.multiple(field.n - 2), third = angles.multiple(field.n - 6);
  const double c1 = first[0], s1 = first[1], c3 = third[0], s3 = third[1];
  if (field.mode == Mode::I) {
    return scale * Eigen::Vector3d((2.0 + lambda + even) * c1 - (lambda - 1.0) * c3,
                                   (2.0 - lambda - even) * c1 + (lambda - 1.0) * c3,
                                   (lambda - 1.0) * s3 - (lambda + even) * s1);
  }
  return scale * Eigen::Vector3d(-(2.0 + lambda - even) * s1 + (lambda - 1.0) * s3,
                                 -(2.0 - lambda + even) * s1 - (lambda - 1.0) * s3,
                                 (lambda - 1.0) * c3 - (lambda - even) * c1);
}

Eigen::Vector2d displacement_slope(const WilliamsField& field, const material::Isotropic& material, double r,
                                   double theta) {
  // ∂/∂x = cos θ ∂/∂r - (sin θ / r) ∂/∂θ, and r ∂u/∂r = λ u.
  if (field.n == 2 && field.mode == Mode::II) return {0.0, 1.0};
  const double lambda = 0.5 * field.n, kappa = kappa_of(material), even = parity(field.n);
  const double scale = amplitude(field) * std::pow(r, lambda - 1.0) / (2.0 * material::shear_modulus(material));
  const HalfAngles angles(theta);
  const Eigen::Vector2d first = angles.multiple(field.n), second = angles.multiple(field.n - 4);
  const double c1 = first[0], s1 = first[1], c2 = second[0], s2 = second[1], l2 = lambda - 2.0;
  Eigen::Vector2d value, turn;  // f(θ) and f'(θ)
  if (field.mode == Mode::I) {
    const double a = kappa + lambda + even, b = kappa - lambda - even;
    value << a * c1 - lambda * c2, b * s1 + lambda * s2;
    turn << -a * lambda * s1 + lambda * l2 * s2, b * lambda * c1 + lambda * l2 * c2;
  } else {
    const double a = kappa + lambda - even, b = kappa - lambda + even;
    value << -a * s1 + lambda * s2, b * c1 + lambda * c2;
    turn << -a * lambda * c1 + lambda * l2 * c2, -b * lambda * s1 - lambda * l2 * s2;
  }
  return scale * (lambda * std::cos(theta) * value - std::sin(theta) * turn);
}

Eigen::VectorXd nodal_displacement(const WilliamsField& field, const material::Isotropic& material,
                                   const sbfem::Boundary& boundary, const TipFrame& frame) {
  const Eigen::Matrix2Xd polar = polar_nodes(boundary, frame);
  Eigen::VectorXd nodal(2 * polar.cols());
  for (Eigen::Index i = 0; i < polar.cols(); ++i) {
    nodal.segment<2>(2 * i) = frame.to_global * displacement(field, material, polar(0, i), polar(1, i));
  }
  return nodal;
}

}  // namespace sunder::fracture
