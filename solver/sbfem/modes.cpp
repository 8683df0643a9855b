#include "solver/sbfem/modes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>

#include "solver/numerics/ordered_schur.hpp"

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;

struct ReducedModes {
  MatrixXd S, Vu, Vq;
  PolygonStatus status = PolygonStatus::not_converged;
};

/// The half of the Hamiltonian's invariant subspaces with Re λ < 0.
ReducedModes reduced_modes(const ReducedPolygon& polygon) {
  const auto m = polygon.E0.rows();
  ReducedModes result;
  const Eigen::LLT<MatrixXd> E0(polygon.E0);
  if (E0.info() != Eigen::Success) {
    result.status = PolygonStatus::not_positive_definite;
    return result;
  }
  const MatrixXd GF = E0.solve(polygon.F), G = E0.solve(MatrixXd::Identity(m, m));
  MatrixXd Z(2 * m, 2 * m);
  Z << GF, -G, polygon.F.transpose() * GF - polygon.E2, -GF.transpose();

  const Eigen::VectorXd balance = numerics::balance(Z);
  const numerics::OrderedSchur schur = numerics::ordered_schur(Z, [](double real, double) { return real < 0.0; });
  // Exactly half of the eigenvalues of a Hamiltonian decay; any other count says that the split is not to be trusted.
  if (schur.status != numerics::SchurStatus::converged || schur.selected != m) return result;
  const MatrixXd V = balance.asDiagonal() * schur.U.leftCols(m);
  result.S = schur.T.topLeftCorner(m, m);
  result.Vu = V.topRows(m);
  result.Vq = V.bottomRows(m);
  result.status = PolygonStatus::converged;
  return result;
}

}  // namespace

RiccatiSolution schur_stiffness(const ReducedPolygon& polygon) {
  RiccatiSolution result;
  const ReducedModes half = reduced_modes(polygon);
  result.positive_definite = half.status != PolygonStatus::not_positive_definite;
  result.converged = half.status == PolygonStatus::converged;
  const auto m = polygon.E0.rows();
  if (!result.converged) {
    result.K = MatrixXd::Zero(m, m);
    return result;
  }
  const MatrixXd transposed = half.Vu.transpose().partialPivLu().solve(half.Vq.transpose());
  result.asymmetry = (transposed - transposed.transpose()).norm() / transposed.norm();
  result.K = 0.5 * (transposed + transposed.transpose());
  return result;
}

ModalSolution modes(const Coefficients& coefficients) {
  const auto N = coefficients.E0.rows(), m = N - 2;
  ModalSolution result;
  result.S = MatrixXd::Zero(N, N);
  result.Vu = result.Vq = MatrixXd::Constant(N, N, std::numeric_limits<double>::quiet_NaN());
  const ReducedPolygon polygon = reduce(coefficients);
  result.status = PolygonStatus::not_positive_definite;
  if (!polygon.valid) return result;
  const ReducedModes half = reduced_modes(polygon);
  result.status = half.status;
  if (half.status != PolygonStatus::converged) return result;

  result.S.topLeftCorner(m, m) = half.S;
  // v = Vu ξ^(-S) c has v' = -Vu S ξ^(-S) c and moves the translations by w' = -translation_rate {v'; v}; with
  // w = W ξ^(-S) c that reads W S = translation_rate {-Vu S; Vu}.
  const MatrixXd& rate = polygon.translation_rate;
  const MatrixXd right = rate.rightCols(m) * half.Vu - rate.leftCols(m) * half.Vu * half.S;
  MatrixXd U = MatrixXd::Zero(N, N), Q = MatrixXd::Zero(N, N);
  U.topLeftCorner(2, m) = half.S.transpose().partialPivLu().solve(right.transpose()).transpose();
  U.bottomLeftCorner(m, m) = half.Vu;
  U.topRightCorner(2, 2).setIdentity();
  Q.bottomLeftCorner(m, m) = half.Vq;
  reflect_rows(polygon, U);
  reflect_rows(polygon, Q);
  result.Vu = polygon.scale.asDiagonal() * U;
  result.Vq = polygon.scale.cwiseInverse().asDiagonal() * Q;
  return result;
}

}  // namespace sunder::sbfem
