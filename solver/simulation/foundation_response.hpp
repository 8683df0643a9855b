#pragma once
/// analysis = "response" of [foundation]: what a rigid strip on the half-plane, or a rigid disc in the full plane,
/// feels of the unbounded rock.
///
/// `impedance`, one a frequency: forces per displacement over G, complex ([re, im], e^{iωt}): `H`, `V` for translations
/// in x and y, `R` (over b²) for the rotation about the middle, `HR` (over b) the
/// counter-clockwise moment that holds the strip upright when it moves in +x. `impulse`, one a time: the horizontal
/// force on the line of the unbounded rock (disc: its edge; strip: sides and bottom of its near field) that moves as
/// one, for a unit impulse of acceleration, over ρ c_s b.

#include "solver/numerics/thread_pool.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/ledger.hpp"

namespace sunder::simulation {

/// Adds the quantities. Throws scene::SceneError where the rock has no density or a frequency is 0: a plane has no
/// static stiffness against translation.
void add_foundation_response(const scene::Scene& scene, numerics::ThreadPool& pool, Ledger& ledger,
                             results::RunSummary& summary);

}  // namespace sunder::simulation
