#pragma once
/// Runs a case in a child process, so that a crash, an endless loop or a flood of memory is a verdict on that case and
/// leaves the others alone.

#include <functional>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"

namespace sunder::verification {

struct IsolationLimits {
  double seconds = 60.0;  ///< wall time after which the child is ended, > 0
  double memory = 4.0;    ///< address space of the child [GiB]; 0: no limit of its own
};

/// Generous multiples of what the tier promises: 60, 600, 7200 s; machines are slow and shared.
[[nodiscard]] IsolationLimits limits_of(const Case& verification_case);

/// Calls `run` in a forked child and brings its result back over a pipe. To be called while this process has one
/// thread.
[[nodiscard]] CaseResult run_isolated(const Case& verification_case, const IsolationLimits& limits,
                                      const std::function<CaseResult()>& run);

}  // namespace sunder::verification
