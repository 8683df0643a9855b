/// The only code of the harness that knows TOML.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "verification/harness/case.hpp"
#include "verification/harness/csv.hpp"

#include <toml++/toml.h>

namespace sunder::verification {
namespace {

/// How many single-letter edits lead from a to b.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

/// One table of the file: hands out its entries, and knows in the end which nobody asked for.
class Table {
 public:
  Table(const toml::table& table, std::string file, std::string prefix)
      : table_(table), file_(std::move(file)), prefix_(std::move(prefix)) {}

  [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& message) const {
    fail_at(static_cast<int>(node.source().begin.line), key, message);
  }
  [[noreturn]] void fail_here(std::string_view key, const std::string& message) const {
    fail_at(static_cast<int>(table_.source().begin.line), key, message);
  }
  [[noreturn]] void fail_at(int line, std::string_view key, const std::string& message) const {
    throw CaseError(file_ + ":" + std::to_string(line) + ": " + prefix_ + std::string(key) + ": " + message);
  }
  int line() const { return static_cast<int>(table_.source().begin.line); }
  const std::string& file() const { return file_; }
  std::string path(std::string_view key) const { return prefix_ + std::string(key); }

  const toml::node* find(std::string_view key) {
    asked_.insert(std::string(key));
    return table_.get(key);
  }
  const toml::node& need(std::string_view key, const std::string& accepted) {
    const toml::node* node = find(key);
    if (!node) fail_here(key, "is missing; " + accepted + " is needed");
    return *node;
  }

  std::string text_of(const toml::node& node, std::string_view key) const {
    const auto text = node.value<std::string>();
    if (!node.is_string() || text->empty()) fail(node, key, "a text that is not empty is needed");
    return *text;
  }
  double number_of(const toml::node& node, std::string_view key) const {
    if (!node.is_number()) fail(node, key, "a number is needed");
    const double number = *node.value<double>();
    if (!std::isfinite(number)) fail(node, key, "a finite number is needed");
    return number;
  }
  std::string text(std::string_view key) { return text_of(need(key, "a text"), key); }
  std::string text(std::string_view key, std::string otherwise) {
    const toml::node* node = find(key);
    return node ? text_of(*node, key) : std::move(otherwise);
  }
  double number(std::string_view key) { return number_of(need(key, "a number"), key); }
  double number(std::string_view key, double otherwise) {
    const toml::node* node = find(key);
    return node ? number_of(*node, key) : otherwise;
  }
  int whole(std::string_view key, int otherwise, int least) {
    const toml::node* node = find(key);
    if (!node) return otherwise;
    if (!node->is_integer() || *node->value<long>() < least)
      fail(*node, key, "a whole number of at least " + std::to_string(least) + " is needed");
    return static_cast<int>(*node->value<long>());
  }
  bool truth(std::string_view key, bool otherwise) {
    const toml::node* node = find(key);
    if (!node) return otherwise;
    if (!node->is_boolean()) fail(*node, key, "true or false is needed");
    return *node->value<bool>();
  }
  std::vector<double> numbers(std::string_view key) {
    const toml::node& node = need(key, "a number or a list of numbers");
    std::vector<double> result;
    flatten_numbers(node, key, result);
    if (result.empty()) fail(node, key, "a list that is not empty is needed");
    return result;
  }
  std::vector<std::string> texts(std::string_view key) {
    const toml::node& node = need(key, "a list of texts");
    const toml::array* list = node.as_array();
    if (!list) fail(node, key, "a list of texts is needed");
    std::vector<std::string> result;
    for (const toml::node& entry : *list) result.push_back(text_of(entry, key));
    return result;
  }
  /// An enumerator by its word.
  template <class Enumerator>
  Enumerator word_of(std::string_view key, std::initializer_list<Enumerator> choices,
                     std::optional<Enumerator> otherwise = {}) {
    const toml::node* node = find(key);
    if (!node && otherwise) return *otherwise;
    std::string accepted;
    for (const Enumerator choice : choices)
      accepted += (accepted.empty() ? "\"" : ", \"") + std::string(word(choice)) + "\"";
    if (!node) fail_here(key, "is missing; one of " + accepted + " is needed");
    const std::string given = text_of(*node, key);
    for (const Enumerator choice : choices)
      if (word(choice) == given) return choice;
    fail(*node, key, "\"" + given + "\" is not accepted; one of " + accepted + " is");
  }

  void flatten_numbers(const toml::node& node, std::string_view key, std::vector<double>& result) const {
    if (const toml::array* list = node.as_array()) {
      for (const toml::node& entry : *list) flatten_numbers(entry, key, result);
    } else {
      result.push_back(number_of(node, key));
    }
  }

  /// Rejects every key that was not asked for, naming the nearest that was.
  void finish() const {
    for (const auto& [key, node] : table_) {
      if (asked_.count(std::string(key.str()))) continue;
      const std::string* nearest = nullptr;
      std::size_t best = 4;  // further than three edits is another word
      for (const std::string& known : asked_)
        if (const std::size_t d = edits(key.str(), known); d < best) best = d, nearest = &known;
      fail(node, key.str(), "is not known here" + (nearest ? "; did you mean \"" + *nearest + "\"?" : std::string()));
    }
  }

 private:
  const toml::table& table_;
  std::string file_, prefix_;
  std::set<std::string, std::less<>> asked_;
};

Literal literal(const toml::node& node) {
  Literal result;
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  result.text = text.str();
  if (node.is_number()) {
    result.number = node.value<double>();
    result.numbers = {*result.number};
  } else if (node.is_string()) {
    result.words = node.value<std::string>();
    result.text = "\"" + *result.words + "\"";
  } else if (const toml::array* list = node.as_array()) {
    for (const toml::node& entry : *list) {
      const std::vector<double> inner = literal(entry).numbers;
      result.numbers.insert(result.numbers.end(), inner.begin(), inner.end());
    }
  }
  return result;
}

/// Leaves of nested tables under dotted keys.
template <class Visit>
void for_each_leaf(const toml::table& table, const std::string& prefix, const Visit& visit) {
  for (const auto& [key, node] : table) {
    const std::string path = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table())
      for_each_leaf(*inner, path + ".", visit);
    else
      visit(path, node);
  }
}

Setting read_setting(Table& parent, std::string_view key) {
  Setting result;
  const toml::node* node = parent.find(key);
  if (!node) return result;
  if (!node->is_table()) parent.fail(*node, key, "a table is needed");
  for_each_leaf(*node->as_table(), "",
                [&](const std::string& path, const toml::node& leaf) { result.emplace_back(path, literal(leaf)); });
  return result;
}

const toml::array& tables(Table& parent, std::string_view key) {
  static const toml::array none;
  const toml::node* node = parent.find(key);
  if (!node) return none;
  const toml::array* list = node->as_array();
  if (!list || (!list->empty() && !list->is_array_of_tables())) parent.fail(*node, key, "an array of tables is needed");
  return *list;
}

void read_uncertainty(Table& table, Reference& reference) {
  const toml::node& node = table.need("uncertainty", "a number in the reference's unit, or a text like \"0.5 %\",");
  if (node.is_string()) {
    const std::string given = *node.value<std::string>();
    std::istringstream stream(given);
    std::string sign;
    if (!(stream >> reference.uncertainty >> sign) || sign != "%")
      table.fail(node, "uncertainty", "\"" + given + "\" is not a percentage like \"0.5 %\"");
    reference.uncertainty /= 100.0;
    reference.uncertainty_is_relative = true;
  } else {
    reference.uncertainty = table.number_of(node, "uncertainty");
  }
  const bool may_be_certain = reference.kind == ReferenceClass::exact || reference.kind == ReferenceClass::self;
  if (!(reference.uncertainty >= 0.0) || (reference.uncertainty == 0.0 && !may_be_certain))
    table.fail(node, "uncertainty", "only an exact reference has none; a number > 0 is needed");
}

void read_reference_csv(Table& table, const toml::node& node, const CaseFolders& folders, Reference& reference) {
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
      const auto i = static_cast<std::size_t>(row);
      if (!(row >= 0.0) || row != std::floor(row) || i >= reference.values.size())
        table.fail(node, "rows", "indices from 0 to " + std::to_string(reference.values.size() - 1) + " are needed");
      values.push_back(reference.values[i]);
      if (!reference.abscissae.empty()) abscissae.push_back(reference.abscissae[i]);
    }
    reference.values = values;
    reference.abscissae = abscissae;
  }
  for (const double value : reference.values)
    if (std::isnan(value)) table.fail(node, "csv", "a field of the column is empty");
}

Reference read_reference(Table table, const CaseFolders& folders) {
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
  const toml::node* csv = table.find("csv");
  const toml::node* value = table.find("value");
  if (!csv == !value) table.fail_here("value", "either value or csv is needed");
  if (csv) {
    read_reference_csv(table, *csv, folders, reference);
  } else if (value->is_string()) {
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

Where read_where(Table& table, bool has_sweep, std::size_t tolerances) {
  const toml::node* node = table.find("at");
  if (!node) {
    if (has_sweep && tolerances < 2)
      table.fail_here("at", "is missing; a case with a sweep needs \"every\", \"last\", \"default\" or an index");
    return {};
  }
  if (node->is_integer()) {
    const long index = *node->value<long>();
    if (index < 0) table.fail(*node, "at", "an index of at least 0 is needed");
    return {Where::Kind::index, static_cast<int>(index)};
  }
  const std::string given = table.text_of(*node, "at");
  if (given == "every") return {Where::Kind::every, 0};
  if (given == "last") return {Where::Kind::last, 0};
  if (given == "default") return {Where::Kind::standard, 0};
  table.fail(*node, "at", "\"" + given + "\" is not accepted; \"every\", \"last\", \"default\" or an index is");
}

void read_known_limit(Table& table, Check& check) {
  const toml::node* node = table.find("known_limit");
  if (!node) return;
  if (!node->is_table()) table.fail(*node, "known_limit", "a table with reason and expires is needed");
  Table inner(*node->as_table(), table.file(), table.path("known_limit."));
  check.known_limit = KnownLimit{inner.text("reason"), inner.text("expires")};
  const std::string& date = check.known_limit->expires;
  const bool iso = date.size() == 10 && date[4] == '-' && date[7] == '-' &&
                   std::count_if(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; }) == 8;
  if (!iso) inner.fail_here("expires", "a date like \"2027-06-30\" is needed");
  inner.finish();
}

/// What a value check is compared with.
void read_comparison(Table& table, const Case& result, Check& check) {
  check.norm = table.word_of(
      "norm",
      {Norm::relative, Norm::absolute, Norm::l2, Norm::maximum, Norm::area, Norm::path_distance, Norm::event_time},
      std::optional(Norm::relative));
  check.reference = table.text("reference");
  const Reference* reference = find_reference(result, check.reference);
  if (!reference) table.fail_here("reference", "there is no [[reference]] named \"" + check.reference + "\"");
  if (reference->kind == ReferenceClass::self)
    table.fail_here("reference", "our own earlier value verifies nothing; a pin may use it, a " +
                                     std::string(word(check.kind)) + " check may not");
  check.abscissa = table.text("abscissa", "");
  if (table.find("scale")) {
    check.scale = table.number("scale");
    if (!(*check.scale > 0.0)) table.fail_here("scale", "a number > 0 is needed");
  }
  if (check.norm == Norm::event_time || check.norm == Norm::area) {
    if (check.abscissa.empty()) table.fail_here("abscissa", "is missing; this norm needs the abscissa of the curve");
    if (check.norm == Norm::event_time) check.threshold = table.number("threshold");
  }
  if (!reference->abscissae.empty() && check.abscissa.empty())
    table.fail_here("abscissa", "is missing; the reference is a curve");
}

void read_tolerance(Table& table, Check& check) {
  check.tolerance = table.numbers("tolerance");
  for (const double tolerance : check.tolerance)
    if (!(tolerance >= 0.0)) table.fail_here("tolerance", "numbers >= 0 are needed");
}

/// A tolerance finer than what is known of the answer claims more than the reference can bear out.
void hold_tolerance_against_uncertainty(const Table& table, const Case& result, const Check& check) {
  const Reference* reference = find_reference(result, check.reference);
  if (!reference || !check.gates || reference->uncertainty == 0.0) return;
  double uncertainty = reference->uncertainty;  // in the measure of the check
  if (check.norm == Norm::relative) {
    double scale = 0.0;
    for (const double value : reference->values) scale = std::max(scale, std::abs(value));
    if (!reference->uncertainty_is_relative) {
      if (scale == 0.0) return;  // a formula: its size is not known before the run
      uncertainty /= check.scale.value_or(scale);
    }
  } else if (check.norm == Norm::absolute) {
    if (reference->uncertainty_is_relative) return;
  } else {
    return;
  }
  for (const double tolerance : check.tolerance)
    if (tolerance < uncertainty)
      table.fail_at(check.line, "tolerance",
                    "a tolerance finer than the reference's own uncertainty (" + std::to_string(uncertainty) +
                        " in the measure of the check) cannot be borne out");
}

void read_order(Table& table, const Case& result, Check& check) {
  if (table.find("law"))  // no answer is known: the order of the differences between levels, and why it is expected
    check.law = table.text("law");
  else
    read_comparison(table, result, check);
  if (!result.sweep) table.fail_here("kind", "an order needs a [sweep]");
  check.over = table.text("over");
  const auto key = std::find_if(result.sweep->keys.begin(), result.sweep->keys.end(),
                                [&](const auto& entry) { return entry.first == check.over; });
  if (key == result.sweep->keys.end()) table.fail_here("over", "the sweep has no key \"" + check.over + "\"");
  const std::set<std::string> different = [&] {
    std::set<std::string> texts;
    for (const Literal& value : key->second) texts.insert(value.text);
    return texts;
  }();
  if (different.size() < 4)
    table.fail_here("over", "an order needs at least four levels, " + std::to_string(different.size()) + " are there");
  for (const Literal& value : key->second)
    if (!value.number || !(*value.number > 0.0)) table.fail_here("over", "numbers > 0 are needed in the sweep");
  check.over_counts = table.truth("counts", false);
  check.expected = table.numbers("expected");
  check.window = table.number("window");
  check.floor = table.number("floor", 0.0);
  if (!(check.window > 0.0)) table.fail_here("window", "a number > 0 is needed");
}

Check read_check(Table table, const Case& result) {
  Check check;
  check.line = table.line();
  check.name = table.text("name");
  check.kind = table.word_of(
      "kind",
      {CheckKind::value, CheckKind::order, CheckKind::invariant, CheckKind::bound, CheckKind::pin, CheckKind::refused},
      std::optional(CheckKind::value));
  check.gates = table.truth("gates", true);
  read_known_limit(table, check);
  if (check.kind == CheckKind::refused) {
    check.message = table.text("message");
  } else {
    check.quantity = table.text("quantity");
    check.basis = table.word_of(
        "basis", {Basis::round_off, Basis::discretisation, Basis::uncertainty, Basis::specification, Basis::physics});
  }
  check.reason = table.text("reason");
  switch (check.kind) {
    case CheckKind::value:
      read_comparison(table, result, check);
      read_tolerance(table, check);
      hold_tolerance_against_uncertainty(table, result, check);
      break;
    case CheckKind::order:
      read_order(table, result, check);
      break;
    case CheckKind::invariant:
      check.law = table.text("law");
      check.target = table.number("target", 0.0);
      check.norm = Norm::absolute;
      if (table.find("scale")) {
        check.scale = table.number("scale");
        if (!(*check.scale > 0.0)) table.fail_here("scale", "a number > 0 is needed");
      }
      read_tolerance(table, check);
      break;
    case CheckKind::bound:
      if (table.find("at_least")) check.at_least = table.number("at_least");
      if (table.find("at_most")) check.at_most = table.number("at_most");
      if (!check.at_least && !check.at_most) table.fail_here("at_most", "at_most or at_least is needed");
      break;
    case CheckKind::pin:
      read_tolerance(table, check);
      break;
    case CheckKind::refused:
      break;
  }
  if (check.kind != CheckKind::order) check.where = read_where(table, result.sweep.has_value(), check.tolerance.size());
  const std::size_t runs = settings(result).size();
  if (check.tolerance.size() > 1 && check.tolerance.size() != runs)
    table.fail_here("tolerance", "one number, or one for each of the " + std::to_string(runs) + " settings, is needed");
  if (check.where.kind == Where::Kind::index && check.where.index >= static_cast<int>(runs))
    table.fail_here("at", "the sweep has only " + std::to_string(runs) + " settings");
  if (check.where.kind == Where::Kind::standard && !(result.sweep && result.sweep->standard))
    table.fail_here("at", "the sweep names no default");
  table.finish();
  return check;
}

Sweep read_sweep(Table table) {
  Sweep sweep;
  const std::string combine = table.text("combine", "zip");
  if (combine != "zip" && combine != "product") table.fail_here("combine", "\"zip\" or \"product\" is needed");
  sweep.product = combine == "product";
  sweep.error = table.text("error", "");
  if (table.find("series")) sweep.series = table.texts("series");
  if (table.find("default")) sweep.standard = table.whole("default", 0, 0);
  const toml::node& keys = table.need("keys", "a table of lists");
  if (!keys.is_table()) table.fail(keys, "keys", "a table of lists is needed");
  for_each_leaf(*keys.as_table(), "", [&](const std::string& path, const toml::node& leaf) {
    const toml::array* list = leaf.as_array();
    if (!list || list->empty()) table.fail(leaf, "keys." + path, "a list that is not empty is needed");
    std::vector<Literal> values;
    for (const toml::node& entry : *list) values.push_back(literal(entry));
    if (!sweep.product && !sweep.keys.empty() && sweep.keys.front().second.size() != values.size())
      table.fail(leaf, "keys." + path, "as many values as for " + sweep.keys.front().first + " are needed");
    sweep.keys.emplace_back(path, std::move(values));
  });
  if (sweep.keys.empty()) table.fail(keys, "keys", "a sweep needs at least one key");
  for (const std::string& key : sweep.series)
    if (std::none_of(sweep.keys.begin(), sweep.keys.end(), [&](const auto& entry) { return entry.first == key; }))
      table.fail_here("series", "the sweep has no key \"" + key + "\"");
  table.finish();
  return sweep;
}

void read_head(Table& root, Case& result) {
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

void read_what_runs(Table& root, Case& result) {
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
  if (const toml::node* node = root.find("needs")) {
    if (!node->is_table()) root.fail(*node, "needs", "a table is needed");
    Table needs(*node->as_table(), root.file(), "needs.");
    result.needs = {needs.whole("cores", 1, 1), needs.number("memory", 0.0)};
    needs.finish();
  }
  if (const toml::node* node = root.find("sweep")) {
    if (!node->is_table()) root.fail(*node, "sweep", "a table is needed");
    result.sweep = read_sweep(Table(*node->as_table(), root.file(), "sweep."));
    const int runs = static_cast<int>(settings(result).size());
    if (result.sweep->standard && *result.sweep->standard >= runs)
      root.fail(*node, "sweep.default", "the sweep has only " + std::to_string(runs) + " settings");
  }
  if (const toml::node* node = root.find("ladder")) {
    if (!node->is_table()) root.fail(*node, "ladder", "a table is needed");
    if (!result.sweep) root.fail(*node, "ladder", "a ladder needs a [sweep] that climbs");
    Table ladder(*node->as_table(), root.file(), "ladder.");
    result.ladder = Ladder{ladder.texts("refusals")};
    ladder.finish();
  }
}

void read_negatives(Table& root, Case& result) {
  for (const toml::node& node : tables(root, "negative")) {
    Table table(*node.as_table(), root.file(), "negative.");
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
  toml::table parsed;
  try {
    parsed = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw CaseError(shown + ":" + std::to_string(error.source().begin.line) +
                    ": TOML: " + std::string(error.description()));
  }
  Table root(parsed, shown, "");
  read_head(root, result);
  read_what_runs(root, result);
  std::set<std::string> names;
  for (const toml::node& node : tables(root, "reference")) {
    Table table(*node.as_table(), shown, "reference.");
    result.references.push_back(read_reference(table, folders));
    if (!names.insert(result.references.back().name).second) table.fail_here("name", "is taken by another reference");
  }
  names.clear();
  for (const toml::node& node : tables(root, "check")) {
    Table table(*node.as_table(), shown, "check.");
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
