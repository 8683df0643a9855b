/// Any text after --set is an override of a key, or refused with std::invalid_argument or SceneError.

#include <array>
#include <stdexcept>
#include <string_view>

#include "solver/scene/reader.hpp"
#include "verification/fuzz/try_bytes.hpp"

namespace {

constexpr std::string_view edge_crack = R"(name = "edge crack"
analysis = "static"
geometry = { outline = [[0, -1], [1, -1], [1, 1], [0, 1]], boundaries = { bottom = [0], top = [2] } }
mesh.size = 0.1
material = { youngs_modulus = 25e9, poisson_ratio = 0.2 }
crack = [{ path = [[0, 0], [0.5, 0]] }]
support = [{ boundary = "bottom", fix = ["x", "y"] }]
load = [{ boundary = "top", traction = [0, 1e6] }]
)";

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sunder::scene;
  try {
    const std::array given{parse_override(std::string_view(reinterpret_cast<const char*>(data), size))};
    static_cast<void>(read_scene_text(edge_crack, "scene.toml", given));
  } catch (const std::invalid_argument&) {
  } catch (const SceneError&) {
  }
  return 0;
}
