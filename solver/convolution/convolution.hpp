#pragma once
/// The force of an unbounded medium on the faces that move it, from the accelerations of all times.
///
///     R_n = W_0 a_n + Σ_{j=1}^{n} W_j a_{n-j}                     [seed paper, Eqs. (4), (5)]
///
/// a are the accelerations of the faces' degrees of freedom [m/s²] at the ends of equal time steps, at rest before the
/// first; R [N/m] is the force that the faces exert on the medium, so the body feels -R. W_0, the instantaneous mass,
/// belongs to the mass matrix of the step: on the load side it makes the step unstable. The sum is the history force.

#include <Eigen/Core>

namespace sunder::convolution {

class Convolution {
 public:
  virtual ~Convolution() = default;

  virtual int size() const = 0;                                   ///< n, degrees of freedom
  virtual const Eigen::MatrixXd& instantaneous_mass() const = 0;  ///< W_0 (n, n) [kg/m], symmetric

  /// Overwrites `force` (n) [N/m] with Σ_{j≥1} W_j a_{n-j} of the coming step. The same until `append`.
  virtual void history_force(Eigen::Ref<Eigen::VectorXd> force) = 0;

  /// Ends the step: `acceleration` (n) [m/s²] at its end. Allocates nothing.
  virtual void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) = 0;
};

}  // namespace sunder::convolution
