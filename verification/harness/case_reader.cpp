#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "verification/harness/case.hpp"
#include "verification/harness/case_checks.hpp"
#include "verification/harness/case_document.hpp"
#include "verification/harness/case_table.hpp"
#include "verification/harness/csv.hpp"

namespace sunder::verification {
namespace {

Literal literal(const Node& node) {
  Literal result;
  result.text = node.notation;
  if (node.is_number()) {
    result.number = node.number;
    result.numbers = {node.number};
  } else if (node.kind == Node::Kind::text) {
    result.words = node.text;
  }
  for (const Node& entry : node.list) {
    const std::vector<double> inner = literal(entry).numbers;
    result.numbers.insert(result.numbers.end(), inner.begin(), inner.end());
  }
  return result;
}

/// Leaves of nested tables under dotted keys.
template <class Visit>
void for_each_leaf(const Node& table, const std::string& prefix, const Visit& visit) {
  for (const auto& [key, node] : table.table) {
    if (node.kind == Node::Kind::table)
      for_each_leaf(node, prefix + key + ".", visit);
    else
      visit(prefix + key, node);
  }
}

Setting read_setting(CaseTable& parent, std::string_view key) {
  Setting result;
  if (const Node* node = parent.table(key))
    for_each_leaf(*node, "",
                  [&](const std::string& path, const Node& leaf) { result.emplace_back(path, literal(leaf)); });
  return result;
}

void read_uncertainty(CaseTable& table, Reference& reference) {
  const Node& node = table.need("uncertainty", "a number in the reference's unit, or a text like \"0.5 %\",");
  if (node.kind == Node::Kind::text) {
    const std::string& given = node.text;
    std::istringstream stream(given);
    std::string sign;
    if (!(stream >> reference.uncertainty >> sign) || sign != "%")
      table.fail(node, "uncertainty", "\"" + given + "\" is not a percentage like \"0.5 %\"");
    reference.uncertainty /= 100.0;
    reference.uncertainty_is_relative = true;
  } else {
    reference.uncertainty = table.number("uncertainty");
  }
  const bool may_be_certain = reference.kind == ReferenceClass::exact || reference.kind == ReferenceClass::self;
  if (!(reference.uncertainty >= 0.0) || (reference.uncertainty == 0.0 && !may_be_certain))
    table.fail(node, "uncertainty", "only an exact reference has none; a number > 0 is needed");
}

void read_reference_csv(CaseTable& table, const Node& node, const CaseFolders& folders, Reference& reference) {
  Csv csv;
  try {
    csv = read_csv(folders.reference_data / table.text_of(node, "csv"));
  } catch (const std::runtime_error& error) {
    table.fail(node, "csv", error.what());
  }
  const auto column = [&](std::string_view key) {
    const std::string name = table.text(key);
    const std::vector<double>* values = csv.column(name);
    if (!values) table.fail(node, key, "the file has no column \"" + name + "\"");
    return *values;
  };
  reference.values = column("column");
  if (table.find("abscissa")) reference.abscissae = column("abscissa");
  if (table.find("rows")) {  // indices of the rows that are meant
    std::vector<double> values, abscissae;
    for (const double row : table.numbers("rows")) {
      if (!(row >= 0.0 && row < static_cast<double>(reference.values.size())) || row != std::floor(row))
        table.fail(node, "rows",
                   "indices from 0, less than the " + std::to_string(reference.values.size()) +
                       " rows of the file, are needed");
      const auto i = static_cast<std::size_t>(row);
      values.push_back(reference.values[i]);
      if (!reference.abscissae.empty()) abscissae.push_back(reference.abscissae[i]);
    }
    reference.values = values;
    reference.abscissae = abscissae;
  }
  for (const double value : reference.values)
    if (std::isnan(value)) table.fail(node, "csv", "a field of the column is empty");
}

Reference read_reference(CaseTable table, const CaseFolders& folders) {
  Reference reference;
  reference.line = table.line();
  reference.name = table.text("name");
  reference.kind =
      table.word_of("class", {ReferenceClass::exact, ReferenceClass::high_precision, ReferenceClass::cross_code,
                              ReferenceClass::published, ReferenceClass::self});
  reference.unit = table.text("unit");
  reference.source = table.text("source");
  reference.locator = table.text("locator");
  read_uncertainty(table, reference);
  const Node* csv = table.find("csv");
  const Node* value = table.find("value");
  if (!csv == !value) table.fail_here("value", "either value or csv is needed");
  if (csv) {
    read_reference_csv(table, *csv, folders, reference);
  } else if (value->kind == Node::Kind::text) {
    reference.expression = table.text_of(*value, "value");
  } else {
    reference.values = table.numbers("value");
    if (table.find("abscissa")) {
      reference.abscissae = table.numbers("abscissa");
      if (reference.abscissae.size() != reference.values.size())
        table.fail_here("abscissa", "as many numbers as in value are needed");
    }
  }
  table.finish();
  return reference;
}

Sweep read_sweep(CaseTable table) {
  Sweep sweep;
  const std::string combine = table.text("combine", "zip");
  if (combine != "zip" && combine != "product") table.fail_here("combine", "\"zip\" or \"product\" is needed");
  sweep.product = combine == "product";
  sweep.error = table.text("error", "");
  if (table.find("series")) sweep.series = table.texts("series");
  if (table.find("default")) sweep.standard = table.whole("default", 0, 0);
  const Node& keys = table.need("keys", "a table of lists");
  table.table("keys");
  for_each_leaf(keys, "", [&](const std::string& path, const Node& leaf) {
    if (leaf.kind != Node::Kind::list || leaf.list.empty())
      table.fail(leaf, "keys." + path, "a list that is not empty is needed");
    std::vector<Literal> values;
    for (const Node& entry : leaf.list) values.push_back(literal(entry));
    if (!sweep.product && !sweep.keys.empty() && sweep.keys.front().second.size() != values.size())
      table.fail(leaf, "keys." + path, "as many values as for " + sweep.keys.front().first + " are needed");
    sweep.keys.emplace_back(path, std::move(values));
  });
  if (sweep.keys.empty()) table.fail(keys, "keys", "a sweep needs at least one key");
  constexpr double most_settings = 10'000;  // of a product, whose settings are all made before the first runs
  double product = 1.0;
  for (const auto& [key, values] : sweep.keys) product *= static_cast<double>(values.size());
  if (sweep.product && product > most_settings)
    table.fail(keys, "keys", "at most 10000 settings; these are too many combinations");
  for (const std::string& key : sweep.series)
    if (std::none_of(sweep.keys.begin(), sweep.keys.end(), [&](const auto& entry) { return entry.first == key; }))
      table.fail_here("series", "the sweep has no key \"" + key + "\"");
  table.finish();
  return sweep;
}

void read_head(CaseTable& root, Case& result) {
  result.version = root.whole("version", 1, 1);
  result.title = root.text("title");
  result.requirement = root.text("requirement");
  if (result.requirement.find("shall") == std::string::npos)
    root.fail(*root.find("requirement"), "requirement", "a sentence with \"shall\" is needed");
  result.why = root.text("why");
  result.family = root.text("family");
  if (result.id.substr(0, result.id.find('/')) != result.family)
    root.fail(*root.find("family"), "family", "\"" + result.family + "\" is not the folder of the case");
  result.tier = root.word_of("tier", {Tier::quick, Tier::full, Tier::long_});
  result.modules = root.texts("modules");
  result.study = root.text("study", "scene");
}

void read_what_runs(CaseTable& root, Case& result) {
  if (root.find("scene")) {
    const std::string scene = root.text("scene");
    result.scene = result.file.parent_path() / scene;
    if (!std::filesystem::exists(result.scene))
      root.fail(*root.find("scene"), "scene", "there is no file \"" + scene + "\"");
  }
  if (result.study == "scene" && result.scene.empty()) root.fail_here("scene", "is missing; the study runs a scene");
  result.overrides = read_setting(root, "overrides");
  result.parameters = read_setting(root, "parameters");
  if (result.scene.empty() && !result.overrides.empty()) root.fail_here("overrides", "there is no scene to override");
  if (const Node* node = root.table("needs")) {
    CaseTable needs(*node, root.file(), "needs.");
    result.needs = {needs.whole("cores", 1, 1), needs.number("memory", 0.0)};
    needs.finish();
  }
  if (const Node* node = root.table("sweep")) {
    result.sweep = read_sweep(CaseTable(*node, root.file(), "sweep."));
    const int runs = static_cast<int>(settings(result).size());
    if (result.sweep->standard && *result.sweep->standard >= runs)
      root.fail(*node, "sweep.default", "the sweep has only " + std::to_string(runs) + " settings");
  }
  if (const Node* node = root.table("ladder")) {
    if (!result.sweep) root.fail(*node, "ladder", "a ladder needs a [sweep] that climbs");
    CaseTable ladder(*node, root.file(), "ladder.");
    result.ladder = Ladder{ladder.texts("refusals")};
    ladder.finish();
  }
}

void read_negatives(CaseTable& root, Case& result) {
  for (const Node& node : root.tables("negative")) {
    CaseTable table(node, root.file(), "negative.");
    Negative negative{table.text("fault"), table.texts("checks")};
    if (negative.checks.empty()) table.fail_here("checks", "at least one check is needed");
    for (const std::string& name : negative.checks)
      if (!find_check(result, name)) table.fail_here("checks", "there is no [[check]] named \"" + name + "\"");
    table.finish();
    result.negatives.push_back(std::move(negative));
  }
}

}  // namespace

std::string case_id(const std::filesystem::path& file, const CaseFolders& folders) {
  std::string id = std::filesystem::relative(file, folders.cases).generic_string();
  const std::string ending = ".case.toml";
  if (id.size() > ending.size() && id.ends_with(ending)) id.resize(id.size() - ending.size());
  return id;
}

Case read_case(const std::filesystem::path& file, const CaseFolders& folders) {
  Case result;
  result.file = file;
  result.id = case_id(file, folders);
  const std::string shown = result.id + ".case.toml";
  const Node parsed = parse_case(file, shown);
  CaseTable root(parsed, shown, "");
  read_head(root, result);
  read_what_runs(root, result);
  std::set<std::string> names;
  for (const Node& node : root.tables("reference")) {
    CaseTable table(node, shown, "reference.");
    result.references.push_back(read_reference(table, folders));
    if (!names.insert(result.references.back().name).second) table.fail_here("name", "is taken by another reference");
  }
  names.clear();
  for (const Node& node : root.tables("check")) {
    CaseTable table(node, shown, "check.");
    result.checks.push_back(read_check(table, result));
    if (!names.insert(result.checks.back().name).second) table.fail_here("name", "is taken by another check");
  }
  if (std::none_of(result.checks.begin(), result.checks.end(), [](const Check& check) { return check.gates; }))
    root.fail_at(1, "check", "a case needs at least one check that gates");
  if (result.sweep && !result.sweep->error.empty() && !find_check(result, result.sweep->error))
    root.fail_at(1, "sweep.error", "there is no [[check]] named \"" + result.sweep->error + "\"");
  read_negatives(root, result);
  root.finish();
  return result;
}

}  // namespace sunder::verification
