#include "verification/harness/studies/exact_fields.hpp"

#include <algorithm>

#include "solver/numerics/quadrature.hpp"

namespace sunder::verification {
namespace {

exact::Complex scaled(const PlacedField& field, const Eigen::Vector2d& x) {
  return exact::Complex(x.x() - field.origin.x(), x.y() - field.origin.y()) / field.size;
}

/// Adds visit(η, weight, x) over an edge; weight includes half the length of the edge in the direction (dy, -dx).
template <class Visit>
void along_edge(const Eigen::Vector2d& first, const Eigen::Vector2d& last, int points, const Visit& visit) {
  const numerics::QuadratureRule gauss = numerics::gauss_legendre(points);
  const Eigen::Vector2d half = 0.5 * (last - first);
  const Eigen::Vector2d normal(half.y(), -half.x());
  for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
    const double eta = gauss.points[g];
    visit(eta, gauss.weights[g] * normal, Eigen::Vector2d(0.5 * (1.0 - eta) * first + 0.5 * (1.0 + eta) * last));
  }
}

Eigen::Vector2d traction(const PlacedField& field, const Eigen::Vector2d& x, const Eigen::Vector2d& normal) {
  const exact::Complex t =
      exact::traction(exact::stress(field.field, scaled(field, x)), exact::Complex(normal.x(), normal.y()));
  return {t.real(), t.imag()};
}

}  // namespace

Eigen::Vector2d displacement(const PlacedField& field, const Eigen::Vector2d& x) {
  const exact::Complex u = exact::displacement(field.field, field.body, scaled(field, x)) * field.size;
  return {u.real(), u.imag()};
}

Eigen::VectorXd displacements(const PlacedField& field, const Eigen::Matrix2Xd& nodes) {
  Eigen::VectorXd u(nodes.size());
  for (Eigen::Index i = 0; i < nodes.cols(); ++i)
    u.segment<2>(2 * i) = displacement(field, Eigen::Vector2d(nodes.col(i)));
  return u;
}

Eigen::Vector3d stress(const PlacedField& field, const Eigen::Vector2d& x) {
  const exact::PlaneStress s = exact::stress(field.field, scaled(field, x));
  return {s.xx, s.yy, s.xy};
}

Eigen::VectorXd edge_force(const PlacedField& field, const Eigen::Vector2d& first, const Eigen::Vector2d& last,
                           int order) {
  const numerics::LagrangeBasis basis = numerics::lagrange_basis(numerics::gauss_lobatto(order + 1).points);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * order + 2);
  along_edge(first, last, order + 2, [&](double eta, const Eigen::Vector2d& normal, const Eigen::Vector2d& x) {
    const Eigen::VectorXd N = numerics::values(basis, eta);
    const Eigen::Vector2d t = traction(field, x, normal);
    for (int i = 0; i <= order; ++i) force.segment<2>(2 * i) += N[i] * t;
  });
  return force;
}

double edge_work(const PlacedField& field, const Eigen::Vector2d& first, const Eigen::Vector2d& last, int order) {
  double work = 0.0;
  along_edge(first, last, order + 1, [&](double, const Eigen::Vector2d& normal, const Eigen::Vector2d& x) {
    work += traction(field, x, normal).dot(displacement(field, x));
  });
  return work;
}

exact::PlaneBody exact_body(const material::Isotropic& material) {
  return material.plane == material::Plane::strain
             ? exact::plane_strain(material.youngs_modulus, material.poisson_ratio)
             : exact::plane_stress(material.youngs_modulus, material.poisson_ratio);
}

std::vector<PlacedField> polynomial_fields(const material::Isotropic& material, int degree,
                                           const Eigen::Vector2d& origin, double size) {
  std::vector<PlacedField> fields;
  for (int k = 1; k <= degree; ++k) {
    for (int part = 0; part < 4; ++part) {
      fields.push_back({exact::polynomial_field(k, part, material.youngs_modulus), exact_body(material), origin, size});
    }
  }
  return fields;
}

PlacedField sum_of(const std::vector<PlacedField>& fields) {
  PlacedField sum = fields.front();
  sum.field = {};
  const auto add = [](std::vector<exact::Complex>& to, const std::vector<exact::Complex>& from, double weight) {
    to.resize(std::max(to.size(), from.size()));
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += weight * from[i];
  };
  double weight = 1.0;
  for (const PlacedField& field : fields) {
    add(sum.field.phi, field.field.phi, weight);
    add(sum.field.psi, field.field.psi, weight);
    weight *= -0.9;
  }
  return sum;
}

}  // namespace sunder::verification
