#pragma once
/// Water between the faces of one crack, as a step of the structure sees it: forces and their derivatives for a trial
/// motion, and a state that moves on only when the step is accepted.

#include <Eigen/Core>
#include <span>

namespace sunder::faces {

/// Forces of the water of one crack with n pairs of faces, (m) [N/m]: on the pairs, and beyond them the resultants of
/// the pressure inside tip polygons. Positive where they push the faces apart.
struct WaterForces {
  Eigen::VectorXd force;       ///< f (m) [N/m]
  Eigen::MatrixXd by_opening;  ///< ∂f/∂g (m, n) [Pa]
  Eigen::VectorXd by_mouth;    ///< ∂f/∂p (m) [m]

  WaterForces(Eigen::Index forces, Eigen::Index pairs)
      : force(Eigen::VectorXd::Zero(forces)),
        by_opening(Eigen::MatrixXd::Zero(forces, pairs)),
        by_mouth(Eigen::VectorXd::Zero(forces)) {}
};

class FaceWater {
 public:
  virtual ~FaceWater() = default;

  virtual Eigen::Index pairs() const = 0;   ///< n
  virtual Eigen::Index forces() const = 0;  ///< m >= n

  /// What the water does if the step ends with these `openings` (n) [m] (negative: penetration) and this pressure at
  /// the mouth [Pa], `time_step` [s] after the last accepted end. Changes nothing that a further trial would notice;
  /// allocates and throws nothing. False where the water's own solution was not found: `result` is then its best
  /// answer.
  [[nodiscard]] virtual bool trial(std::span<const double> openings, double mouth_pressure, double time_step,
                                   WaterForces& result) = 0;

  /// Ends the step with the last trial.
  virtual void accept() = 0;
};

}  // namespace sunder::faces
