#include "solver/sbfem/edge_element.hpp"

#include <map>

namespace sunder::sbfem {

std::vector<EdgeElement> edge_elements(const Boundary& boundary) {
  std::map<int, numerics::LagrangeBasis> bases;
  std::vector<EdgeElement> edges;
  edges.reserve(boundary.orders.size());
  Eigen::Index start = 0;
  for (const int p : boundary.orders) {
    auto found = bases.find(p);
    if (found == bases.end()) {
      found = bases.emplace(p, numerics::lagrange_basis(numerics::gauss_lobatto(p + 1).points)).first;
    }
    EdgeElement edge{.first = {}, .last = {}, .nodes = {}, .basis = found->second};
    for (int i = 0; i <= p; ++i) edge.nodes.push_back((start + i) % boundary.nodes.cols());
    edge.first = boundary.nodes.col(edge.nodes.front());
    edge.last = boundary.nodes.col(edge.nodes.back());
    edges.push_back(std::move(edge));
    start += p;
  }
  return edges;
}

EdgePoint at(const EdgeElement& edge, double eta) {
  EdgePoint point;
  point.position = 0.5 * ((1.0 - eta) * edge.first + (1.0 + eta) * edge.last);
  point.tangent = 0.5 * (edge.last - edge.first);
  // x_b × x_b' is constant on a straight edge; taken at its first node it keeps its digits on a short edge.
  point.jacobian = edge.first.x() * point.tangent.y() - edge.first.y() * point.tangent.x();
  point.shape = numerics::values(edge.basis, eta);
  point.derivative = numerics::derivatives(edge.basis, eta);
  const Eigen::Vector2d a = point.tangent / point.jacobian, c = point.position / point.jacobian;
  point.b1 << a.y(), 0.0, 0.0, -a.x(), -a.x(), a.y();
  point.b2 << -c.y(), 0.0, 0.0, c.x(), c.x(), -c.y();
  return point;
}

Eigen::Vector2d interpolate(const EdgeElement& edge, const Eigen::VectorXd& shape, const Eigen::VectorXd& nodal) {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  for (int i = 0; i <= edge.order(); ++i) value += shape[i] * nodal.segment<2>(2 * edge.nodes[i]);
  return value;
}

}  // namespace sunder::sbfem
