#include "solver/simulation/run.hpp"

#include <stdexcept>

#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/field_snapshot.hpp"

namespace sunder::simulation {
namespace {

const char* word(scene::Analysis analysis) {
  switch (analysis) {
    case scene::Analysis::static_:
      return "static";
    case scene::Analysis::modal:
      return "modal";
    case scene::Analysis::dynamic:
      return "dynamic";
    case scene::Analysis::crack_water:
      return "crack-water";
    case scene::Analysis::response:
      return "response";
  }
  return "unknown";
}

void require_place_for_fields(const scene::Scene& scene, const RunOptions& options) {
  if (!wants_fields(scene) || !options.output.empty()) return;
  throw scene::SceneError(scene::place_of(scene, "output") +
                          "fields_every: this run has no folder to write fields to; accepted: 0, or a run with a "
                          "folder (`sunder run SCENE --output DIR`)");
}

void require_place_for_checkpoints(const scene::Scene& scene, const RunOptions& options) {
  const bool wanted = scene.output && scene.output->checkpoint_every > 0;
  if (wanted && options.output.empty())
    throw scene::SceneError(scene::place_of(scene, "output") +
                            "checkpoint_every: this run has no folder to write checkpoints to; accepted: 0, or a run "
                            "with a folder (`sunder run SCENE --output DIR`)");
  if (options.resume && !wanted)
    throw scene::SceneError(scene::place_of(scene, "output") +
                            "a run without checkpoints cannot be taken up again; accepted: analysis = \"dynamic\" with "
                            "output.checkpoint_every > 0");
}

}  // namespace

results::RunSummary run(const scene::Scene& scene, const RunOptions& options) {
  refuse_absent_parts(scene);
  numerics::ThreadPool pool(options.threads);
  require_place_for_checkpoints(scene, options);
  Ledger ledger;
  results::RunSummary summary;
  summary.name = scene.name;
  summary.analysis = word(scene.analysis);
  summary.threads = options.threads;
  if (scene.analysis == scene::Analysis::crack_water || scene.analysis == scene::Analysis::response) {
    // no body at all
    if (scene.analysis == scene::Analysis::crack_water) {
      run_crack_water(scene, options, ledger, summary);
    } else {
      run_response(scene, pool, ledger, summary);
    }
    ledger.close(summary);
    if (options.progress) options.progress("done", 1.0);
    return summary;
  }
  require_place_for_fields(scene, options);
  if (options.progress) options.progress("mesh", 0.0);
  const Body body = build_body(scene, ledger);
  summary.mesh = {.polygons = body.nodes.polygon_count(), .nodes = body.nodes.node_count(), .dofs = body.dofs()};

  if (options.stop != nullptr && options.stop->load()) {
    summary.status = "stopped: interrupted after meshing";
  } else if (scene.analysis == scene::Analysis::static_ && scene.propagation) {
    run_propagation(scene, body, options, pool, ledger, summary);
  } else if (scene.analysis == scene::Analysis::static_) {
    run_static(scene, body, options, pool, ledger, summary);
  } else if (scene.analysis == scene::Analysis::modal) {
    run_modal(scene, body, options, pool, ledger, summary);
  } else if (scene.analysis == scene::Analysis::dynamic) {
    run_dynamic(scene, body, options, pool, ledger, summary);
  } else {
    throw std::invalid_argument(std::string("analysis \"") + word(scene.analysis) + "\" is not built yet");
  }
  if (options.final_body && !scene.propagation && scene.analysis != scene::Analysis::dynamic) options.final_body(body);
  ledger.close(summary);
  if (options.progress) options.progress("done", 1.0);
  return summary;
}

}  // namespace sunder::simulation
