#pragma once
/// The lowest natural frequencies of K φ = ω² M φ, by shift-and-invert Lanczos.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>

namespace sunder::numerics {

/// y = Op(x): both of the same length, no overlap.
using Operator = std::function<void(Eigen::Ref<const Eigen::VectorXd> x, Eigen::Ref<Eigen::VectorXd> y)>;

enum class ModesStatus { converged, not_converged };

struct NaturalModes {
  Eigen::VectorXd eigenvalues;  ///< ω² [rad²/s²], ascending
  Eigen::MatrixXd shapes;       ///< (n, count), φᵀ M φ = I
  int iterations = 0;           ///< applications of the inverse
  double residual = 0.0;        ///< largest ‖φ - (λ + shift) (K + shift M)⁻¹ M φ‖ / ‖φ‖
  ModesStatus status = ModesStatus::converged;
};

/// The `count` eigenvalues next above -shift, from `solve` = (K + shift·M)⁻¹ and `apply_mass` = M. With M positive
/// semidefinite and K + shift·M positive definite. n is the number of rows; 1 <= count < n.
[[nodiscard]] NaturalModes lowest_modes(int n, int count, double shift, const Operator& solve,
                                        const Operator& apply_mass);

}  // namespace sunder::numerics
