#pragma once
/// The analyses that `run` chooses from, each from a body, or a crack alone, to the quantities of the summary.

#include "solver/numerics/thread_pool.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/ledger.hpp"
#include "solver/simulation/run.hpp"

namespace sunder::simulation {

void run_static(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                Ledger& ledger, results::RunSummary& summary);

/// Cracks that grow at rest. Throws scene::SceneError where the increment is larger than the body.
void run_propagation(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                     Ledger& ledger, results::RunSummary& summary);

void run_modal(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
               Ledger& ledger, results::RunSummary& summary);

/// A body shaken by the ground. Throws scene::SceneError where a record, a face or a mode cannot be used.
void run_dynamic(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                 Ledger& ledger, results::RunSummary& summary);

/// A crack with given motion and no body. Throws scene::SceneError as `check_crack_water`.
void run_crack_water(const scene::Scene& scene, const RunOptions& options, Ledger& ledger,
                     results::RunSummary& summary);

/// The unbounded domains alone. Throws scene::SceneError as they do.
void run_response(const scene::Scene& scene, numerics::ThreadPool& pool, Ledger& ledger, results::RunSummary& summary);

}  // namespace sunder::simulation
