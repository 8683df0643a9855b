#pragma once
/// Any case of a scene, asked how many digits of its quantities are to be trusted instead of whether they are right.

#include "verification/harness/case_result.hpp"
#include "verification/harness/runner.hpp"

namespace sunder::verification {

/// The scene of the case, at the default of its sweep or else at its first setting, as a case of the study
/// "scene-jitter" without checks.
[[nodiscard]] Case jitter_case(const Case& verification_case);

/// Runs it in this process: digits_trusted holds what was found; passes where every jittered run came to an end.
/// Throws CaseError where the case's study is not "scene".
[[nodiscard]] CaseResult run_jitter_case(const Case& verification_case, const RunnerOptions& options);

}  // namespace sunder::verification
