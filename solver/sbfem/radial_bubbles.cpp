#include "solver/sbfem/radial_bubbles.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <stdexcept>
#include <vector>

namespace sunder::sbfem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Stiffness and mass among the bubbles w_k, and mass between them and the boundary, powers 2 … m side by side.
struct Monomials {
  MatrixXd stiffness, mass, coupling;
};

Monomials monomials(const Coefficients& c, const PolygonSolution& solution, const MatrixXd& static_mass, int order) {
  const Index n = c.E0.rows();
  const Index powers = order - 1;
  Monomials bubbles{MatrixXd(powers * n, powers * n), MatrixXd(powers * n, powers * n), MatrixXd(n, powers * n)};

  std::vector<MatrixXd> mixed;  // m(ξ^A ·, ξ^l ·)
  for (Index l = 2; l <= order; ++l) {
    MatrixXd shifted = solution.A.transpose();
    shifted.diagonal().array() += static_cast<double>(l + 2);
    mixed.push_back(shifted.partialPivLu().solve(c.M0));
    bubbles.coupling.middleCols((l - 2) * n, n) = mixed.back() - static_mass;
  }
  for (Index k = 2; k <= order; ++k) {
    for (Index l = 2; l <= order; ++l) {
      const double dk = static_cast<double>(k), dl = static_cast<double>(l);
      bubbles.stiffness.block((k - 2) * n, (l - 2) * n, n, n) =
          (dk * dl * c.E0 + dk * c.E1.transpose() + dl * c.E1 + c.E2) / (dk + dl) - solution.K;
      bubbles.mass.block((k - 2) * n, (l - 2) * n, n, n) =
          c.M0 / (dk + dl + 2.0) - mixed[k - 2].transpose() - mixed[l - 2] + static_mass;
    }
  }
  return bubbles;
}

/// Columns that span the range of a positive semidefinite matrix and make it the identity.
MatrixXd whitened_range(const MatrixXd& stiffness) {
  const VectorXd scale = stiffness.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scale.asDiagonal() * stiffness * scale.asDiagonal());
  const VectorXd& values = eigen.eigenvalues();
  // Equilibrium polynomials have zero energy up to round-off of the difference with K, a few hundred eps of the
  // largest; true bubbles stay above 1e-9 of it up to highest_interior_order.
  const double smallest_kept = 1e-10 * values[values.size() - 1];
  Index dropped = 0;
  while (dropped < values.size() && values[dropped] <= smallest_kept) ++dropped;
  const Index kept = values.size() - dropped;
  return scale.asDiagonal() * eigen.eigenvectors().rightCols(kept) *
         values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

RadialBubbles radial_bubbles(const Coefficients& coefficients, const PolygonSolution& solution, const MatrixXd& mass,
                             int interior_order) {
  if (interior_order < 2 || interior_order > highest_interior_order) {
    throw std::invalid_argument("interior_order " + std::to_string(interior_order) + " must lie in 2 … " +
                                std::to_string(highest_interior_order));
  }
  const Monomials bubbles = monomials(coefficients, solution, mass, interior_order);
  const MatrixXd whitening = whitened_range(0.5 * (bubbles.stiffness + bubbles.stiffness.transpose()));
  const MatrixXd white_mass = whitening.transpose() * bubbles.mass * whitening;  // eigenvalues 1 / ω²
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (white_mass + white_mass.transpose()));
  const VectorXd nu = eigen.eigenvalues().reverse();
  RadialBubbles result;
  result.omega_squared = nu.cwiseInverse();
  result.coupling = bubbles.coupling * whitening * eigen.eigenvectors().rowwise().reverse() *
                    nu.cwiseSqrt().cwiseInverse().asDiagonal();
  return result;
}

}  // namespace sunder::sbfem
