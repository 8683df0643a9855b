#include "solver/sbfem/reference_edge.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::sbfem {

ReferenceEdge reference_edge(int order) {
  if (numerics::planted_fault("sbfem/order-moved-into-its-range")) order = std::clamp(order, 1, 64);
  if (order < 1 || order > 64) {
    throw std::invalid_argument("order of an edge = " + std::to_string(order) + ", accepted is 1 <= order <= 64");
  }
  const auto n = order + 1;
  const int points = numerics::planted_fault("sbfem/one-gauss-point-less") ? order : order + 1;
  const numerics::QuadratureRule gauss = numerics::gauss_legendre(points);
  const numerics::LagrangeBasis basis = numerics::lagrange_basis(numerics::gauss_lobatto(n).points);
  Eigen::MatrixXd N(points, n), dN(points, n);
  for (int g = 0; g < points; ++g) {
    N.row(g) = numerics::values(basis, gauss.points[g]).transpose();
    dN.row(g) = numerics::derivatives(basis, gauss.points[g]).transpose();
  }
  const Eigen::ArrayXd w = gauss.weights, eta = gauss.points;
  const auto weighted = [&](const Eigen::ArrayXd& weight, const Eigen::MatrixXd& right) -> Eigen::MatrixXd {
    return weight.matrix().asDiagonal() * right;
  };
  ReferenceEdge edge{
      .order = order, .points = basis.points, .NN = N.transpose() * weighted(w, N), .dNN = {}, .dNdN = {}};
  edge.dNN[0] = dN.transpose() * weighted(w, N);
  edge.dNN[1] = dN.transpose() * weighted(w * eta, N);
  edge.dNdN[0] = dN.transpose() * weighted(w, dN);
  edge.dNdN[1] = dN.transpose() * weighted(w * eta, dN);
  edge.dNdN[2] = dN.transpose() * weighted(w * eta * eta, dN);
  return edge;
}

}  // namespace sunder::sbfem
