#pragma once
/// analysis = "response" of [reservoir]: the water's force on a rigid face.
///
/// `force` (per ρ a H²) and `base_pressure` (per ρ a H), one a frequency, complex as [re, im], e^{iωt}; `impulse_force`
/// (per ρ c H), one a time. From the series of the endless reservoir, or, with response.face_elements, from the
/// discretised face. `compressible` has all of them; the water of the other models answers at once: the same force at
/// every frequency, and no impulse response.

#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/ledger.hpp"

namespace sunder::simulation {

/// Adds the quantities. Where the response is infinite, at a natural frequency of water over a rigid bottom, the
/// summary's status says so and no number is given. Throws scene::SceneError for times that have no closed form.
void add_reservoir_response(const scene::Scene& scene, Ledger& ledger, results::RunSummary& summary);

}  // namespace sunder::simulation
