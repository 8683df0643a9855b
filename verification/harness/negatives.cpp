#include "verification/harness/negatives.hpp"

#include <algorithm>

namespace sunder::verification {
namespace {

using Verdict = NegativeOutcome::Verdict;

/// A run that ended before its checks is red in all of them.
bool ended_early(const CaseResult& result) {
  return result.checks.empty() && fails(result.status);
}

bool is_red(const CaseResult& result, const std::string& name) {
  if (ended_early(result)) return true;
  return std::any_of(result.checks.begin(), result.checks.end(), [&](const CheckOutcome& check) {
    return check.name == name && (fails(check.status) || check.status == Status::known_limit);
  });
}

NegativeOutcome run_one(const Negative& negative, const CaseResult& baseline, const FaultControl& faults,
                        const RunCase& run) {
  NegativeOutcome outcome{negative.fault, negative.checks, {}, false, Verdict::survived};
  const CaseResult result = run([&] { faults.plant(negative.fault); },
                                [&](CaseResult& after) {
                                  after.negatives = {outcome};
                                  after.negatives.front().reached = faults.reached();
                                  faults.plant("");
                                });
  // Where the child ended without a word, the fault is what ended it: the baseline came through.
  outcome.reached = result.negatives.empty() ? ended_early(result) : result.negatives.front().reached;
  if (ended_early(result))
    outcome.red = negative.checks;
  else
    for (const CheckOutcome& check : result.checks)
      if (fails(check.status) && !is_red(baseline, check.name)) outcome.red.push_back(check.name);
  const bool no_baseline = std::any_of(negative.checks.begin(), negative.checks.end(),
                                       [&](const std::string& name) { return is_red(baseline, name); });
  const bool all_red = std::all_of(negative.checks.begin(), negative.checks.end(),
                                   [&](const std::string& name) { return is_red(result, name); });
  outcome.verdict = no_baseline        ? Verdict::no_baseline
                    : !outcome.reached ? Verdict::never_reached
                    : all_red          ? Verdict::killed
                                       : Verdict::survived;
  return outcome;
}

}  // namespace

CaseResult run_negatives(const Case& verification_case, const FaultControl& faults, const RunCase& run) {
  CaseResult baseline = run([&] { faults.plant(""); }, [](CaseResult&) {});
  for (const Negative& negative : verification_case.negatives)
    baseline.negatives.push_back(run_one(negative, baseline, faults, run));
  const auto alive = std::count_if(baseline.negatives.begin(), baseline.negatives.end(),
                                   [](const NegativeOutcome& outcome) { return outcome.verdict != Verdict::killed; });
  if (alive > 0) {
    baseline.status = std::max(baseline.status, Status::wrong_value);
    baseline.message =
        std::to_string(alive) + " of " + std::to_string(baseline.negatives.size()) + " planted faults were not noticed";
  }
  return baseline;
}

}  // namespace sunder::verification
