#include "verification/harness/fault_coverage.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

namespace sunder::verification {
namespace {

bool named(const Case& verification_case, const std::string& check) {
  return std::any_of(verification_case.negatives.begin(), verification_case.negatives.end(),
                     [&](const Negative& negative) {
                       return std::find(negative.checks.begin(), negative.checks.end(), check) != negative.checks.end();
                     });
}

bool holds(const std::vector<std::string>& list, const std::string& entry) {
  return std::find(list.begin(), list.end(), entry) != list.end();
}

}  // namespace

FaultCoverage fault_coverage(const std::vector<Case>& cases, const std::vector<std::string>& faults,
                             const std::vector<std::string>& listed) {
  FaultCoverage coverage;
  std::map<std::string, std::string> cases_of;
  for (const Case& entry : cases) {
    for (const Negative& negative : entry.negatives) cases_of[negative.fault] += " " + entry.id;
    for (const Check& check : entry.checks)
      if (check.gates && !named(entry, check.name)) coverage.idle_checks.push_back(entry.id + ": " + check.name);
  }
  for (const std::string& fault : faults) {
    const auto found = cases_of.find(fault);
    coverage.text += fault + ":" + (found == cases_of.end() ? " NO CASE" : found->second) + "\n";
    if (found == cases_of.end())
      coverage.unnamed_faults.push_back(fault);
    else
      cases_of.erase(found);
  }
  for (const auto& [fault, ids] : cases_of) coverage.unknown_faults.push_back(fault + ", named by" + ids);
  for (const std::string& fault : coverage.unknown_faults) coverage.text += "NOT IN THE SOLVER: " + fault + "\n";
  for (const std::string& check : coverage.idle_checks)
    if (!holds(listed, check)) coverage.new_idle.push_back(check);
  for (const std::string& check : listed)
    if (!holds(coverage.idle_checks, check)) coverage.stale.push_back(check);
  for (const std::string& check : coverage.new_idle) coverage.text += "NO FAULT FOR THE CHECK " + check + "\n";
  for (const std::string& check : coverage.stale) coverage.text += "LISTED AND IDLE NO MORE: " + check + "\n";
  return coverage;
}

std::vector<std::string> read_idle_checks(const std::filesystem::path& file) {
  std::vector<std::string> checks;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line.front() != '#') checks.push_back(line);
  return checks;
}

void write_idle_checks(const std::filesystem::path& file, const std::vector<std::string>& idle_checks) {
  std::ofstream stream(file);
  stream << "# Gating checks that no [[negative]] shows to be able to fail. The test verify/faults holds this list: it "
            "may\n"
            "# only grow shorter. `sunder-verify faults --write` makes it anew.\n";
  for (const std::string& check : idle_checks) stream << check << "\n";
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace sunder::verification
