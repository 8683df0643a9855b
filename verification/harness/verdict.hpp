#pragma once
/// What each check of a case says about the runs of its settings.

#include <vector>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"
#include "verification/harness/expression.hpp"
#include "verification/harness/runner.hpp"
#include "verification/harness/study.hpp"

namespace sunder::verification {

/// One setting after its run.
struct SettingRun {
  Setting setting;  ///< the case's overrides and parameters, then the setting's own
  SettingRow row;
  StudyOutput output;
};

/// The names that a formula of the case may use for this setting: quantities, parameters.<key>, scene.<key>,
/// reference.<name>, run.dofs, run.polygons, run.nodes, counts.<name>.
[[nodiscard]] Lookup lookup_of(const Case& verification_case, const SettingRun& run);

/// The verdict of one check; adds its errors to the rows, and measured pins to `pins`.
[[nodiscard]] CheckOutcome judge(const Case& verification_case, const Check& check, std::vector<SettingRun>& runs,
                                 const RunnerOptions& options, std::vector<std::pair<std::string, Values>>& pins);

/// The contract on parts: a part that the case does not list has no calls, no matrix entries, no time.
[[nodiscard]] CheckOutcome judge_parts(const Case& verification_case, const std::vector<SettingRun>& runs);

/// A ladder: every rung right, or refused in the words that the case names; no lower than last time.
[[nodiscard]] CheckOutcome judge_ladder(const Case& verification_case, const std::vector<SettingRun>& runs,
                                        const std::vector<CheckOutcome>& checks, const RunnerOptions& options,
                                        int& first_failing_rung);

/// True where the rung was refused, or stopped, in one of the words that the ladder accepts.
[[nodiscard]] bool refused_by_name(const Case& verification_case, const SettingRow& row);

}  // namespace sunder::verification
