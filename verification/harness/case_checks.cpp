#include "verification/harness/case_checks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace sunder::verification {
namespace {

Where read_where(CaseTable& table, bool has_sweep, std::size_t tolerances) {
  const Node* node = table.find("at");
  if (!node) {
    if (has_sweep && tolerances < 2)
      table.fail_here("at", "is missing; a case with a sweep needs \"every\", \"last\", \"default\" or an index");
    return {};
  }
  if (node->kind == Node::Kind::integer) return {Where::Kind::index, table.whole("at", 0, 0)};
  const std::string given = table.text_of(*node, "at");
  if (given == "every") return {Where::Kind::every, 0};
  if (given == "last") return {Where::Kind::last, 0};
  if (given == "default") return {Where::Kind::standard, 0};
  table.fail(*node, "at", "\"" + given + "\" is not accepted; \"every\", \"last\", \"default\" or an index is");
}

void read_known_limit(CaseTable& table, Check& check) {
  const Node* node = table.table("known_limit");
  if (!node) return;
  CaseTable inner(*node, table.file(), table.path("known_limit."));
  check.known_limit = KnownLimit{inner.text("reason"), inner.text("expires")};
  const std::string& date = check.known_limit->expires;
  const bool iso = date.size() == 10 && date[4] == '-' && date[7] == '-' &&
                   std::count_if(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; }) == 8;
  if (!iso) inner.fail_here("expires", "a date like \"2027-06-30\" is needed");
  inner.finish();
}

/// What a value check is compared with.
void read_comparison(CaseTable& table, const Case& result, Check& check) {
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
  if (table.find("scale")) check.scale = table.positive("scale");
  if (check.norm == Norm::event_time || check.norm == Norm::area) {
    if (check.abscissa.empty()) table.fail_here("abscissa", "is missing; this norm needs the abscissa of the curve");
    if (check.norm == Norm::event_time) check.threshold = table.number("threshold");
  }
  if (!reference->abscissae.empty() && check.abscissa.empty())
    table.fail_here("abscissa", "is missing; the reference is a curve");
}

void read_tolerance(CaseTable& table, Check& check) {
  check.tolerance = table.numbers("tolerance");
  for (const double tolerance : check.tolerance)
    if (!(tolerance >= 0.0)) table.fail_here("tolerance", "numbers >= 0 are needed");
}

/// A tolerance finer than what is known of the answer claims more than the reference can bear out.
void hold_tolerance_against_uncertainty(const CaseTable& table, const Case& result, const Check& check) {
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

void read_order(CaseTable& table, const Case& result, Check& check) {
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
  check.window = table.positive("window");
  check.floor = table.number("floor", 0.0);
}

}  // namespace

Check read_check(CaseTable table, const Case& result) {
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
      if (table.find("scale")) check.scale = table.positive("scale");
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

}  // namespace sunder::verification
