#include "solver/sbfem/loads.hpp"

#include <Eigen/LU>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::sbfem {
namespace {

/// Inward normal times length of the edge from a to b: the body lies to its left.
Eigen::Vector2d inward(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return {a.y() - b.y(), b.x() - a.x()};
}

Eigen::Matrix2Xd nodes_of_edge(const Boundary& boundary, int edge) {
  const int edges = static_cast<int>(boundary.orders.size());
  if (edge < 0 || edge >= edges) {
    throw std::invalid_argument("edge = " + std::to_string(edge) + ", accepted is 0 <= edge < " +
                                std::to_string(edges));
  }
  Eigen::Index start = 0;
  for (int e = 0; e < edge; ++e) start += boundary.orders[e];
  Eigen::Matrix2Xd nodes(2, boundary.orders[edge] + 1);
  for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
    nodes.col(i) = boundary.nodes.col((start + i) % boundary.nodes.cols());
  }
  return nodes;
}

Eigen::VectorXd on_boundary(const Boundary& boundary, int edge, const Eigen::VectorXd& load) {
  Eigen::Index start = 0;
  for (int e = 0; e < edge; ++e) start += boundary.orders[e];
  Eigen::VectorXd all = Eigen::VectorXd::Zero(2 * boundary.nodes.cols());
  for (Eigen::Index i = 0; i < load.size() / 2; ++i) {
    all.segment<2>(2 * ((start + i) % boundary.nodes.cols())) += load.segment<2>(2 * i);
  }
  return all;
}

/// Σ columns[k] sᵏ by Horner's rule.
Eigen::Vector2d polynomial(const Eigen::Matrix2Xd& columns, double s) {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  for (Eigen::Index k = columns.cols() - 1; k >= 0; --k) value = s * value + columns.col(k);
  return value;
}

}  // namespace

RadialLoad body_force(const Boundary& boundary, const Eigen::Vector2d& force_density) {
  const Eigen::Index n = boundary.nodes.cols();
  RadialLoad load{.power = numerics::planted_fault("sbfem/body-force-power") ? 0 : 1,
                  .density = Eigen::VectorXd::Zero(2 * n)};
  Eigen::Index start = 0;
  for (const int p : boundary.orders) {
    const Eigen::Vector2d first = boundary.nodes.col(start), last = boundary.nodes.col((start + p) % n);
    const Eigen::Vector2d half = 0.5 * (last - first);
    const double jacobian = first.x() * half.y() - first.y() * half.x();
    // ∫ N_i dη is the weight of Gauss-Lobatto point i: the rule is exact to degree 2p - 1 >= p.
    const Eigen::VectorXd weights = numerics::gauss_lobatto(p + 1).weights;
    for (int i = 0; i <= p; ++i) {
      load.density.segment<2>(2 * ((start + i) % n)) += weights[i] * jacobian * force_density;
    }
    start += p;
  }
  return load;
}

std::vector<RadialLoad> crack_face_pressure(const Boundary& boundary, std::span<const double> pressure) {
  if (!boundary.open)
    throw std::invalid_argument("crack_face_pressure: the polygon is closed, accepted is an open one");
  const double sign = numerics::planted_fault("sbfem/face-pressure-sign") ? -1.0 : 1.0;
  const Eigen::Index n = boundary.nodes.cols();
  const Eigen::Vector2d tip = Eigen::Vector2d::Zero();
  // The outline runs tip → lower mouth → boundary → upper mouth → tip, with the body on its left throughout.
  const Eigen::Vector2d on_lower = inward(tip, boundary.nodes.col(0));
  const Eigen::Vector2d on_upper = inward(boundary.nodes.col(n - 1), tip);
  std::vector<RadialLoad> loads;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    RadialLoad load{.power = static_cast<int>(k), .density = Eigen::VectorXd::Zero(2 * n)};
    load.density.head<2>() = sign * pressure[k] * on_lower;
    load.density.tail<2>() = sign * pressure[k] * on_upper;
    loads.push_back(std::move(load));
  }
  return loads;
}

Eigen::VectorXd load_vector(const PolygonSolution& solution, const RadialLoad& load) {
  if (load.power < 0) {
    throw std::invalid_argument("power = " + std::to_string(load.power) + ", accepted is power >= 0");
  }
  Eigen::MatrixXd shifted = solution.A.transpose();
  shifted.diagonal().array() += load.power + 1.0;
  return shifted.partialPivLu().solve(load.density);
}

Eigen::VectorXd load_vector(const PolygonSolution& solution, std::span<const RadialLoad> loads) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(solution.K.rows());
  for (const RadialLoad& load : loads) sum += load_vector(solution, load);
  return sum;
}

Eigen::VectorXd edge_traction(const Eigen::Matrix2Xd& nodes, const Eigen::Matrix2Xd& traction) {
  const Eigen::Index p = nodes.cols() - 1;
  if (p < 1) throw std::invalid_argument("edge_traction: an edge has at least 2 nodes");
  const double half_length = 0.5 * (nodes.col(p) - nodes.col(0)).norm();
  // N has degree p and the traction degree cols - 1: a rule of m points is exact to 2m - 1.
  const numerics::QuadratureRule gauss = numerics::gauss_legendre(static_cast<int>((p + traction.cols()) / 2 + 1));
  const numerics::LagrangeBasis basis =
      numerics::lagrange_basis(numerics::gauss_lobatto(static_cast<int>(p + 1)).points);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * (p + 1));
  for (Eigen::Index g = 0; g < gauss.points.size(); ++g) {
    const Eigen::VectorXd shape = numerics::values(basis, gauss.points[g]);
    const Eigen::Vector2d t = half_length * gauss.weights[g] * polynomial(traction, 0.5 * (1.0 + gauss.points[g]));
    for (Eigen::Index i = 0; i <= p; ++i) load.segment<2>(2 * i) += shape[i] * t;
  }
  return load;
}

Eigen::VectorXd edge_pressure(const Eigen::Matrix2Xd& nodes, std::span<const double> pressure) {
  const Eigen::Vector2d first = nodes.col(0), last = nodes.col(nodes.cols() - 1);
  const Eigen::Vector2d normal = inward(first, last).normalized();
  const Eigen::Map<const Eigen::RowVectorXd> powers(pressure.data(), static_cast<Eigen::Index>(pressure.size()));
  return edge_traction(nodes, Eigen::Matrix2Xd(normal * powers));
}

Eigen::VectorXd edge_traction(const Boundary& boundary, int edge, const Eigen::Matrix2Xd& traction) {
  return on_boundary(boundary, edge, edge_traction(nodes_of_edge(boundary, edge), traction));
}

Eigen::VectorXd edge_pressure(const Boundary& boundary, int edge, std::span<const double> pressure) {
  return on_boundary(boundary, edge, edge_pressure(nodes_of_edge(boundary, edge), pressure));
}

std::vector<double> restrict_polynomial(std::span<const double> coefficients, double from, double to) {
  // Horner's rule on polynomials: multiply by (from + (to - from) t), add the next coefficient.
  std::vector<double> result;
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    std::vector<double> next(result.empty() ? 1 : result.size() + 1, 0.0);
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i] += from * result[i];
      next[i + 1] += (to - from) * result[i];
    }
    next[0] += coefficients[k];
    result = std::move(next);
  }
  return result;
}

}  // namespace sunder::sbfem
