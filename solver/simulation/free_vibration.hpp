#pragma once
/// Free vibration of the assembled body, with or without the radial bubbles of its polygons.

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "solver/numerics/natural_modes.hpp"
#include "solver/simulation/constraints.hpp"

namespace sunder::simulation {

/// Matrices of the body. Bubbles (sbfem/radial_bubbles.hpp) have unit mass each and stiffness `bubble_omega_squared`;
/// the static stiffness does not couple them to the boundary, the mass does.
struct VibratingBody {
  Eigen::SparseMatrix<double> stiffness, mass;  ///< (dofs, dofs), lower triangles
  Eigen::VectorXd bubble_omega_squared;         ///< (b) [rad²/s²]; empty: mass of the static field alone
  Eigen::SparseMatrix<double> bubble_coupling;  ///< (dofs, b) [√(kg/m)]
};

enum class VibrationStatus { converged, not_converged, not_positive_definite, mode_missed };

struct FreeVibration {
  Eigen::VectorXd omega;           ///< [rad/s], ascending; 0 for rigid motions
  Eigen::MatrixXd shapes;          ///< (dofs, count) of the boundary dofs, unit modal mass
  Eigen::Matrix2Xd participation;  ///< (2, count): share of the total mass that moves in x and in y with each mode [-]
  int solves = 0;
  long long factor_entries = 0;
  bool counted = false;  ///< the inertia of K - σM was asked whether a mode was missed (bodies up to 20 000 dofs)
  VibrationStatus status = VibrationStatus::converged;
};

/// The lowest `count` modes. `floating`: the constraints leave rigid motions, which come out with ω = 0.
[[nodiscard]] FreeVibration free_vibration(const VibratingBody& body, const Constraints& constraints, int count,
                                           bool floating);

}  // namespace sunder::simulation
