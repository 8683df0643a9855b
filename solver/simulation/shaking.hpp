#pragma once
/// The ground's acceleration in a scene.

#include <Eigen/Core>
#include <filesystem>
#include <optional>

#include "solver/dynamics/ground_motion.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::simulation {

struct Shaking {
  std::optional<dynamics::GroundMotion> horizontal, vertical;
  double horizontal_scale = 1.0, vertical_scale = 1.0;

  Eigen::Vector2d at(double time) const;  ///< [m/s²], x and y
};

/// The file of a record: as it stands where absolute, else below the scene's folder, else below
/// reference-data/ground-motions of any folder above that, else below ground-motions of the folder that the environment
/// names in SUNDER_REFERENCE_DATA. Empty where there is none.
[[nodiscard]] std::filesystem::path find_record(const std::filesystem::path& scene_file,
                                                const std::filesystem::path& record);

/// Reads the scene's records; none where it has no [ground_motion]. Throws scene::SceneError at the table where a
/// record is not found, cannot be used, or is shorter than a time step.
[[nodiscard]] Shaking shaking_of(const scene::Scene& scene);

}  // namespace sunder::simulation
