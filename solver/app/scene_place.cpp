#include "solver/app/scene_place.hpp"

#include <charconv>
#include <string_view>

#include "solver/crack/crack_path.hpp"
#include "solver/mesh/mesh_error.hpp"

namespace sunder::app {
namespace {

/// The number after `start`, where `message` begins so: 2 of "crack 2: …"; -1 where it does not.
int number_after(std::string_view start, std::string_view message) {
  int number = -1;
  if (message.starts_with(start))
    std::from_chars(message.data() + start.size(), message.data() + message.size(), number);
  return number;
}

/// Module crack counts the scene's cracks from 1.
std::string told(const scene::Scene& scene, const crack::CrackError& error) {
  const int number = number_after("crack ", error.what());
  return place_of(scene, "crack[" + std::to_string(number - 1) + "]") + error.what();
}

/// Module mesh knows cracks as the paths that its edges follow, counted from 0; sizes and files belong to [mesh].
std::string told(const scene::Scene& scene, const mesh::MeshError& error) {
  const std::string message = error.what();
  if (const int path = number_after("path ", message); path >= 0)
    return place_of(scene, "crack[" + std::to_string(path) + "]") + "crack " + std::to_string(path + 1) +
           message.substr(message.find_first_not_of("0123456789", std::string_view("path ").size()));
  const bool about_size = message.find("max_polygons") != std::string::npos;
  return place_of(scene, scene.geometry && !about_size ? "geometry" : "mesh") + message;
}

}  // namespace

void at_its_place(const scene::Scene& scene, const std::function<void()>& work) {
  try {
    work();
  } catch (const crack::CrackError& error) {
    throw scene::SceneError(told(scene, error));
  } catch (const mesh::MeshError& error) {
    throw scene::SceneError(told(scene, error));
  }
}

}  // namespace sunder::app
