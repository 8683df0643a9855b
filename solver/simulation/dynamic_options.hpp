#pragma once
/// What a dynamic scene says about its steps, as the values that the step wants.

#include "solver/faces/face_step.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/dynamic_body.hpp"
#include "solver/simulation/ledger.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

/// Scheme, step and Rayleigh damping, by the frequencies of the body on rigid rock without water. Throws
/// scene::SceneError at [dynamics] where a mode that the damping names is not found.
[[nodiscard]] StepOptions step_options(const scene::Scene& scene, const DynamicBody& body, numerics::ThreadPool& pool,
                                       Ledger& ledger);

[[nodiscard]] faces::FaceStepOptions face_step_options(const scene::Scene& scene);

/// The node whose motion is reported: on the boundary "crest", else of the whole body, the highest, of several the
/// leftmost.
[[nodiscard]] int crest_node(const Body& body);

}  // namespace sunder::simulation
