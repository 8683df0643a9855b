#pragma once
/// Equilibrium under weight, standing water and what its cracks carry at rest, before the ground moves.

#include "solver/simulation/crack_waters.hpp"
#include "solver/simulation/dynamic_step.hpp"

namespace sunder::simulation {

struct StaticStart {
  numerics::FactorStatus status = numerics::FactorStatus::factorised;
  bool faces_found = true;       ///< contact and water were found
  Eigen::VectorXd displacement;  ///< (dofs) [m]
  FaceMemory faces;
  Eigen::VectorXd reaction;  ///< (dofs) [N/m]: forces of what holds the body at rest, where `held` says so
};

/// `held`: what is held at rest, at least the body's own supports. `waters`: those of uniform_waters.
[[nodiscard]] StaticStart static_start(const DynamicBody& body, const Constraints& held, std::span<const Mouth> mouths,
                                       const CrackWaters& waters, const faces::FaceStepOptions& options);

}  // namespace sunder::simulation
