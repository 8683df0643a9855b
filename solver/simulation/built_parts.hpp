#pragma once
/// Which optional parts this program was built with, and the refusal of a scene that asks for another one.
///
/// Each optional part meets the simulation in a few source files; a build without it (CMake: SUNDER_WITH_<PART>=OFF)
/// links absent/<part>.cpp in their place, and the part's module not at all (ci/cmake/SunderParts.cmake).

#include "solver/scene/scene.hpp"

namespace sunder::simulation {

namespace built {
extern const bool contact, crackwater, foundation, reservoir;
}

/// Throws scene::SceneError at the first table whose part is absent: "this build has no foundation".
void refuse_absent_parts(const scene::Scene& scene);

}  // namespace sunder::simulation
