#pragma once
/// What the stiffness of a free body is to show: rigid motions without force, and no other motion for nothing.

#include <Eigen/Core>

namespace sunder::verification {

/// Two translations and the rotation about `middle` (2) [m] at the nodes (2, n) [m], each a column of length 1 (2n, 3).
Eigen::MatrixXd rigid_motions(const Eigen::Matrix2Xd& nodes, const Eigen::Vector2d& middle);

/// Eigenvalues, rising, of S K S with S = diag(K)^-1/2: without unit, whatever the lengths of the edges.
Eigen::VectorXd scaled_spectrum(const Eigen::MatrixXd& K);

}  // namespace sunder::verification
