#include "solver/simulation/crack_waters.hpp"

#include "solver/simulation/standing_water.hpp"

namespace sunder::simulation {
namespace {

/// Nodes of the water are no farther apart: fronts and the taper of an opening crack are seen, and 50 m of crack have
/// 100.
constexpr double longest_segment = 0.5;  // m

MovingWaterOptions options_of(const scene::Scene& scene) {
  const scene::CrackWater& water = *scene.crack_water;
  return {.water = {.density = water.density,
                    .dynamic_viscosity = water.dynamic_viscosity,
                    .relative_roughness = water.relative_roughness,
                    .gravity = scene.gravity ? scene.gravity->acceleration : 0.0},
          .minimum_aperture = water.minimum_aperture,
          .rule = water.aperture == scene::ApertureRule::sum ? crackwater::ApertureRule::sum
                                                             : crackwater::ApertureRule::larger};
}

WaterNodes nodes_of(const DynamicBody& body, std::size_t crack) {
  const CrackFaceLoads& faces = body.cracks[crack];
  return water_nodes(faces.pairs, body.body.nodes, faces.tip ? &faces.tip->position : nullptr, longest_segment);
}

}  // namespace

CrackWaters uniform_waters(const DynamicBody& body, std::span<const Mouth> mouths) {
  CrackWaters waters(body.cracks.size());
  for (std::size_t c = 0; c < waters.size(); ++c) {
    if (!mouths[c].wet) continue;
    waters[c] = std::make_unique<faces::UniformWater>(body.cracks[c].pairs.count(), body.cracks[c].uniform_share());
  }
  return waters;
}

CrackWaters moving_waters(const scene::Scene& scene, const DynamicBody& body, std::span<const Mouth> mouths,
                          const Eigen::VectorXd& openings) {
  CrackWaters waters(body.cracks.size());
  for (std::size_t c = 0, pair = 0; c < waters.size(); ++c) {
    const auto count = static_cast<std::size_t>(body.cracks[c].pairs.count());
    if (mouths[c].wet) {
      waters[c] = std::make_unique<MovingWater>(nodes_of(body, c), static_cast<Eigen::Index>(count), options_of(scene),
                                                std::span<const double>(openings.data() + pair, count));
    }
    pair += count;
  }
  return waters;
}

void grow_waters(const scene::Scene& scene, const DynamicBody& body, const Eigen::VectorXd& openings,
                 CrackWaters& waters) {
  for (std::size_t c = 0, pair = 0; c < waters.size(); ++c) {
    const auto count = static_cast<std::size_t>(body.cracks[c].pairs.count());
    if (waters[c] != nullptr && scene.crack_water->model == scene::CrackWaterModel::uniform) {
      waters[c] =
          std::make_unique<faces::UniformWater>(static_cast<Eigen::Index>(count), body.cracks[c].uniform_share());
    } else if (waters[c] != nullptr) {
      static_cast<MovingWater&>(*waters[c])
          .grow(nodes_of(body, c), static_cast<Eigen::Index>(count),
                std::span<const double>(openings.data() + pair, count));
    }
    pair += count;
  }
}

}  // namespace sunder::simulation
