#include "solver/simulation/run.hpp"
#include "verification/harness/studies/scene_of_study.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

StudyOutput run_scene(const StudyInput& input) {
  return run_with_scene(input, [&](const scene::Scene& scene) {
    simulation::RunOptions options;
    options.threads = input.threads;
    return simulation::run(scene, options);
  });
}

}  // namespace sunder::verification
