#include "solver/fracture/singular_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <vector>

#include "solver/fracture/williams.hpp"

namespace sunder::fracture {
namespace {

constexpr double tolerance = 1e-12;  // ‖A V - V S‖ <= tolerance · ‖A‖, ‖V‖ = 1
constexpr int most_iterations = 40;

Eigen::MatrixX2d orthonormal(const Eigen::MatrixX2d& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixX2d> qr(columns);
  return qr.householderQ() * Eigen::MatrixX2d::Identity(columns.rows(), 2);
}

struct Pair {
  ModeGroup group;
  int iterations = 0;
  bool converged = false;
};

/// Two-sided inverse iteration for the two exponents nearest to `shift`, both sides from one factorisation.
Pair invariant_pair(const Eigen::MatrixXd& A, double shift, const Eigen::MatrixX2d& right_start,
                    const Eigen::MatrixX2d& left_start) {
  Eigen::MatrixXd shifted = A;
  shifted.diagonal().array() -= shift;
  const Eigen::PartialPivLU<Eigen::MatrixXd> factor(shifted);
  Pair pair;
  Eigen::MatrixX2d V = orthonormal(right_start), W = orthonormal(left_start);
  const double scale = A.norm();
  bool right_done = false, left_done = false;
  while (pair.iterations < most_iterations && !(right_done && left_done)) {
    ++pair.iterations;
    // With X = (A - shift)⁻¹ V = Q R the new residual A Q - Q S = (V - Q Qᵀ V) R⁻¹ costs no product with A.
    const auto advance = [&](Eigen::MatrixX2d& basis, const Eigen::MatrixX2d& solved) {
      const Eigen::MatrixX2d Q = orthonormal(solved);
      const Eigen::Matrix2d R = Q.transpose() * solved;
      const Eigen::MatrixX2d defect = (basis - Q * (Q.transpose() * basis)) * R.inverse();
      basis = Q;
      return defect.norm() <= tolerance * scale;
    };
    if (!right_done) right_done = advance(V, factor.solve(V));
    if (!left_done) left_done = advance(W, factor.transpose().solve(W));
  }
  const Eigen::Matrix2d gram = W.transpose() * V;
  pair.converged = right_done && left_done && V.allFinite() && W.allFinite() && std::abs(gram.determinant()) > 1e-10;
  if (!pair.converged) return pair;
  pair.group.right = V;
  pair.group.left = W * gram.inverse().transpose();
  pair.group.matrix = V.transpose() * (A * V);  // V is orthonormal: the S of least residual
  const Eigen::Vector2cd exponents = pair.group.matrix.eigenvalues();
  pair.group.exponents = {exponents[0], exponents[1]};
  return pair;
}

bool within(const ModeGroup& group, double low, double high) {
  for (const auto& exponent : group.exponents) {
    if (!(exponent.real() > low && exponent.real() < high)) return false;
  }
  return true;
}

}  // namespace

SingularModes singular_modes(const sbfem::Boundary& boundary, const material::Isotropic& material,
                             const sbfem::Coefficients& coefficients, const sbfem::PolygonSolution& solution) {
  const TipFrame frame = tip_frame(boundary);
  const auto nodal = [&](int n) {
    Eigen::MatrixX2d fields(2 * boundary.nodes.cols(), 2);
    fields << nodal_displacement({n, Mode::I}, material, boundary, frame),
        nodal_displacement({n, Mode::II}, material, boundary, frame);
    for (int j = 0; j < 2; ++j) fields.col(j).normalize();
    return fields;
  };
  // A left vector is E0 (λ + A) ψ with ψ the discrete exterior field r^-λ, since L(-λ) ψ = 0 reads
  // ψᵀ (λ + Aᵀ) E0 (λ - A) = 0; Williams' own r^-λ is a start with an error of the discretisation.
  const auto left = [&](double lambda, const Eigen::MatrixX2d& exterior) -> Eigen::MatrixX2d {
    return coefficients.E0 * (lambda * exterior + solution.A * exterior);
  };
  SingularModes modes;
  // The shifts stand a little beside ½ and 1, where the factorisation would be singular, and far from all other
  // exponents.
  Pair singular = invariant_pair(solution.A, 0.5 - 1e-3, nodal(1), left(0.5, nodal(-1)));
  Pair unit = invariant_pair(solution.A, 1.0 + 1e-3, nodal(2), left(1.0, nodal(-2)));
  if (!(singular.converged && within(singular.group, 0.02, 0.98) && unit.converged && within(unit.group, 0.98, 1.02))) {
    modes.status = ModeStatus::by_schur;
    std::vector<double> in_window;
    const Eigen::VectorXcd exponents = solution.A.eigenvalues();
    for (const auto& exponent : exponents) {
      if (exponent.real() > 0.02 && exponent.real() < 0.98) in_window.push_back(exponent.real());
    }
    if (in_window.size() == 2) {
      singular = invariant_pair(solution.A, 0.5 * (in_window[0] + in_window[1]) - 1e-3, nodal(1), left(0.5, nodal(-1)));
    }
    if (in_window.size() != 2 || !singular.converged || !unit.converged || !within(singular.group, 0.02, 0.98)) {
      modes.status = ModeStatus::not_a_crack;
      return modes;
    }
  }
  modes.singular = singular.group;
  modes.unit = unit.group;
  modes.iterations = std::max(singular.iterations, unit.iterations);
  return modes;
}

}  // namespace sunder::fracture
