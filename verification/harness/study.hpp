#pragma once
/// A study turns one setting of a case into quantities: it runs a scene, or exercises one part of the solver directly.

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "solver/results/run_summary.hpp"
#include "verification/harness/case.hpp"

namespace sunder::verification {

struct StudyInput {
  const Case& verification_case;
  Setting scene_keys;  ///< the case's overrides, then the setting's: later ones win
  Setting parameters;  ///< likewise, without the prefix "parameters."
  int threads = 1;
};

/// A parameter that must be there. Throws CaseError with its name where it is missing or of another kind.
double number_parameter(const StudyInput& input, std::string_view name);
double number_parameter(const StudyInput& input, std::string_view name, double otherwise);
std::string text_parameter(const StudyInput& input, std::string_view name);
std::string text_parameter(const StudyInput& input, std::string_view name, std::string otherwise);

struct StudyOutput {
  results::RunSummary summary;  ///< `status` other than "completed" means that the numbers did not come out
  std::string refusal;          ///< why the program declined, where it did; then there are no quantities
};

/// May throw: std::invalid_argument counts as a refusal with its message, std::bad_alloc as out of memory, any other
/// exception as a crash.
using Study = std::function<StudyOutput(const StudyInput&)>;
using Studies = std::map<std::string, Study, std::less<>>;

/// The studies that the program knows, by the name that `study` gives in a case.
const Studies& studies();

}  // namespace sunder::verification
