#include "verification/harness/studies/free_body.hpp"

#include <Eigen/Eigenvalues>

namespace sunder::verification {

Eigen::MatrixXd rigid_motions(const Eigen::Matrix2Xd& nodes, const Eigen::Vector2d& middle) {
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(nodes.size(), 3);
  for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
    const Eigen::Vector2d r = nodes.col(i) - middle;
    rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1.0;
    rigid.block<2, 1>(2 * i, 2) << -r.y(), r.x();
  }
  rigid.colwise().normalize();
  return rigid;
}

Eigen::VectorXd scaled_spectrum(const Eigen::MatrixXd& K) {
  const Eigen::VectorXd scale = K.diagonal().cwiseSqrt().cwiseInverse();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * K * scale.asDiagonal(),
                                                        Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace sunder::verification
