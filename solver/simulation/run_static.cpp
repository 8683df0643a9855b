#include "solver/sbfem/formation.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/static_state.hpp"

namespace sunder::simulation {

void run_static(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                Ledger& ledger, results::RunSummary& summary) {
  const auto report = [&](std::string_view phase, double fraction) {
    if (options.progress) options.progress(phase, fraction);
  };
  const Supports supports = supports_of(scene, body, false);

  report("polygons", 0.2);
  sbfem::Formation formation;
  {
    const Ledger::Visit visit(ledger, "sbfem", "polygons");
    formation = sbfem::form(body.nodes, body.materials, {.pool = &pool});
  }
  report("solution", 0.5);
  const StaticState state = static_state(scene, body, formation, supports, pool, ledger);
  if (state.solution.status != numerics::FactorStatus::factorised) {
    summary.status = stopping_reason(body, state.solution);
    return;
  }
  report("quantities", 0.9);
  add_static_quantities(scene, body, formation, supports, state, ledger, summary);
}

}  // namespace sunder::simulation
