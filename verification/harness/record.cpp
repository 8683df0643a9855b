#include "verification/harness/record.hpp"

#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

namespace sunder::verification {
namespace {

using Json = nlohmann::ordered_json;

double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}
/// A fraction, or what no whole number holds, is not cut off in silence.
template <class Integer = int>
Integer whole(const Json& json) {
  const bool fits = json.is_number_unsigned()
                        ? std::in_range<Integer>(json.get<std::uint64_t>())
                        : json.is_number_integer() && std::in_range<Integer>(json.get<std::int64_t>());
  if (!fits) throw std::runtime_error(json.dump() + " is no whole number that is accepted here");
  return json.get<Integer>();
}
std::vector<double> number_list(const Json& json) {
  std::vector<double> values;
  for (const Json& entry : json) values.push_back(number(entry));
  return values;
}
Status status(const Json& json) {
  const auto found = status_of(json.get<std::string>());
  if (!found) throw std::runtime_error("unknown status " + json.get<std::string>());
  return *found;
}

template <class Enumerator>
Enumerator by_word(const Json& json, std::initializer_list<Enumerator> choices) {
  for (const Enumerator choice : choices)
    if (word(choice) == json.get<std::string>()) return choice;
  throw std::runtime_error("unknown word " + json.get<std::string>());
}

Json reference_json(const Reference& reference) {
  Json json{{"name", reference.name},
            {"class", word(reference.kind)},
            {"unit", reference.unit},
            {"source", reference.source},
            {"locator", reference.locator},
            {"uncertainty", reference.uncertainty},
            {"uncertainty_is_relative", reference.uncertainty_is_relative}};
  if (reference.expression.empty())
    json["values"] = reference.values;
  else
    json["expression"] = reference.expression;
  if (!reference.abscissae.empty()) json["abscissae"] = reference.abscissae;
  return json;
}

Reference reference_from(const Json& json) {
  Reference reference;
  reference.name = json.at("name");
  reference.kind =
      by_word(json.at("class"), {ReferenceClass::exact, ReferenceClass::high_precision, ReferenceClass::cross_code,
                                 ReferenceClass::published, ReferenceClass::self});
  reference.unit = json.at("unit");
  reference.source = json.at("source");
  reference.locator = json.at("locator");
  reference.uncertainty = json.at("uncertainty");
  reference.uncertainty_is_relative = json.at("uncertainty_is_relative");
  if (json.contains("values")) reference.values = number_list(json["values"]);
  if (json.contains("expression")) reference.expression = json["expression"];
  if (json.contains("abscissae")) reference.abscissae = number_list(json["abscissae"]);
  return reference;
}

Json order_json(const OrderEstimate& order) {
  return {{"convergence", word(order.convergence)},
          {"order", order.order},
          {"pairwise", order.pairwise},
          {"extrapolated", order.extrapolated},
          {"convergence_index", order.convergence_index},
          {"levels_used", order.levels_used}};
}

OrderEstimate order_from(const Json& json) {
  return {by_word(json.at("convergence"),
                  {Convergence::monotone, Convergence::oscillatory, Convergence::divergent, Convergence::at_floor}),
          number(json.at("order")),
          number_list(json.at("pairwise")),
          number(json.at("extrapolated")),
          number(json.at("convergence_index")),
          whole(json.at("levels_used"))};
}

Json check_json(const CheckOutcome& check) {
  Json json{{"name", check.name},           {"kind", check.kind},           {"gates", check.gates},
            {"status", word(check.status)}, {"evidence", check.evidence},   {"basis", check.basis},
            {"value", check.value},         {"reference", check.reference}, {"error", check.error},
            {"tolerance", check.tolerance}, {"slack", check.slack},         {"compared", check.compared},
            {"setting", check.setting}};
  if (!check.message.empty()) json["message"] = check.message;
  for (const OrderEstimate& order : check.orders) json["orders"].push_back(order_json(order));
  return json;
}

CheckOutcome check_from(const Json& json) {
  CheckOutcome check;
  check.name = json.at("name");
  check.kind = json.at("kind");
  check.gates = json.at("gates");
  check.status = status(json.at("status"));
  check.evidence = json.at("evidence");
  check.basis = json.at("basis");
  check.value = number(json.at("value"));
  check.reference = number(json.at("reference"));
  check.error = number(json.at("error"));
  check.tolerance = number(json.at("tolerance"));
  check.slack = number(json.at("slack"));
  check.compared = whole(json.at("compared"));
  check.setting = whole(json.at("setting"));
  check.message = json.value("message", "");
  if (json.contains("orders"))
    for (const Json& order : json["orders"]) check.orders.push_back(order_from(order));
  return check;
}

Json setting_json(const SettingRow& row) {
  Json keys = Json::object(), errors = Json::object(), counts = Json::object(), parts = Json::array();
  for (const auto& [key, text] : row.keys) keys[key] = text;
  for (const auto& [name, error] : row.errors) errors[name] = error;
  for (const auto& [name, count] : row.counts) counts[name] = count;
  for (const auto& part : row.parts)
    parts.push_back({{"part", part.part},
                     {"calls", part.calls},
                     {"bytes", part.bytes},
                     {"matrix_entries", part.matrix_entries},
                     {"seconds", part.seconds}});
  Json json{{"keys", keys},
            {"default", row.standard},
            {"status", word(row.status)},
            {"errors", errors},
            {"cpu_seconds", row.cpu_seconds},
            {"cpu_spread", row.cpu_spread},
            {"repeats", row.repeats},
            {"dofs", row.dofs},
            {"peak_bytes", row.peak_bytes},
            {"parts", parts},
            {"counts", counts}};
  if (!row.message.empty()) json["message"] = row.message;
  return json;
}

SettingRow setting_from(const Json& json) {
  SettingRow row;
  for (const auto& [key, text] : json.at("keys").items()) row.keys.emplace_back(key, text.get<std::string>());
  for (const auto& [name, error] : json.at("errors").items()) row.errors.emplace_back(name, number(error));
  for (const auto& [name, count] : json.at("counts").items()) row.counts.emplace_back(name, whole<long long>(count));
  for (const Json& part : json.at("parts"))
    row.parts.push_back({part.at("part"), whole<long>(part.at("calls")), whole<long long>(part.at("matrix_entries")),
                         number(part.at("seconds")), whole<long long>(part.at("bytes"))});
  row.standard = json.at("default");
  row.status = status(json.at("status"));
  row.cpu_seconds = number(json.at("cpu_seconds"));
  row.cpu_spread = number(json.at("cpu_spread"));
  row.repeats = whole(json.at("repeats"));
  row.dofs = whole<long>(json.at("dofs"));
  row.peak_bytes = whole<long>(json.at("peak_bytes"));
  row.message = json.value("message", "");
  return row;
}

NegativeOutcome negative_from(const Json& json) {
  using Verdict = NegativeOutcome::Verdict;
  return {
      json.at("fault"), json.at("checks"), json.at("red"), json.at("reached"),
      by_word(json.at("verdict"), {Verdict::killed, Verdict::survived, Verdict::never_reached, Verdict::no_baseline})};
}

std::filesystem::path pins_file(const Case& verification_case) {
  std::string name = verification_case.file.filename().string();
  name.resize(name.size() - std::string(".case.toml").size());
  return verification_case.file.parent_path() / (name + ".pins.json");
}

}  // namespace

Environment environment(int threads, std::string commit) {
  Environment here;
  here.commit = std::move(commit);
  here.threads = threads;
#ifdef __clang__
  here.compiler = "clang " __clang_version__;
#else
  here.compiler = "gcc " __VERSION__;
#endif
#ifdef __x86_64__
  const std::string architecture = "x86-64";
#else
  const std::string architecture = "other";
#endif
  here.machine = architecture + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
  return here;
}

std::string to_json(const CaseResult& result, const Environment& from) {
  Json json{{"record", 1},
            {"id", result.id},
            {"version", result.version},
            {"family", result.family},
            {"tier", result.tier},
            {"title", result.title},
            {"requirement", result.requirement},
            {"status", word(result.status)},
            {"message", result.message},
            {"cpu_seconds", result.cpu_seconds},
            {"peak_bytes", result.peak_bytes},
            {"environment",
             {{"commit", from.commit},
              {"compiler", from.compiler},
              {"machine", from.machine},
              {"threads", from.threads},
              {"faulted", from.faulted}}}};
  json["references"] = Json::array();
  for (const Reference& reference : result.references) json["references"].push_back(reference_json(reference));
  json["checks"] = Json::array();
  for (const CheckOutcome& check : result.checks) json["checks"].push_back(check_json(check));
  json["sweep"] = {{"error", result.error_check}, {"series", result.series}};
  json["settings"] = Json::array();
  for (const SettingRow& row : result.settings) json["settings"].push_back(setting_json(row));
  if (result.first_failing_rung) json["first_failing_rung"] = *result.first_failing_rung;
  json["pins"] = Json::object();
  for (const auto& [name, values] : result.pins) json["pins"][name] = values;
  for (const auto& [name, digits] : result.digits_trusted) json["digits_trusted"][name] = digits;
  json["negatives"] = Json::array();
  for (const NegativeOutcome& negative : result.negatives)
    json["negatives"].push_back({{"fault", negative.fault},
                                 {"checks", negative.checks},
                                 {"red", negative.red},
                                 {"reached", negative.reached},
                                 {"verdict", word(negative.verdict)}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // a message need not be valid UTF-8
}

CaseResult from_json(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CaseResult result;
    result.id = json.at("id");
    result.version = whole(json.at("version"));
    result.family = json.at("family");
    result.tier = json.at("tier");
    result.title = json.at("title");
    result.requirement = json.at("requirement");
    result.status = status(json.at("status"));
    result.message = json.at("message");
    result.cpu_seconds = number(json.at("cpu_seconds"));
    result.peak_bytes = whole<long>(json.at("peak_bytes"));
    for (const Json& reference : json.at("references")) result.references.push_back(reference_from(reference));
    for (const Json& check : json.at("checks")) result.checks.push_back(check_from(check));
    result.error_check = json.at("sweep").at("error");
    result.series = json.at("sweep").at("series");
    for (const Json& row : json.at("settings")) result.settings.push_back(setting_from(row));
    if (json.contains("first_failing_rung")) result.first_failing_rung = whole(json["first_failing_rung"]);
    for (const auto& [name, values] : json.at("pins").items()) result.pins.emplace_back(name, number_list(values));
    if (json.contains("digits_trusted"))
      for (const auto& [name, digits] : json["digits_trusted"].items())
        result.digits_trusted.emplace_back(name, number(digits));
    for (const Json& negative : json.at("negatives")) result.negatives.push_back(negative_from(negative));
    return result;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("this is no record of a case: ") + error.what());
  }
}

void append(const std::filesystem::path& file, const std::string& line) {
  if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::app);
  stream << line + "\n" << std::flush;
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

Pins read_pins(const Case& verification_case) {
  Pins pins;
  std::ifstream stream(pins_file(verification_case));
  if (!stream) return pins;
  try {
    const Json json = Json::parse(stream);
    for (const auto& [name, values] : json.items()) pins[name] = number_list(values);
  } catch (const Json::exception& error) {
    throw CaseError(verification_case.id + ".pins.json: " + error.what());
  }
  return pins;
}

void write_pins(const Case& verification_case, const CaseResult& result) {
  if (result.pins.empty()) return;
  Json json = Json::object();
  for (const auto& [name, values] : result.pins) json[name] = values;
  std::ofstream stream(pins_file(verification_case));
  stream << json.dump(2) << "\n";
  if (!stream) throw std::runtime_error(verification_case.id + ".pins.json: cannot be written");
}

}  // namespace sunder::verification
