#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/foundation_response.hpp"
#include "solver/simulation/reservoir_response.hpp"

namespace sunder::simulation {

void run_response(const scene::Scene& scene, numerics::ThreadPool& pool, Ledger& ledger, results::RunSummary& summary) {
  if (scene.reservoir) add_reservoir_response(scene, ledger, summary);
  if (scene.foundation) add_foundation_response(scene, pool, ledger, summary);
}

}  // namespace sunder::simulation
