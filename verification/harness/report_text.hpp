#pragma once
/// A result in words, for people at a terminal.

#include <string>

#include "verification/harness/case_result.hpp"

namespace sunder::verification {

/// The number to at most 17 digits, as short as it can be.
[[nodiscard]] std::string short_number(double value, int digits = 6);

/// One line for the case, one for each check and each setting that did not run through, one for each planted fault.
[[nodiscard]] std::string report_text(const CaseResult& result);

}  // namespace sunder::verification
