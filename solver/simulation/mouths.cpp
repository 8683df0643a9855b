#include "solver/simulation/crack_waters.hpp"
#include "solver/simulation/standing_water.hpp"

namespace sunder::simulation {

std::vector<Mouth> mouths_of(const scene::Scene& scene, const Body& body,
                             std::span<const AttachedMedium* const> media) {
  std::vector<Mouth> mouths(body.polygons.cracks.size());
  for (std::size_t c = 0; c < mouths.size(); ++c) {
    const std::optional<RestingWater> water = resting_water(scene, body, static_cast<int>(c));
    if (!water) continue;
    mouths[c].wet = true;
    mouths[c].resting = water->mouth_pressure;
    for (std::size_t m = 0; m < media.size(); ++m) {
      if (media[m]->name != "reservoir") continue;
      mouths[c].medium = m;
      mouths[c].weights = reservoir_pressure_weights(scene, body, water->mouth_level);
    }
  }
  return mouths;
}

}  // namespace sunder::simulation
