#pragma once
/// Is there evidence that every check can fail, and that every planted fault is noticed? Read from the cases alone.

#include <filesystem>
#include <string>
#include <vector>

#include "verification/harness/case.hpp"

namespace sunder::verification {

struct FaultCoverage {
  std::string text;  ///< each fault of the solver with the cases that name it, then what is wrong
  std::vector<std::string> unnamed_faults;  ///< of the solver, named by no case: they prove nothing
  std::vector<std::string> unknown_faults;  ///< "fault, named by case": the solver plants none of this name
  std::vector<std::string> idle_checks;     ///< "case: check": it gates, and no [[negative]] shows that it can fail
  std::vector<std::string> new_idle;        ///< of these, not on the list
  std::vector<std::string> stale;           ///< on the list, and idle no more: the list only grows shorter

  bool sound() const { return unnamed_faults.empty() && unknown_faults.empty() && new_idle.empty() && stale.empty(); }
};

/// `faults`: those of the solver (fault_names.hpp). `listed`: idle checks that are known.
[[nodiscard]] FaultCoverage fault_coverage(const std::vector<Case>& cases, const std::vector<std::string>& faults,
                                           const std::vector<std::string>& listed);

/// The lines of a list of idle checks, without comments and empty ones; none where there is no file.
[[nodiscard]] std::vector<std::string> read_idle_checks(const std::filesystem::path& file);
void write_idle_checks(const std::filesystem::path& file, const std::vector<std::string>& idle_checks);

}  // namespace sunder::verification
