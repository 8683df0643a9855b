#include "solver/simulation/built_parts.hpp"

#include <string>

#include "solver/scene/scene_error.hpp"

namespace sunder::simulation {

void refuse_absent_parts(const scene::Scene& scene) {
  const auto require = [&](bool wanted, bool is_built, const char* table, const std::string& part, const char* option) {
    if (!wanted || is_built) return;
    throw scene::SceneError(scene::place_of(scene, table) + "this build has no " + part +
                            "; accepted: a scene without this table, or a build with -D" + option + "=ON");
  };
  require(scene.contact.has_value(), built::contact, "contact", "contact", "SUNDER_WITH_CONTACT");
  require(scene.crack_water.has_value(), built::crackwater, "crack_water", "crack water", "SUNDER_WITH_CRACKWATER");
  require(scene.foundation.has_value(), built::foundation, "foundation", "foundation", "SUNDER_WITH_FOUNDATION");
  require(scene.reservoir.has_value(), built::reservoir, "reservoir", "reservoir", "SUNDER_WITH_RESERVOIR");
}

}  // namespace sunder::simulation
