#pragma once
/// A study's scene with the setting's keys in place, and what its reading or meshing refuses as the study's refusal.

#include <functional>

#include "solver/scene/reader.hpp"
#include "solver/scene/scene.hpp"
#include "verification/harness/study.hpp"

namespace sunder::verification {

/// Runs `run` on the scene of the case, each number of it passed through the filter; it may change the scene first.
/// Where scene or mesh are refused the output says why and holds no more.
StudyOutput run_with_scene(const StudyInput& input, const std::function<results::RunSummary(scene::Scene&)>& run,
                           const scene::NumberFilter& filter = {});

}  // namespace sunder::verification
