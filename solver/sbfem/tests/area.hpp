#pragma once
/// Test support: a polygon, fields on its nodes, and integrals over its area.

#include <Eigen/Core>
#include <vector>

#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/coefficients.hpp"
#include "solver/sbfem/tests/polygons.hpp"

namespace sunder::sbfem::testing {

/// A pentagon without symmetry, its centre away from its centroid.
inline std::vector<Eigen::Vector2d> pentagon() {
  return {{1.1, -0.4}, {0.8, 0.9}, {-0.2, 1.2}, {-0.9, 0.1}, {-0.3, -1.0}};
}

/// Nodal values (2n) of a displacement field.
template <typename Field>
Eigen::VectorXd nodal(const Boundary& boundary, const Field& field) {
  Eigen::VectorXd values(boundary.nodes.size());
  for (Eigen::Index i = 0; i < boundary.nodes.cols(); ++i) {
    values.segment<2>(2 * i) = field(Eigen::Vector2d(boundary.nodes.col(i)));
  }
  return values;
}

/// ∫ f dA over the polygon, exact for polynomials of degree <= 12.
template <typename Function>
double integral(const std::vector<Eigen::Vector2d>& corners, const Function& f) {
  const numerics::QuadratureRule gauss = numerics::gauss_legendre(8);
  double sum = 0.0;
  for (std::size_t e = 0; e < corners.size(); ++e) {
    const Eigen::Vector2d a = corners[e], b = corners[(e + 1) % corners.size()];
    const double twice_area = a.x() * b.y() - a.y() * b.x();
    for (Eigen::Index i = 0; i < 8; ++i) {
      for (Eigen::Index j = 0; j < 8; ++j) {
        const double xi = 0.5 * (1.0 + gauss.points[i]), s = 0.5 * (1.0 + gauss.points[j]);
        sum += 0.25 * gauss.weights[i] * gauss.weights[j] * xi * twice_area *
               f(Eigen::Vector2d(xi * ((1.0 - s) * a + s * b)));
      }
    }
  }
  return sum;
}

}  // namespace sunder::sbfem::testing
