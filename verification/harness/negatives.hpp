#pragma once
/// Would the checks notice? Each fault that a case names is planted, the case runs again, and the named checks must
/// fail.

#include <functional>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"
#include "verification/harness/faults.hpp"

namespace sunder::verification {

/// Runs the case, in a child process or in this one.
using RunCase =
    std::function<CaseResult(const std::function<void()>& before, const std::function<void(CaseResult&)>& after)>;

/// The result of the case without a fault, with one NegativeOutcome a fault. Its status is wrong_value where a fault
/// survived or was never reached, or where a named check fails without any fault.
///
/// `run` calls `before`, runs the case, and calls `after` with the result, all in the same process.
[[nodiscard]] CaseResult run_negatives(const Case& verification_case, const FaultControl& faults, const RunCase& run);

}  // namespace sunder::verification
