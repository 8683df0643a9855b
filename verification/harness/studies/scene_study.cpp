#include "solver/mesh/mesh_error.hpp"
#include "solver/scene/reader.hpp"
#include "solver/simulation/run.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

StudyOutput run_scene(const StudyInput& input) {
  std::vector<scene::Override> overrides;
  for (const auto& [key, value] : input.scene_keys) overrides.push_back({key, value.text});
  StudyOutput output;
  try {
    const scene::Scene scene = scene::read_scene(input.verification_case.scene, overrides);
    simulation::RunOptions options;
    options.threads = input.threads;
    output.summary = simulation::run(scene, options);
  } catch (const scene::SceneError& error) {
    output.refusal = error.what();
  } catch (const mesh::MeshError& error) {
    output.refusal = error.what();
  }
  return output;
}

}  // namespace sunder::verification
