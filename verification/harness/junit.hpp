#pragma once
/// The results as JUnit XML, as build servers read it: a suite a family, a test a case.

#include <filesystem>
#include <string>
#include <vector>

#include "verification/harness/case_result.hpp"

namespace sunder::verification {

[[nodiscard]] std::string junit_xml(const std::vector<CaseResult>& results);
void write_junit(const std::filesystem::path& file, const std::vector<CaseResult>& results);

}  // namespace sunder::verification
