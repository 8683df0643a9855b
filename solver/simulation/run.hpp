#pragma once
/// From a scene to its results.

#include <atomic>
#include <filesystem>
#include <functional>
#include <string_view>

#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::simulation {

struct Body;

struct RunOptions {
  int threads = 1;  ///< >= 1; the results are the same bits for any number
  std::function<void(std::string_view phase, double fraction)> progress = {};  ///< may be empty; fraction in 0 … 1
  std::function<void(const Body&)> final_body = {};  ///< may be empty; shown the body as the run has left it
  const std::atomic<bool>* stop = nullptr;           ///< set to end the run early, with what was reached
  std::filesystem::path cache = {};   ///< where responses of the rock are kept between runs; empty: nowhere
  std::filesystem::path output = {};  ///< where fields go (results.h5) while the run goes on; needed by a scene that
                                      ///< asks for them, else nothing is written; likewise checkpoints
  bool resume = false;                ///< go on from the checkpoint in `output`
};

/// Runs the scene. Throws mesh::MeshError or scene::SceneError where the scene cannot be used, and
/// std::filesystem::filesystem_error where fields cannot be written; numerical trouble is a status in the summary.
[[nodiscard]] results::RunSummary run(const scene::Scene& scene, const RunOptions& options = {});

/// What only module crackwater knows of a scene with analysis = "crack-water": throws scene::SceneError with table and
/// key for values that it does not accept.
void check_crack_water(const scene::Scene& scene);

}  // namespace sunder::simulation
