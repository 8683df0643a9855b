#pragma once
/// Ten numbers that should appear: whether an installation is sound, in seconds.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/harness/case_result.hpp"

namespace sunder::verification {

/// A check of a case, and what its number is called.
struct DoctorNumber {
  std::string words;
  std::string case_id;
  std::string check;
  int digits = 6;  ///< to print, 1 … 17
};

struct DoctorReading {
  DoctorNumber number;
  CheckOutcome outcome;  ///< status checked_nothing where the case gave no such check
  bool right() const { return !fails(outcome.status); }
};

/// Reads `[[number]]` tables with words, case, check and digits. Throws CaseError with file, line and key.
[[nodiscard]] std::vector<DoctorNumber> read_doctor_numbers(const std::filesystem::path& file);

/// Runs each case that the numbers name once, through `run` (its argument is the id of a case), in their order.
[[nodiscard]] std::vector<DoctorReading> read_numbers(const std::vector<DoctorNumber>& numbers,
                                                      const std::function<CaseResult(const std::string&)>& run);

/// A line a number, what is wrong with those that are not right, and the verdict on the installation.
[[nodiscard]] std::string doctor_text(const std::vector<DoctorReading>& readings, double seconds);

}  // namespace sunder::verification
