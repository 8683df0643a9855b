/// Any bytes are a table of reference data with columns of one length, or refused with std::runtime_error.

#include <cstdlib>
#include <stdexcept>

#include "verification/fuzz/input_file.hpp"
#include "verification/fuzz/try_bytes.hpp"
#include "verification/harness/csv.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sunder::fuzz::InputFile input("table.csv");
  try {
    const sunder::verification::Csv csv = sunder::verification::read_csv(input.write({data, size}));
    if (csv.names.size() != csv.columns.size()) std::abort();
    for (const auto& column : csv.columns)
      if (column.size() != csv.columns.front().size()) std::abort();
  } catch (const std::runtime_error&) {
  }
  return 0;
}
