#pragma once
/// The record of a case: one line of JSON, appended to a file that only grows. Its schema is record.schema.json.

#include <filesystem>
#include <string>

#include "verification/harness/case_result.hpp"
#include "verification/harness/runner.hpp"

namespace sunder::verification {

/// Where a record comes from; no names of machines or folders.
struct Environment {
  std::string commit;    ///< empty where unknown
  std::string compiler;  ///< name and version
  std::string machine;   ///< coarse class: "x86-64, 2 cores"
  int threads = 1;
  bool faulted = false;  ///< from the program with planted faults
};
[[nodiscard]] Environment environment(int threads, std::string commit);

/// One line, without its end. What is not a number is written as null.
[[nodiscard]] std::string to_json(const CaseResult& result, const Environment& from);

/// The inverse of to_json, without the environment. Throws std::runtime_error where the line is no record.
[[nodiscard]] CaseResult from_json(const std::string& line);

/// Appends the line and its end in one write.
void append(const std::filesystem::path& file, const std::string& line);

/// The pins of a case stand beside it as <name>.pins.json; empty where there is no such file.
[[nodiscard]] Pins read_pins(const Case& verification_case);
void write_pins(const Case& verification_case, const CaseResult& result);

}  // namespace sunder::verification
