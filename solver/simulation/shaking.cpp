#include "solver/simulation/shaking.hpp"

#include <cstdlib>

#include "solver/numerics/planted_fault.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::simulation {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const scene::Scene& scene, const std::string& what) {
  throw scene::SceneError(scene::place_of(scene, "ground_motion") + what);
}

dynamics::GroundMotion read(const scene::Scene& scene, const char* key, const fs::path& record) {
  const fs::path file = find_record(scene.file, record);
  if (file.empty()) {
    refuse(scene, std::string(key) + ": there is no file \"" + record.string() +
                      "\"; sought in the scene's folder, in reference-data/ground-motions of the folders above it, and "
                      "in ground-motions of "
                      "$SUNDER_REFERENCE_DATA");
  }
  try {
    dynamics::GroundMotion motion = dynamics::read_ground_motion(file);
    if (scene.dynamics && scene.dynamics->time_step > motion.end() - motion.start) {
      refuse(scene, std::string(key) + ": lasts " + std::to_string(motion.end() - motion.start) +
                        " s, less than dynamics.time_step");
    }
    if (scene.ground_motion->baseline == scene::Baseline::none ||
        numerics::planted_fault("dynamics/baseline-forgotten"))
      return motion;
    return dynamics::baseline_corrected(std::move(motion));
  } catch (const dynamics::RecordError& error) {
    refuse(scene, std::string(key) + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    refuse(scene, "baseline: " + file.string() + ": " + error.what());
  }
}

}  // namespace

Eigen::Vector2d Shaking::at(double time) const {
  return {horizontal ? horizontal_scale * horizontal->at(time) : 0.0,
          vertical ? vertical_scale * vertical->at(time) : 0.0};
}

fs::path find_record(const fs::path& scene_file, const fs::path& record) {
  std::error_code ignored;
  const auto usable = [&ignored](const fs::path& file) { return fs::is_regular_file(file, ignored); };
  if (record.is_absolute()) return usable(record) ? record : fs::path();
  fs::path folder = fs::absolute(scene_file, ignored).parent_path();
  if (usable(folder / record)) return folder / record;
  for (;; folder = folder.parent_path()) {
    const fs::path file = folder / "reference-data" / "ground-motions" / record;
    if (usable(file)) return file;
    if (folder == folder.parent_path()) break;
  }
  if (const char* data = std::getenv("SUNDER_REFERENCE_DATA")) {
    if (usable(fs::path(data) / "ground-motions" / record)) return fs::path(data) / "ground-motions" / record;
  }
  return {};
}

Shaking shaking_of(const scene::Scene& scene) {
  Shaking shaking;
  if (!scene.ground_motion) return shaking;
  const scene::GroundMotion& wanted = *scene.ground_motion;
  shaking.horizontal = read(scene, "horizontal", wanted.horizontal);
  if (wanted.vertical) shaking.vertical = read(scene, "vertical", *wanted.vertical);
  shaking.horizontal_scale = wanted.horizontal_scale;
  shaking.vertical_scale = wanted.vertical_scale;
  return shaking;
}

}  // namespace sunder::simulation
