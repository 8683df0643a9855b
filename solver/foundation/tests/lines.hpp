#pragma once
/// Lines that several foundation tests share, and sums over them.

#include "solver/foundation/unbounded_domain.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::foundation {

inline constexpr material::Isotropic unit_rock{
    .youngs_modulus = 2.5, .poisson_ratio = 0.25, .density = 1.0};  // G = ρ = c_s = 1

/// Left side, bottom and right side of a block 2 half_width x depth below the free surface; `across` elements along the
/// bottom, `down` along each side.
inline sbfem::Boundary block_line(double half_width, double depth, int across, int down, int order) {
  const Eigen::VectorXd points = numerics::gauss_lobatto(order + 1).points;
  const Eigen::Vector2d corners[] = {{-half_width, 0}, {-half_width, -depth}, {half_width, -depth}, {half_width, 0}};
  const int elements[] = {down, across, down};
  std::vector<Eigen::Vector2d> nodes;
  sbfem::Boundary line;
  line.open = true;
  for (int side = 0; side < 3; ++side) {
    for (int e = 0; e < elements[side]; ++e) {
      line.orders.push_back(order);
      for (int i = 0; i < order; ++i) {
        const double part = (e + 0.5 * (1.0 + points[i])) / elements[side];
        nodes.push_back(corners[side] + part * (corners[side + 1] - corners[side]));
      }
    }
  }
  nodes.push_back(corners[3]);
  line.nodes.resize(2, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) line.nodes.col(static_cast<Eigen::Index>(i)) = nodes[i];
  return line;
}

/// Force in direction `component` for a rigid translation in it.
template <class Matrix>
typename Matrix::Scalar translation(const Matrix& matrix, int component) {
  typename Matrix::Scalar sum = 0.0;
  for (Eigen::Index j = component; j < matrix.cols(); j += 2)
    for (Eigen::Index i = component; i < matrix.rows(); i += 2) sum += matrix(i, j);
  return sum;
}

}  // namespace sunder::foundation
