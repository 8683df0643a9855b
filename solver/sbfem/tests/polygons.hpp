#pragma once
/// Single polygons and exact polynomial fields for the tests of this module.

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/coefficients.hpp"

namespace sunder::sbfem::testing {

/// Nodes of the given orders on the edges between `vertices`, which are relative to the scaling centre.
inline Boundary boundary(const std::vector<Eigen::Vector2d>& vertices, const std::vector<int>& orders,
                         bool open = false) {
  Boundary result;
  result.orders = orders;
  result.open = open;
  int n = open ? 1 : 0;
  for (const int p : orders) n += p;
  result.nodes.resize(2, n);
  int start = 0;
  for (std::size_t e = 0; e < orders.size(); ++e) {
    const Eigen::Vector2d first = vertices[e], last = vertices[(e + 1) % vertices.size()];
    const Eigen::VectorXd eta = numerics::gauss_lobatto(orders[e] + 1).points;
    for (int i = 0; i < orders[e]; ++i) {
      result.nodes.col(start + i) = 0.5 * (1.0 - eta[i]) * first + 0.5 * (1.0 + eta[i]) * last;
    }
    start += orders[e];
  }
  if (open) result.nodes.col(start) = vertices.back();
  return result;
}

inline Boundary boundary(const std::vector<Eigen::Vector2d>& vertices, int order, bool open = false) {
  return boundary(vertices, std::vector<int>(vertices.size() - (open ? 1 : 0), order), open);
}

inline std::vector<Eigen::Vector2d> regular_vertices(int count, double radius = 1.0) {
  std::vector<Eigen::Vector2d> vertices;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3) / count;
    vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return vertices;
}

/// A convex polygon without any symmetry.
inline std::vector<Eigen::Vector2d> irregular_vertices() {
  return {{-0.9, -0.6}, {0.4, -0.8}, {1.1, -0.2}, {0.9, 0.7}, {-0.1, 1.0}, {-0.8, 0.5}};
}

inline std::vector<Eigen::Vector2d> rectangle_vertices(double width, double height) {
  return {{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
}

/// 2 `points` vertices on alternating radii 1 and `inner`.
inline std::vector<Eigen::Vector2d> star_vertices(int points, double inner) {
  std::vector<Eigen::Vector2d> vertices;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * i / points, radius = i % 2 == 0 ? 1.0 : inner;
    vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return vertices;
}

/// Vertices of a notched disc from one face of the notch to the other, `opening` radians of solid symmetric about +x.
inline std::vector<Eigen::Vector2d> notch_vertices(int edges, double opening) {
  std::vector<Eigen::Vector2d> vertices;
  for (int i = 0; i <= edges; ++i) {
    const double angle = opening * (static_cast<double>(i) / edges - 0.5);
    vertices.emplace_back(std::cos(angle), std::sin(angle));
  }
  return vertices;
}

/// Displacement and stress {σ_xx, σ_yy, τ_xy} of a plane elastic field.
struct Field {
  std::function<Eigen::Vector2d(const Eigen::Vector2d&)> displacement;
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> stress;
};

/// The four homogeneous polynomials of degree k that are in equilibrium, from Kolosov's potentials φ = α z^k, ψ = β
/// z^k: 2G u = κ φ - z φ'* - ψ*, σ_xx + σ_yy = 4 Re φ', σ_yy - σ_xx + 2i τ_xy = 2 (z* φ'' + ψ'). 1 <= k; `which` 0 … 3.
inline Field polynomial_field(const material::Isotropic& material, int k, int which) {
  using Complex = std::complex<double>;
  const double G = material::shear_modulus(material), kappa = material::kolosov_constant(material);
  const Complex unit = which % 2 == 0 ? Complex(1.0, 0.0) : Complex(0.0, 1.0);
  const Complex alpha = which < 2 ? unit : 0.0, beta = which < 2 ? 0.0 : unit;
  const auto power = [](Complex z, int exponent) {
    Complex result = 1.0;
    for (int i = 0; i < exponent; ++i) result *= z;
    return result;
  };
  Field field;
  field.displacement = [=](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    const Complex z(x.x(), x.y());
    const Complex slope = alpha * static_cast<double>(k) * power(z, k - 1);
    const Complex u = (kappa * alpha * power(z, k) - z * std::conj(slope) - std::conj(beta * power(z, k))) / (2.0 * G);
    return {u.real(), u.imag()};
  };
  field.stress = [=](const Eigen::Vector2d& x) -> Eigen::Vector3d {
    const Complex z(x.x(), x.y());
    const Complex slope = alpha * static_cast<double>(k) * power(z, k - 1);
    const Complex curvature = k < 2 ? 0.0 : alpha * static_cast<double>(k * (k - 1)) * power(z, k - 2);
    const Complex difference = 2.0 * (std::conj(z) * curvature + beta * static_cast<double>(k) * power(z, k - 1));
    const double sum = 4.0 * slope.real();
    return {0.5 * (sum - difference.real()), 0.5 * (sum + difference.real()), 0.5 * difference.imag()};
  };
  return field;
}

/// Nodal values (2n) of a field; the field's own origin is at `shift` from the scaling centre.
inline Eigen::VectorXd nodal_displacement(const Boundary& boundary, const Field& field,
                                          const Eigen::Vector2d& shift = Eigen::Vector2d::Zero()) {
  Eigen::VectorXd u(2 * boundary.nodes.cols());
  for (Eigen::Index i = 0; i < boundary.nodes.cols(); ++i) {
    u.segment<2>(2 * i) = field.displacement(boundary.nodes.col(i) - shift);
  }
  return u;
}

/// ∫ Nᵀ t ds (2n) of the tractions of a field on the boundary.
inline Eigen::VectorXd nodal_forces(const Boundary& boundary, const Field& field,
                                    const Eigen::Vector2d& shift = Eigen::Vector2d::Zero()) {
  const Eigen::Index n = boundary.nodes.cols();
  Eigen::VectorXd f = Eigen::VectorXd::Zero(2 * n);
  Eigen::Index start = 0;
  for (const int p : boundary.orders) {
    const auto gauss = numerics::gauss_legendre(p + 2);
    const auto basis = numerics::lagrange_basis(numerics::gauss_lobatto(p + 1).points);
    const Eigen::Vector2d first = boundary.nodes.col(start), last = boundary.nodes.col((start + p) % n);
    const Eigen::Vector2d half = 0.5 * (last - first);
    for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
      const double eta = gauss.points[g];
      const Eigen::Vector2d x = 0.5 * (1.0 - eta) * first + 0.5 * (1.0 + eta) * last - shift;
      const Eigen::Vector3d s = field.stress(x);
      // n ds = (dy, -dx)
      const Eigen::Vector2d t(s[0] * half.y() - s[2] * half.x(), s[2] * half.y() - s[1] * half.x());
      const Eigen::VectorXd N = numerics::values(basis, eta);
      for (int i = 0; i <= p; ++i) f.segment<2>(2 * ((start + i) % n)) += gauss.weights[g] * N[i] * t;
    }
    start += p;
  }
  return f;
}

}  // namespace sunder::sbfem::testing
