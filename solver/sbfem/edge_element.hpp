#pragma once
/// One straight edge of a polygon as the scaled boundary sees it: shape functions and the operators that make strains.

#include <Eigen/Core>
#include <vector>

#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/coefficients.hpp"

namespace sunder::sbfem {

struct EdgeElement {
  Eigen::Vector2d first, last;      ///< end points relative to the scaling centre [m]
  std::vector<Eigen::Index> nodes;  ///< (p + 1) nodes of the boundary, in order
  numerics::LagrangeBasis basis;    ///< on the Gauss-Lobatto points of [-1, 1]

  int order() const { return static_cast<int>(nodes.size()) - 1; }
};

/// All edges of a boundary, in order.
std::vector<EdgeElement> edge_elements(const Boundary& boundary);

/// What an edge knows at one of its points. With u(ξ) and u,ξ on the nodes: ε = b1 u,ξ(η) + b2 u'(η) / ξ.
struct EdgePoint {
  Eigen::Vector2d position;            ///< x_b [m]
  Eigen::Vector2d tangent;             ///< x_b' = dx_b/dη [m]
  double jacobian = 0.0;               ///< J_b = x_b y_b' - y_b x_b' [m²]
  Eigen::VectorXd shape, derivative;   ///< N and N' (p + 1)
  Eigen::Matrix<double, 3, 2> b1, b2;  ///< [1/m]
};

EdgePoint at(const EdgeElement& edge, double eta);

/// Σ N_i u_i at a point of an edge, from values (2n) on the boundary's nodes; with `point.derivative` for `shape`, Σ
/// N'_i u_i.
Eigen::Vector2d interpolate(const EdgeElement& edge, const Eigen::VectorXd& shape, const Eigen::VectorXd& nodal);

}  // namespace sunder::sbfem
