#include "verification/harness/studies/scene_of_study.hpp"

#include "solver/crack/crack_path.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::verification {

StudyOutput run_with_scene(const StudyInput& input, const std::function<results::RunSummary(scene::Scene&)>& run,
                           const scene::NumberFilter& filter) {
  std::vector<scene::Override> overrides;
  for (const auto& [key, value] : input.scene_keys) overrides.push_back({key, value.text});
  StudyOutput output;
  try {
    scene::Scene scene = scene::read_scene(input.verification_case.scene, overrides, filter);
    output.summary = run(scene);
  } catch (const scene::SceneError& error) {
    output.refusal = error.what();
  } catch (const crack::CrackError& error) {
    output.refusal = error.what();
  } catch (const mesh::MeshError& error) {
    output.refusal = error.what();
  }
  return output;
}

}  // namespace sunder::verification
