#include "solver/simulation/analyses.hpp"
#include "solver/simulation/foundation_response.hpp"

namespace sunder::simulation {

void run_response(const scene::Scene& scene, const RunOptions& options, numerics::ThreadPool& pool, Ledger& ledger,
                  results::RunSummary& summary) {
  if (options.progress) options.progress("response", 0.1);
  if (scene.foundation) add_foundation_response(scene, pool, ledger, summary);
}

}  // namespace sunder::simulation
