#include "solver/sbfem/reduced_polygon.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::sbfem {
namespace {

/// The vector of the reflection that carries the unit vector `direction` to a multiple of `axis`.
Eigen::VectorXd mirror_of(const Eigen::VectorXd& direction, Eigen::Index axis) {
  Eigen::VectorXd v = direction;
  v[axis] += 1.0;  // direction[axis] > 0: no cancellation
  return v * (std::sqrt(2.0) / v.norm());
}

}  // namespace

void reflect_rows(const ReducedPolygon& polygon, Eigen::Ref<Eigen::MatrixXd> X) {
  // The two reflections touch different rows, so that both at once are one reflection in two directions.
  const Eigen::MatrixXd product = polygon.mirror.transpose() * X;
  X.noalias() -= polygon.mirror * product;
}

ReducedPolygon reduce(const Coefficients& coefficients) {
  ReducedPolygon polygon;
  const auto N = coefficients.E0.rows(), m = N - 2;
  const Eigen::VectorXd diagonal = coefficients.E0.diagonal();
  if (!(diagonal.minCoeff() > 0.0) || !coefficients.E0.allFinite() || !coefficients.E1.allFinite() ||
      !coefficients.E2.allFinite()) {
    return polygon;
  }
  polygon.scale = diagonal.cwiseSqrt().cwiseInverse();
  const auto P = polygon.scale.asDiagonal();
  Eigen::MatrixXd E0 = P * coefficients.E0 * P, F = P * coefficients.E1.transpose() * P, E2 = P * coefficients.E2 * P;

  polygon.mirror = Eigen::MatrixXd::Zero(N, 2);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(N);
    for (Eigen::Index i = axis; i < N; i += 2) direction[i] = 1.0 / polygon.scale[i];
    if (numerics::planted_fault("sbfem/translation-deflated-unscaled")) direction = direction.cwiseSign();
    polygon.mirror.col(axis) = mirror_of(direction.normalized(), axis);
  }
  const auto rotate = [&polygon](Eigen::MatrixXd& X) {
    reflect_rows(polygon, X);
    Eigen::MatrixXd transposed = X.transpose();
    reflect_rows(polygon, transposed);
    X = transposed.transpose();
  };
  rotate(E0);
  rotate(F);
  rotate(E2);

  const Eigen::LLT<Eigen::Matrix2d> L(E0.topLeftCorner<2, 2>());
  if (L.info() != Eigen::Success) return polygon;
  // Rᵀ and Sᵀ, (2, m).
  const Eigen::MatrixXd R = L.matrixL().solve(E0.topRightCorner(2, m));
  const Eigen::MatrixXd S = L.matrixL().solve(F.topRightCorner(2, m));
  polygon.E0 = E0.bottomRightCorner(m, m) - R.transpose() * R;
  polygon.F = F.bottomRightCorner(m, m) - R.transpose() * S;
  polygon.E2 = E2.bottomRightCorner(m, m) - S.transpose() * S;
  polygon.translation_rate.resize(2, 2 * m);
  polygon.translation_rate << L.matrixU().solve(R), L.matrixU().solve(S);
  polygon.valid = true;
  return polygon;
}

Eigen::MatrixXd expand_stiffness(const ReducedPolygon& polygon, const Eigen::MatrixXd& reduced) {
  const auto N = polygon.scale.size(), m = N - 2;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(N, N);
  K.bottomRightCorner(m, m) = reduced;
  reflect_rows(polygon, K);
  K.transposeInPlace();
  reflect_rows(polygon, K);
  const Eigen::VectorXd stretch = polygon.scale.cwiseInverse();
  K = (stretch.asDiagonal() * K * stretch.asDiagonal()).eval();
  return 0.5 * (K + K.transpose());
}

}  // namespace sunder::sbfem
