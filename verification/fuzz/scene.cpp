/// Any text is a scene, or refused with SceneError; the outline of a scene is sound, or refused with MeshError.

#include <string_view>

#include "solver/mesh/mesh_error.hpp"
#include "solver/mesh/outline.hpp"
#include "solver/scene/reader.hpp"
#include "verification/fuzz/try_bytes.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sunder;
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const scene::Scene scene = scene::read_scene_text(text, "scene.toml");
    if (scene.geometry)
      mesh::check_outline({scene.geometry->outline, scene.geometry->holes, scene.geometry->boundaries});
  } catch (const scene::SceneError&) {
  } catch (const mesh::MeshError&) {
  }
  return 0;
}
