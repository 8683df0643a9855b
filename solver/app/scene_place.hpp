#pragma once
/// Faults that only the geometry shows, told at the table of the scene that they belong to. Private to this module.

#include <functional>
#include <string>

#include "solver/scene/reader.hpp"

namespace sunder::app {

/// Calls `work` and turns what modules mesh and crack throw about the scene's geometry into a SceneError
/// `file:line: [table] message`.
void at_its_place(const scene::Scene& scene, const std::function<void()>& work);

}  // namespace sunder::app
