#include "verification/harness/kill_matrix.hpp"

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

namespace sunder::verification {
namespace {

bool red(Status status) {
  return fails(status) || status == Status::known_limit;
}

const CheckOutcome* find(const CaseResult& result, const std::string& name) {
  const auto found = std::find_if(result.checks.begin(), result.checks.end(),
                                  [&](const CheckOutcome& check) { return check.name == name; });
  return found == result.checks.end() ? nullptr : &*found;
}

FaultEffect effect_of(const std::string& fault, const CaseResult& baseline, const CaseResult& with_fault) {
  FaultEffect effect{fault, {}, with_fault.cpu_seconds};
  const bool ended_early = with_fault.checks.empty() && fails(with_fault.status);
  for (const CheckOutcome& before : baseline.checks) {
    if (red(before.status)) continue;
    const CheckOutcome* after = find(with_fault, before.name);
    if (ended_early)
      effect.red.emplace_back(before.name, with_fault.status);
    else if (after && red(after->status))
      effect.red.emplace_back(before.name, after->status);
  }
  return effect;
}

}  // namespace

KillMatrix kill_matrix(const Case& verification_case, const FaultControl& faults, const RunCase& run,
                       const std::vector<std::string>& only) {
  KillMatrix matrix{.id = verification_case.id,
                    .family = verification_case.family,
                    .tier = std::string(word(verification_case.tier)),
                    .version = verification_case.version};
  for (const Check& check : verification_case.checks)
    if (check.gates) matrix.gating_checks.emplace_back(check.name, word(check.kind));
  // The names come home from the child as if each were a negative that was reached.
  const CaseResult baseline =
      run([&] { faults.listen(); },
          [&](CaseResult& result) {
            for (const std::string& name : faults.heard())
              result.negatives.push_back({name, {}, {}, true, NegativeOutcome::Verdict::survived});
            faults.plant("");
          });
  matrix.baseline = baseline.status;
  matrix.cpu_seconds = baseline.cpu_seconds;
  if (fails(baseline.status)) return matrix;
  for (const NegativeOutcome& asked : baseline.negatives) {
    if (!only.empty() && std::find(only.begin(), only.end(), asked.fault) == only.end()) continue;
    const CaseResult result =
        run([&] { faults.plant(asked.fault); }, [&](CaseResult& /*result*/) { faults.plant(""); });
    matrix.effects.push_back(effect_of(asked.fault, baseline, result));
  }
  return matrix;
}

std::string to_json(const KillMatrix& matrix, const Environment& from) {
  using Json = nlohmann::ordered_json;
  Json json{{"kill_matrix", 1},
            {"id", matrix.id},
            {"version", matrix.version},
            {"family", matrix.family},
            {"tier", matrix.tier},
            {"commit", from.commit},
            {"baseline", word(matrix.baseline)},
            {"cpu_seconds", matrix.cpu_seconds}};
  json["gating_checks"] = Json::object();
  for (const auto& [name, kind] : matrix.gating_checks) json["gating_checks"][name] = kind;
  json["faults"] = Json::array();
  for (const FaultEffect& effect : matrix.effects) {
    Json red = Json::object();
    for (const auto& [name, status] : effect.red) red[name] = word(status);
    json["faults"].push_back({{"fault", effect.fault}, {"red", red}, {"cpu_seconds", effect.cpu_seconds}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string report_text(const KillMatrix& matrix) {
  const auto noticed = std::count_if(matrix.effects.begin(), matrix.effects.end(),
                                     [](const FaultEffect& effect) { return !effect.red.empty(); });
  std::ostringstream text;
  text << matrix.id << ": " << word(matrix.baseline) << "; " << matrix.effects.size() << " faults reached, " << noticed
       << " noticed\n";
  for (const auto& [name, kind] : matrix.gating_checks) {
    const std::string& wanted = name;
    const bool killed = std::any_of(matrix.effects.begin(), matrix.effects.end(), [&](const FaultEffect& effect) {
      return std::any_of(effect.red.begin(), effect.red.end(),
                         [&](const auto& entry) { return entry.first == wanted; });
    });
    if (!killed) text << "  " << name << " (" << kind << "): no fault turns it red\n";
  }
  return text.str();
}

}  // namespace sunder::verification
