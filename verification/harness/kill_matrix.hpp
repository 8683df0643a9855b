#pragma once
/// Which check notices which planted fault: every fault that a case's run comes by, planted alone, against every check
/// of the case. Measured, where `[[negative]]` (negatives.hpp) is a promise that is held.

#include <string>
#include <utility>
#include <vector>

#include "verification/harness/case.hpp"
#include "verification/harness/case_result.hpp"
#include "verification/harness/faults.hpp"
#include "verification/harness/negatives.hpp"
#include "verification/harness/record.hpp"

namespace sunder::verification {

/// What one fault does to a case.
struct FaultEffect {
  std::string fault;
  std::vector<std::pair<std::string, Status>>
      red;                   ///< checks that pass without it and fail with it, in the case's order
  double cpu_seconds = 0.0;  ///< of the run with the fault; 0 where it ended without a word
};

struct KillMatrix {
  std::string id, family, tier;
  int version = 1;
  Status baseline = Status::checked_nothing;                            ///< of the run without a fault
  double cpu_seconds = 0.0;                                             ///< of that run
  std::vector<std::pair<std::string, std::string>> gating_checks = {};  ///< name and kind of every check that gates
  std::vector<FaultEffect> effects =
      {};  ///< of the faults that the run comes by, by name; none where the baseline fails
};

/// Runs the case once and listens which faults its code asks for, then once with each; with those of `only` where it is
/// not empty. `run` as for run_negatives. A run that ends before its checks (crash, timeout) turns every check red,
/// with that status.
[[nodiscard]] KillMatrix kill_matrix(const Case& verification_case, const FaultControl& faults, const RunCase& run,
                                     const std::vector<std::string>& only = {});

/// One line of JSON; its keys are described in verification/harness/kill-matrix.schema.json.
[[nodiscard]] std::string to_json(const KillMatrix& matrix, const Environment& from);

/// Faults that the checks notice and checks that no fault turns red, in words.
[[nodiscard]] std::string report_text(const KillMatrix& matrix);

}  // namespace sunder::verification
