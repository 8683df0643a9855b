#include "verification/harness/jitter.hpp"

namespace sunder::verification {

Case jitter_case(const Case& verification_case) {
  if (verification_case.study != "scene")
    throw CaseError(verification_case.id + ": the numbers of a scene are moved; this case is of the study \"" +
                    verification_case.study + "\"");
  Case jitter = verification_case;
  jitter.study = "scene-jitter";
  jitter.tier = Tier::long_;  // thirty runs and one
  const std::vector<Setting> all = settings(verification_case);
  const std::string prefix = "parameters.";
  const std::size_t chosen = verification_case.sweep ? verification_case.sweep->standard.value_or(0) : 0;
  for (const auto& [key, value] : all.at(chosen))
    if (key.rfind(prefix, 0) != 0) jitter.overrides.emplace_back(key, value);
  jitter.parameters.clear();
  jitter.sweep.reset();
  jitter.ladder.reset();
  jitter.checks.clear();
  jitter.references.clear();
  jitter.negatives.clear();
  return jitter;
}

CaseResult run_jitter_case(const Case& verification_case, const RunnerOptions& options) {
  const Case jitter = jitter_case(verification_case);
  CaseResult result = run_case(jitter, studies().at(jitter.study), options);
  const SettingRow& row = result.settings.front();
  result.status = row.status;
  if (result.status == Status::pass && result.digits_trusted.empty()) result.status = Status::checked_nothing;
  result.message = row.message;
  return result;
}

}  // namespace sunder::verification
