#include "solver/sbfem/interior_values.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

namespace sunder::sbfem {
namespace {

/// exp(-R t) x for ‖R‖ t < 1, by its Taylor series.
Eigen::MatrixXd short_decay(const Eigen::MatrixXd& R, double t, const Eigen::MatrixXd& x) {
  Eigen::MatrixXd sum = x, term = x;
  for (int k = 1; k <= 20; ++k) {  // 1 / 20! < 1e-18
    term = (-t / k) * (R * term);
    sum += term;
  }
  return sum;
}

}  // namespace

InteriorValues::InteriorValues(const Boundary& boundary, const Coefficients& coefficients,
                               const PolygonSolution& solution,
                               const Eigen::Ref<const Eigen::MatrixXd>& boundary_values)
    : edges_(edge_elements(boundary)) {
  const Eigen::Index n = 2 * boundary.nodes.cols();
  if (boundary_values.rows() != n) {
    throw std::invalid_argument("boundary_values: " + std::to_string(boundary_values.rows()) + " rows, accepted is " +
                                std::to_string(n));
  }
  // As in interior_field.cpp: scaled by P = diag(E0)^-1/2, in the basis [T Q] of the translations A = [0 C; 0 R].
  const Eigen::VectorXd scale = coefficients.E0.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled_A = scale.cwiseInverse().asDiagonal() * solution.A * scale.asDiagonal();
  Eigen::MatrixX2d translations = Eigen::MatrixX2d::Zero(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) translations(i, i % 2) = 1.0 / scale[i];
  const Eigen::MatrixXd basis = translations.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, n);
  const auto T = basis.leftCols(2), Q = basis.rightCols(n - 2);
  const Eigen::MatrixXd AQ = scaled_A * Q;
  rate_ = Q.transpose() * AQ;
  const Eigen::MatrixXd feed = rate_.transpose().partialPivLu().solve((T.transpose() * AQ).transpose()).transpose();
  const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * boundary_values;
  start_ = Q.transpose() * scaled;
  centre_ = scale.asDiagonal() * (T * (T.transpose() * scaled - feed * start_));
  to_displacement_ = scale.asDiagonal() * (T * feed + Q);
  first_step_ = 0.9 / rate_.cwiseAbs().colwise().sum().maxCoeff();
}

Eigen::Matrix2Xd InteriorValues::at(const RayPoint& point) {
  Eigen::MatrixXd nodal = centre_;
  if (point.xi > 0.0) {
    const double t = -std::log(point.xi);
    // Beyond 2^60 first steps whatever decays has gone.
    const double digits = std::min(std::floor(t / first_step_), std::ldexp(1.0, 60));
    Eigen::MatrixXd v = short_decay(rate_, t - digits * first_step_, start_);
    auto rest = static_cast<unsigned long long>(digits);
    for (std::size_t j = 0; rest != 0; ++j, rest >>= 1) {
      if (j == powers_.size()) {
        powers_.push_back(j == 0 ? Eigen::MatrixXd((-first_step_ * rate_).exp())
                                 : Eigen::MatrixXd(powers_[j - 1] * powers_[j - 1]));
      }
      if ((rest & 1u) != 0) v = powers_[j] * v;
    }
    nodal += to_displacement_ * v;
  }
  const EdgeElement& edge = edges_.at(static_cast<std::size_t>(point.edge));
  const Eigen::VectorXd shape = numerics::values(edge.basis, 2.0 * point.position - 1.0);
  Eigen::Matrix2Xd value(2, nodal.cols());
  for (Eigen::Index m = 0; m < nodal.cols(); ++m) value.col(m) = interpolate(edge, shape, nodal.col(m));
  return value;
}

}  // namespace sunder::sbfem
