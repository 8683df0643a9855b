#include "verification/harness/doctor.hpp"

#include <algorithm>
#include <map>

#include "verification/harness/case_document.hpp"
#include "verification/harness/case_table.hpp"
#include "verification/harness/report_text.hpp"

namespace sunder::verification {
namespace {

CheckOutcome outcome_of(const CaseResult& result, const std::string& check) {
  const auto found = std::find_if(result.checks.begin(), result.checks.end(),
                                  [&](const CheckOutcome& outcome) { return outcome.name == check; });
  if (found != result.checks.end()) return *found;
  CheckOutcome missing;
  missing.name = check;
  missing.status = fails(result.status) ? result.status : Status::checked_nothing;
  missing.message = result.message.empty() ? "the case has no check of this name" : result.message;
  return missing;
}

}  // namespace

std::vector<DoctorNumber> read_doctor_numbers(const std::filesystem::path& file) {
  const std::string shown = file.filename().string();
  const Node document = parse_case(file, shown);
  CaseTable top(document, shown, "");
  std::vector<DoctorNumber> numbers;
  for (const Node& entry : top.tables("number")) {
    CaseTable table(entry, shown, "number.");
    DoctorNumber number{table.text("words"), table.text("case"), table.text("check"), table.whole("digits", 6, 1)};
    if (number.digits > 17) table.fail_here("digits", "a double has no more than 17");
    table.finish();
    numbers.push_back(std::move(number));
  }
  top.finish();
  if (numbers.empty()) top.fail_at(1, "number", "is missing; expected at least one [[number]]");
  return numbers;
}

std::vector<DoctorReading> read_numbers(const std::vector<DoctorNumber>& numbers,
                                        const std::function<CaseResult(const std::string&)>& run) {
  std::map<std::string, CaseResult> results;
  std::vector<DoctorReading> readings;
  for (const DoctorNumber& number : numbers) {
    auto found = results.find(number.case_id);
    if (found == results.end()) found = results.emplace(number.case_id, run(number.case_id)).first;
    readings.push_back({number, outcome_of(found->second, number.check)});
  }
  return readings;
}

std::string doctor_text(const std::vector<DoctorReading>& readings, double seconds) {
  std::string text;
  long wrong = 0;
  for (const auto& [number, outcome] : readings) {
    text += std::string(word(outcome.status)) + "  " + number.words + "\n";
    if (outcome.compared > 0)
      text += "      " + short_number(outcome.value, number.digits) + ", should be " +
              short_number(outcome.reference, number.digits) + ": error " + short_number(outcome.error, 2) +
              ", tolerance " + short_number(outcome.tolerance, 2) + "  (" + number.case_id + ")\n";
    if (fails(outcome.status) && !outcome.message.empty()) text += "      " + outcome.message + "\n";
    wrong += fails(outcome.status) ? 1 : 0;
  }
  text += short_number(static_cast<double>(readings.size())) + " numbers in " + short_number(seconds, 2) + " s: ";
  if (wrong == 0) return text + "this installation is sound.\n";
  return text + std::to_string(wrong) + (wrong == 1 ? " is" : " are") +
         " wrong: do not use this installation. `sunder-verify run <case>` says more.\n";
}

}  // namespace sunder::verification
