#include "solver/foundation/curved_line.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "solver/numerics/quadrature.hpp"

namespace sunder::foundation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;

/// What the integrands need at one point of the line; the operators are L(v) with v = normal / J and turn / J.
struct LinePoint {
  double weight = 0.0;          ///< J_b dη [m²]
  Eigen::VectorXd shape, rate;  ///< N, N' (p + 1)
  Vector2d normal, turn;        ///< (y_b', -x_b') / J_b and (-y_b, x_b) / J_b [1/m]
  std::vector<Index> nodes;
};

template <class Visit>
void along(const sbfem::Boundary& boundary, const Visit& visit) {
  const Index n = boundary.nodes.cols();
  Index start = 0;
  for (const int p : boundary.orders) {
    const numerics::QuadratureRule gauss = numerics::gauss_legendre(2 * p + 4);
    const numerics::LagrangeBasis basis = numerics::lagrange_basis(numerics::gauss_lobatto(p + 1).points);
    LinePoint at;
    for (int i = 0; i <= p; ++i) at.nodes.push_back((start + i) % n);
    for (Index q = 0; q < gauss.points.size(); ++q) {
      at.shape = numerics::values(basis, gauss.points[q]);
      at.rate = numerics::derivatives(basis, gauss.points[q]);
      Vector2d x = Vector2d::Zero(), slope = Vector2d::Zero();
      for (int i = 0; i <= p; ++i) {
        x += at.shape[i] * boundary.nodes.col(at.nodes[i]);
        slope += at.rate[i] * boundary.nodes.col(at.nodes[i]);
      }
      const double J = x.x() * slope.y() - x.y() * slope.x();
      if (!(J > 0.0)) {
        throw std::invalid_argument("J_b = " + std::to_string(J) + " on the line, accepted is J_b > 0");
      }
      at.weight = gauss.weights[q] * J;
      at.normal = Vector2d(slope.y(), -slope.x()) / J;
      at.turn = Vector2d(-x.y(), x.x()) / J;
      visit(at);
    }
    start += p;
  }
}

sbfem::Coefficients zero(Index size) {
  sbfem::Coefficients c;
  c.E0 = c.E1 = c.E2 = c.M0 = MatrixXd::Zero(size, size);
  return c;
}

}  // namespace

sbfem::Boundary circle(double radius, int elements, int order, bool half) {
  if (!(radius > 0.0) || elements < (half ? 1 : 3) || order < 1 || order > 32) {
    throw std::invalid_argument("circle: accepted are radius > 0, elements >= 3 (half: 1), order 1 ... 32");
  }
  const Eigen::VectorXd points = numerics::gauss_lobatto(order + 1).points;
  sbfem::Boundary boundary;
  boundary.open = half;
  boundary.orders.assign(elements, order);
  boundary.nodes.resize(2, static_cast<Index>(elements) * order + (half ? 1 : 0));
  const double arc = (half ? 1.0 : 2.0) * std::numbers::pi / elements;
  for (Index i = 0; i < boundary.nodes.cols(); ++i) {
    const double angle = -std::numbers::pi + arc * (static_cast<double>(i / order) + 0.5 * (1.0 + points[i % order]));
    boundary.nodes.col(i) = radius * Vector2d(std::cos(angle), std::sin(angle));
  }
  if (half) {  // the ends lie on the free surface, not beside it by a rounding of π
    boundary.nodes(1, 0) = 0.0;
    boundary.nodes(1, boundary.nodes.cols() - 1) = 0.0;
  }
  return boundary;
}

sbfem::Coefficients curved_coefficients(const sbfem::Boundary& boundary, const material::Isotropic& material) {
  material::check(material);
  const Eigen::Matrix3d D = material::elasticity_matrix(material);
  const auto strain = [](const Vector2d& v) {
    Eigen::Matrix<double, 3, 2> L;
    L << v.x(), 0.0, 0.0, v.y(), v.y(), v.x();
    return L;
  };
  sbfem::Coefficients result = zero(2 * boundary.nodes.cols());
  along(boundary, [&](const LinePoint& at) {
    const Eigen::Matrix<double, 3, 2> b1 = strain(at.normal), b2 = strain(at.turn);
    const Eigen::Matrix2d d11 = b1.transpose() * D * b1, d21 = b2.transpose() * D * b1, d22 = b2.transpose() * D * b2;
    for (std::size_t j = 0; j < at.nodes.size(); ++j) {
      for (std::size_t i = 0; i < at.nodes.size(); ++i) {
        const Index r = 2 * at.nodes[i], s = 2 * at.nodes[j];
        result.E0.block<2, 2>(r, s) += at.weight * at.shape[i] * at.shape[j] * d11;
        result.E1.block<2, 2>(r, s) += at.weight * at.rate[i] * at.shape[j] * d21;
        result.E2.block<2, 2>(r, s) += at.weight * at.rate[i] * at.rate[j] * d22;
        result.M0.block<2, 2>(r, s).diagonal().array() += material.density * at.weight * at.shape[i] * at.shape[j];
      }
    }
  });
  return result;
}

sbfem::Coefficients curved_antiplane_coefficients(const sbfem::Boundary& boundary,
                                                  const material::Isotropic& material) {
  material::check(material);
  const double G = material::shear_modulus(material);
  sbfem::Coefficients result = zero(boundary.nodes.cols());
  along(boundary, [&](const LinePoint& at) {
    const double w = G * at.weight;
    for (std::size_t j = 0; j < at.nodes.size(); ++j) {
      for (std::size_t i = 0; i < at.nodes.size(); ++i) {
        const Index r = at.nodes[i], s = at.nodes[j];
        result.E0(r, s) += w * at.normal.squaredNorm() * at.shape[i] * at.shape[j];
        result.E1(r, s) += w * at.turn.dot(at.normal) * at.rate[i] * at.shape[j];
        result.E2(r, s) += w * at.turn.squaredNorm() * at.rate[i] * at.rate[j];
        result.M0(r, s) += material.density * at.weight * at.shape[i] * at.shape[j];
      }
    }
  });
  return result;
}

}  // namespace sunder::foundation
