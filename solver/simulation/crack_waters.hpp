#pragma once
/// The water in the cracks of a body that moves.

#include <memory>
#include <span>
#include <vector>

#include "solver/faces/uniform_water.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/dynamic_body.hpp"
#include "solver/simulation/moving_water.hpp"

namespace sunder::simulation {

/// Pressure of the water at a crack's mouth, p = resting + weights · R with R the forces of a medium [N/m].
struct Mouth {
  bool wet = false;
  double resting = 0.0;     ///< [Pa]
  std::size_t medium = 0;   ///< index of the medium
  Eigen::VectorXd weights;  ///< (n) [1/m]; empty: the reservoir is at rest
};

/// One a crack: dry where no water of the scene reaches its mouth, or the scene has no [crack_water].
[[nodiscard]] std::vector<Mouth> mouths_of(const scene::Scene& scene, const Body& body,
                                           std::span<const AttachedMedium* const> media);

/// One a crack, nullptr where the mouth is dry.
using CrackWaters = std::vector<std::unique_ptr<faces::FaceWater>>;

/// Water that fills each wet crack with the pressure of its mouth: at rest, and in the model "uniform".
[[nodiscard]] CrackWaters uniform_waters(const DynamicBody& body, std::span<const Mouth> mouths);

/// Water that flows. `openings` (pairs of all cracks) [m] at the start, when the cracks are full.
[[nodiscard]] CrackWaters moving_waters(const scene::Scene& scene, const DynamicBody& body,
                                        std::span<const Mouth> mouths, const Eigen::VectorXd& openings);

/// The same water in a body that has grown; new parts of cracks are dry. `openings` as above, in the grown body.
void grow_waters(const scene::Scene& scene, const DynamicBody& body, const Eigen::VectorXd& openings,
                 CrackWaters& waters);

}  // namespace sunder::simulation
