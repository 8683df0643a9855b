#include "solver/sbfem/coefficients.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/reference_edge.hpp"

namespace sunder::sbfem {
namespace {

/// L(v) = [v₁ 0; 0 v₂; v₂ v₁], so that b1 = L(a) / J_b and b2 = L(c) / J_b with a = (y_b', -x_b'), c = (-y_b, x_b).
Eigen::Matrix<double, 3, 2> strain_operator(const Eigen::Vector2d& v) {
  Eigen::Matrix<double, 3, 2> L;
  L << v.x(), 0.0, 0.0, v.y(), v.y(), v.x();
  return L;
}

void check(const Boundary& boundary) {
  const auto n = boundary.nodes.cols();
  const int sum = std::accumulate(boundary.orders.begin(), boundary.orders.end(), 0);
  if (boundary.orders.empty() || sum + (boundary.open ? 1 : 0) != n) {
    throw std::invalid_argument("boundary: the orders sum to " + std::to_string(sum) + " for " + std::to_string(n) +
                                (boundary.open ? " nodes, accepted is nodes - 1 (open)" : " nodes, accepted is nodes"));
  }
}

}  // namespace

Coefficients coefficients(const Boundary& boundary, const material::Isotropic& material) {
  check(boundary);
  material::check(material);
  const auto n = boundary.nodes.cols();
  const Eigen::Matrix3d D = material::elasticity_matrix(material);
  const bool e1_transposed = numerics::planted_fault("sbfem/e1-transposed");
  const double sense = numerics::planted_fault("sbfem/edge-jacobian-sign") ? -1.0 : 1.0;

  Coefficients result;
  result.E0 = result.E1 = result.E2 = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  if (material.density > 0.0) result.M0 = Eigen::MatrixXd::Zero(2 * n, 2 * n);

  std::map<int, ReferenceEdge> references;
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < boundary.orders.size(); ++e) {
    const int p = boundary.orders[e];
    auto found = references.find(p);
    if (found == references.end()) found = references.emplace(p, reference_edge(p)).first;
    const ReferenceEdge& reference = found->second;

    const Eigen::Vector2d first = boundary.nodes.col(start), last = boundary.nodes.col((start + p) % n);
    const Eigen::Vector2d half = 0.5 * (last - first), middle = 0.5 * (first + last);
    // x_b × x_b' is the same all along a straight edge; from one end no digit is lost on a short edge.
    const double J = first.x() * half.y() - first.y() * half.x();
    if (!(J > 0.0) && !numerics::planted_fault("sbfem/backward-edge-accepted")) {
      std::ostringstream message;
      message << "edge " << e << " of the polygon, from (" << first.x() << ", " << first.y() << ") to (" << last.x()
              << ", " << last.y() << ") relative to the scaling centre: J_b = " << J
              << ", accepted is J_b > 0 (the scaling centre sees the edge from inside)";
      throw std::invalid_argument(message.str());
    }
    // a is constant and c(η) = c_m - η a.
    const Eigen::Matrix<double, 3, 2> La = strain_operator({half.y(), -half.x()});
    const Eigen::Matrix<double, 3, 2> Lc = strain_operator({-middle.y(), sense * middle.x()});
    const Eigen::Matrix2d aa = La.transpose() * D * La / J, ca = Lc.transpose() * D * La / J;
    const Eigen::Matrix2d cc = Lc.transpose() * D * Lc / J, ca_ac = ca + ca.transpose();
    for (int j = 0; j <= p; ++j) {
      const Eigen::Index column = 2 * ((start + j) % n);
      for (int i = 0; i <= p; ++i) {
        const Eigen::Index row = 2 * ((start + i) % n);
        result.E0.block<2, 2>(row, column) += reference.NN(i, j) * aa;
        result.E1.block<2, 2>(row, column) += reference.dNN[0](i, j) * ca - reference.dNN[1](i, j) * aa;
        result.E2.block<2, 2>(row, column) +=
            reference.dNdN[0](i, j) * cc - reference.dNdN[1](i, j) * ca_ac + reference.dNdN[2](i, j) * aa;
        if (material.density > 0.0) {
          result.M0.block<2, 2>(row, column).diagonal().array() += material.density * J * reference.NN(i, j);
        }
      }
    }
    start += p;
  }
  if (e1_transposed) result.E1.transposeInPlace();
  return result;
}

}  // namespace sunder::sbfem
