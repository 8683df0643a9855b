/// Any line is a record of a case, or refused with std::runtime_error; one that was read is written and read again.

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "verification/fuzz/try_bytes.hpp"
#include "verification/harness/record.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sunder::verification;
  CaseResult result;
  try {
    result = from_json(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const std::runtime_error&) {
    return 0;
  }
  if (from_json(to_json(result, {})).checks.size() != result.checks.size()) std::abort();
  return 0;
}
