#include "verification/harness/study.hpp"

namespace sunder::verification {
namespace {

const Literal* find(const Setting& setting, std::string_view name) {
  const Literal* found = nullptr;
  for (const auto& [key, value] : setting)
    if (key == name) found = &value;  // the last one wins
  return found;
}

[[noreturn]] void fail(const StudyInput& input, std::string_view name, const char* accepted) {
  throw CaseError(input.verification_case.id + ": parameters." + std::string(name) + ": study \"" +
                  input.verification_case.study + "\" needs " + accepted);
}

}  // namespace

double number_parameter(const StudyInput& input, std::string_view name) {
  const Literal* literal = find(input.parameters, name);
  if (!literal || !literal->number) fail(input, name, "a number");
  return *literal->number;
}

double number_parameter(const StudyInput& input, std::string_view name, double otherwise) {
  return find(input.parameters, name) ? number_parameter(input, name) : otherwise;
}

std::string text_parameter(const StudyInput& input, std::string_view name) {
  const Literal* literal = find(input.parameters, name);
  if (!literal || !literal->words) fail(input, name, "a text");
  return *literal->words;
}

std::string text_parameter(const StudyInput& input, std::string_view name, std::string otherwise) {
  return find(input.parameters, name) ? text_parameter(input, name) : std::move(otherwise);
}

}  // namespace sunder::verification
