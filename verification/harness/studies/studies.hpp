#pragma once
/// The studies, one source file each. A new one is declared here and listed in studies.cpp.

#include "verification/harness/study.hpp"

namespace sunder::verification {

/// "scene": reads the scene with the setting's keys in place, runs it, and hands on its summary.
StudyOutput run_scene(const StudyInput& input);

}  // namespace sunder::verification
