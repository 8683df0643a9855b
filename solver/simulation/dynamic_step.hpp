#pragma once
/// One step of a shaken body with all that acts between its crack faces, solved together.
///
/// The trial motion without the forces between the faces costs one back-substitution. The faces' forces follow on the
/// faces alone (module faces) from the condensed answer S = Lᵀ X, X = K̂⁻¹ L, kept since the last growth event; the
/// motion is corrected by X y, a product. So contact and water, however stiff, cost no factorisation, and nothing of a
/// step lags behind another part of it.

#include <memory>
#include <vector>

#include "solver/faces/face_step.hpp"
#include "solver/simulation/crack_waters.hpp"
#include "solver/simulation/dynamic_body.hpp"
#include "solver/simulation/energy_account.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

/// What the faces carry over from one epoch to the next, or from rest to the first step.
struct FaceMemory {
  Eigen::VectorXd force;    ///< y (m) [N/m]
  Eigen::VectorXd opening;  ///< (pairs) [m]
  Eigen::VectorXd contact;  ///< (pairs) [N/m]
  double stiffness = 0.0;   ///< of the penalty [N/m³]
};

/// What one step leaves for the next, beside the motion, the media and the water.
struct StepMemory {
  FaceMemory faces;
  Eigen::VectorXd motion;  ///< (m) [m] conjugate to the forces
  faces::FaceStepMemory solve;
};

class DynamicStep {
 public:
  /// Begins at `state`. `body`, `media`, `mouths` and `waters` must outlive the step.
  DynamicStep(const DynamicBody& body, std::span<AttachedMedium* const> media, std::span<const Mouth> mouths,
              const CrackWaters& waters, const StepOptions& options, const faces::FaceStepOptions& face_options,
              const FaceMemory& memory, const MotionState& state);

  numerics::FactorStatus status() const { return equations_.status(); }
  const StepEquations& equations() const { return equations_; }
  StepEquations& equations() { return equations_; }

  /// From `state` to `next` under loads without those between the faces. Allocates nothing. False where the faces'
  /// forces were not found: `next` is then the best answer and nothing has been accepted.
  [[nodiscard]] bool solve(const MotionState& state, const StepLoad& start, const StepLoad& end, MotionState& next);

  /// The step's end is the next one's beginning: media, water and faces move on. Returns the works on the faces.
  FaceWork accept(const MotionState& next, const Eigen::Vector2d& ground);

  /// nullptr without cracks.
  const faces::FaceStep* faces() const { return faces_.get(); }
  const FaceMemory& memory() const { return memory_; }
  const numerics::Meter& face_work() const { return face_work_; }  ///< of the faces' equations, their water included

  /// Of a step with cracks.
  StepMemory step_memory() const { return {.faces = memory_, .motion = before_motion_, .solve = faces_->memory()}; }
  /// Goes on as the step of the same body that `memory` is of.
  void go_on(const StepMemory& memory);

  /// What is out of balance at `state`: M a + C v + K u + ΣR - f - L y (dofs) [N/m]. After a growth event, the force
  /// that had held the new faces together.
  Eigen::VectorXd unbalanced(const MotionState& state, const StepLoad& load) const;

 private:
  const DynamicBody* body_;
  std::vector<AttachedMedium*> media_;
  std::span<const Mouth> mouths_;
  StepEquations equations_;
  Eigen::MatrixXd X_;
  std::unique_ptr<faces::FaceStep> faces_;
  FaceMemory memory_;
  StepLoad start_;
  MotionState trial_;
  numerics::Meter face_work_;
  Eigen::VectorXd d_, motion_, before_motion_, mouth_pressure_;
  std::vector<Eigen::RowVectorXd> of_acceleration_;  // pressure at each mouth of a unit acceleration of its medium
};

}  // namespace sunder::simulation
