#pragma once
/// Runs a case in this process: every setting of its sweep, then every check.

#include <map>
#include <string>
#include <vector>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"
#include "verification/harness/study.hpp"

namespace sunder::verification {

/// Our own earlier values of a case, by the name of the check; "first_failing_rung" for a ladder.
using Pins = std::map<std::string, std::vector<double>, std::less<>>;

struct RunnerOptions {
  int threads = 1;
  Pins pins = {};
  std::string today = {};  ///< ISO date; known limits that expire on it, or before, count as failures
  bool repeat = false;     ///< repeat each setting until the median of its CPU time is settled
  double spread = 0.05;    ///< … that is, half-width of its 95 % interval ≤ spread · median
  int most_repeats = 31;
  double most_seconds = 2.0;  ///< CPU seconds after which a setting is not repeated again
  int other_threads = 0;      ///< > 0: each setting runs once more with so many threads and must give the same bits
  bool trap = false;          ///< what makes a NaN or an infinity in a study ends the process (float_traps.hpp)
};

/// Never throws for what the study does: that is a status. The result of every repeat must be the same bits.
[[nodiscard]] CaseResult run_case(const Case& verification_case, const Study& study, const RunnerOptions& options = {});

/// The result of a case that never came to its checks.
[[nodiscard]] CaseResult unfinished(const Case& verification_case, Status status, std::string message);

}  // namespace sunder::verification
