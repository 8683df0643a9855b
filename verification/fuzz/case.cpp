/// Any text is a case with its settings and formulas, or refused with CaseError; a formula that cannot be evaluated is
/// refused with std::invalid_argument.

#include <stdexcept>
#include <string>

#include "verification/fuzz/input_file.hpp"
#include "verification/fuzz/try_bytes.hpp"
#include "verification/harness/case.hpp"
#include "verification/harness/expression.hpp"

namespace {

using namespace sunder::verification;

void try_formula(const std::string& formula) {
  try {
    static_cast<void>(evaluate(formula, [](std::string_view) { return Values{0.5, 2.0}; }));
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sunder::fuzz::InputFile input("demo/number.case.toml");
  try {
    const Case entry = read_case(input.write({data, size}), {input.folder(), input.folder()});
    static_cast<void>(settings(entry));
    for (const Reference& reference : entry.references) try_formula(reference.expression);
    for (const Check& check : entry.checks) try_formula(check.quantity);
  } catch (const CaseError&) {
  }
  return 0;
}
