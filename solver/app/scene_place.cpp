#include "solver/app/scene_place.hpp"

#include <charconv>
#include <string_view>

#include "solver/crack/crack_path.hpp"
#include "solver/mesh/mesh_error.hpp"

namespace sunder::app {
namespace {

/// "crack 2: …" speaks of the second [[crack]].
std::string crack_table(std::string_view message) {
  constexpr std::string_view start = "crack ";
  int number = 0;
  if (message.starts_with(start))
    std::from_chars(message.data() + start.size(), message.data() + message.size(), number);
  return "crack[" + std::to_string(number - 1) + "]";
}

}  // namespace

void at_its_place(const scene::Scene& scene, const std::function<void()>& work) {
  try {
    work();
  } catch (const crack::CrackError& error) {
    throw scene::SceneError(place_of(scene, crack_table(error.what())) + error.what());
  } catch (const mesh::MeshError& error) {
    throw scene::SceneError(place_of(scene, scene.geometry ? "geometry" : "mesh") + error.what());
  }
}

}  // namespace sunder::app
