// The one place of the solver that includes nlohmann-json.
#include "solver/results/summary_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/results/environment.hpp"

namespace sunder::results {
namespace {

using Json = nlohmann::ordered_json;

void collect_not_finite(const Quantity& quantity, const std::string& path, std::vector<std::string>& found) {
  if (const double* number = quantity.number()) {
    if (!std::isfinite(*number)) found.push_back(path);
  } else if (const Quantity::List* list = quantity.list()) {
    for (std::size_t i = 0; i < list->size(); ++i)
      collect_not_finite((*list)[i], path + "[" + std::to_string(i) + "]", found);
  } else if (const Quantity::Table* table = quantity.table()) {
    for (const auto& [name, value] : *table) collect_not_finite(value, path.empty() ? name : path + "." + name, found);
  }
}

/// nlohmann writes the shortest digits that read back to the same double (Grisu2), and null for what is not finite.
Json json_of(const Quantity& quantity) {
  if (const double* number = quantity.number()) return *number;
  if (const std::string* text = quantity.text()) return *text;
  if (const Quantity::List* list = quantity.list()) {
    Json json = Json::array();
    for (const Quantity& value : *list) json.push_back(json_of(value));
    return json;
  }
  Json json = Json::object();
  for (const auto& [name, value] : *quantity.table()) json[name] = json_of(value);
  return json;
}

template <class Value>
Json json_of(const std::vector<std::pair<std::string, Value>>& entries) {
  Json json = Json::object();
  for (const auto& [name, value] : entries) json[name] = value;
  return json;
}

Json json_of(const std::vector<PartCost>& parts) {
  Json json = Json::array();
  for (const PartCost& part : parts)
    json.push_back({{"part", part.part},
                    {"calls", part.calls},
                    {"bytes", part.bytes},
                    {"matrix_entries", part.matrix_entries},
                    {"seconds", part.seconds}});
  return json;
}

}  // namespace

std::vector<std::string> not_finite(const Quantity& quantity) {
  std::vector<std::string> found;
  collect_not_finite(quantity, "", found);
  return found;
}

void stop_if_not_finite(RunSummary& summary) {
  std::vector<std::string> found = not_finite(summary.quantities);
  if (summary.history)
    for (const std::string& column : not_finite(*summary.history)) found.push_back("history: " + column);
  if (found.empty()) return;
  if (summary.completed()) summary.status = "stopped: " + found.front() + " is not a finite number";
  for (const std::string& path : found) {
    const std::string warning = path + " is not a finite number";
    if (std::find(summary.warnings.begin(), summary.warnings.end(), warning) == summary.warnings.end())
      summary.warnings.push_back(warning);
  }
}

std::string to_json(const RunSummary& given) {
  RunSummary summary = given;
  stop_if_not_finite(summary);
  const Environment built = environment();
  Json json;
  json["name"] = summary.name;
  json["analysis"] = summary.analysis;
  json["status"] = summary.status;
  json["parts"] = json_of(summary.parts);
  json["mesh"] = {{"polygons", summary.mesh.polygons}, {"nodes", summary.mesh.nodes}, {"dofs", summary.mesh.dofs}};
  json["quantities"] = json_of(summary.quantities);
  json["counts"] = json_of(summary.counts);
  json["seconds"] = json_of(summary.seconds);
  json["environment"] = {
      {"version", built.version}, {"compiler", built.compiler}, {"flags", built.flags}, {"threads", summary.threads}};
  json["warnings"] = summary.warnings;
  // A name that is not UTF-8 must not cost the results: such bytes are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sunder::results
