#pragma once
/// Convolutions of independent degrees of freedom whose kernels are sums of exponentials:
///
///     W_0 = mass,    W_j ≈ Re Σ_k weight_k λ_k^(j-1),  j >= 1;      x ← λ x + a,    R = W_0 a' + Re Σ_k weight_k x_k
///
/// Cost and memory of a step are those of r n complex numbers, however many steps there were.

#include <Eigen/Core>

#include "solver/convolution/convolution.hpp"
#include "solver/convolution/state_space.hpp"

namespace sunder::convolution {

struct ExponentialSums {
  Eigen::VectorXd mass;          ///< W_0 (n) [kg/m]
  Eigen::MatrixXcd decay;        ///< λ (r, n), |λ| < 1
  Eigen::MatrixXcd weight;       ///< (r, n) [kg/m]
  KernelError error;             ///< over the certified lags; `relative` is the largest of the degrees of freedom
  long long certified_lags = 0;  ///< N: a run of more steps is not covered by the error
  bool within_tolerance = false;
};

class DiagonalStateSpace final : public Convolution {
 public:
  /// Throws std::invalid_argument where shapes disagree, a number is not finite or some |λ| >= 1.
  explicit DiagonalStateSpace(const ExponentialSums& sums);

  int size() const override { return static_cast<int>(mass_.rows()); }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override;
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

  double bytes() const;  ///< held

 private:
  Eigen::MatrixXd mass_;                            // diagonal (n, n)
  Eigen::MatrixXd fade_, turn_;                     // λ = fade + i turn (r, n)
  Eigen::MatrixXd weight_real_, weight_imaginary_;  // (r, n)
  Eigen::MatrixXd state_real_, state_imaginary_;    // x (r, n)
};

}  // namespace sunder::convolution
