#include "solver/sbfem/mean_strain.hpp"

#include <Eigen/LU>
#include <stdexcept>

#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/particular.hpp"

namespace sunder::sbfem {
namespace {

using Eigen::Vector2d;

/// Adds the share of the displacement of node `node` times n ds, `normal`, to ∮ sym(u ⊗ n) ds.
void add(const Vector2d& normal, Eigen::Index node, Eigen::Matrix3Xd& integral) {
  integral(0, 2 * node) += normal.x();
  integral(1, 2 * node + 1) += normal.y();
  integral(2, 2 * node) += normal.y();
  integral(2, 2 * node + 1) += normal.x();
}

/// n times length of a straight piece with the body on its left.
Vector2d outward(const Vector2d& along) {
  return {along.y(), -along.x()};
}

struct OverEdges {
  Eigen::Matrix3Xd integral;  ///< ∮ sym(u ⊗ n) ds over the edges, from u_b
  double area = 0.0;          ///< of the polygon [m²]
};

OverEdges over_edges(const Boundary& boundary) {
  const Eigen::Index n = boundary.nodes.cols();
  OverEdges sum{.integral = Eigen::Matrix3Xd::Zero(3, 2 * n)};
  Eigen::Index start = 0;
  for (const int order : boundary.orders) {
    const Vector2d first = boundary.nodes.col(start), last = boundary.nodes.col((start + order) % n);
    // The rule on the edge's own nodes has 2 p - 1 >= p, so it integrates the shape functions exactly.
    const Eigen::VectorXd weights = order == 1 ? Eigen::VectorXd::Ones(2) : numerics::gauss_lobatto(order + 1).weights;
    for (Eigen::Index i = 0; i <= order; ++i) {
      add(0.5 * weights[i] * outward(last - first), (start + i) % n, sum.integral);
    }
    sum.area += 0.5 * (first.x() * last.y() - first.y() * last.x());
    start += order;
  }
  return sum;
}

}  // namespace

Eigen::Matrix3Xd mean_strain(const Boundary& boundary) {
  if (boundary.open) throw std::invalid_argument("boundary: open, accepted is a closed polygon");
  const OverEdges edges = over_edges(boundary);
  return edges.integral / edges.area;
}

TipField tip_field(const Boundary& boundary, const Coefficients& coefficients, const PolygonSolution& solution,
                   std::span<const RadialLoad> loads) {
  if (!boundary.open) throw std::invalid_argument("boundary: closed, accepted is a crack polygon");
  const Eigen::Index n = boundary.nodes.cols();
  const OverEdges edges = over_edges(boundary);

  // The faces, from the mean displacement on the rays of their two nodes: from the tip to the first, and back.
  Eigen::Matrix3Xd over_faces = Eigen::Matrix3Xd::Zero(3, 2 * n);
  add(outward(boundary.nodes.col(0)), 0, over_faces);
  add(outward(-boundary.nodes.col(n - 1)), n - 1, over_faces);
  Eigen::MatrixXd along = solution.A;
  along.diagonal().array() += 1.0;
  const Eigen::Matrix3Xd of_homogeneous =
      along.transpose().partialPivLu().solve(over_faces.transpose()).transpose() / edges.area;

  // u(0) = L u_b with L A = 0 and L T = I, T the two translations: (Aᵀ + T Tᵀ / n) Lᵀ = T / n.
  Eigen::MatrixX2d translations = Eigen::MatrixX2d::Zero(2 * n, 2);
  for (Eigen::Index i = 0; i < 2 * n; ++i) translations(i, i % 2) = 1.0;
  const double share = 1.0 / static_cast<double>(n);
  const Eigen::MatrixXd bordered = solution.A.transpose() + share * translations * translations.transpose();

  TipField field;
  field.mean_strain = edges.integral / edges.area + of_homogeneous;
  field.tip = bordered.partialPivLu().solve(share * translations).transpose();
  for (const ParticularSolution& part : particular_solutions(coefficients, solution, loads)) {
    field.mean_strain_of_loads += over_faces * part.d / (edges.area * (part.power + 2.0)) - of_homogeneous * part.d;
    field.tip_of_loads -= field.tip * part.d;
  }
  return field;
}

}  // namespace sunder::sbfem
