#include "verification/harness/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "verification/harness/comparison.hpp"

namespace sunder::verification {
namespace {

const Literal* literal_of(const Setting& setting, std::string_view key) {
  const Literal* found = nullptr;
  for (const auto& [name, value] : setting)
    if (name == key) found = &value;  // the setting's own stands last
  return found;
}

bool applies(const Check& check, const Case& verification_case, std::size_t i, std::size_t runs) {
  switch (check.where.kind) {
    case Where::Kind::every:
      return true;
    case Where::Kind::last:
      return i + 1 == runs;
    case Where::Kind::standard:
      return verification_case.sweep && verification_case.sweep->standard == static_cast<int>(i);
    case Where::Kind::index:
      return check.where.index == static_cast<int>(i);
  }
  return false;
}

double tolerance_at(const Check& check, std::size_t i) {
  return check.tolerance[check.tolerance.size() == 1 ? 0 : i];
}

Values reference_values(const Reference& reference, const Lookup& lookup) {
  return reference.expression.empty() ? reference.values : evaluate(reference.expression, lookup);
}

/// The comparison of a value, an invariant or a pin at one setting.
Comparison compare_at(const Case& verification_case, const Check& check, const SettingRun& run, const Values* pin) {
  const Lookup lookup = lookup_of(verification_case, run);
  const Values values = evaluate(check.quantity, lookup);
  const Values abscissa = check.abscissa.empty() ? Values{} : evaluate(check.abscissa, lookup);
  if (pin) {
    const bool zero = std::any_of(pin->begin(), pin->end(), [](double p) { return p == 0.0; });
    return compare({values, {}}, {*pin, {}}, {.norm = zero ? Norm::absolute : Norm::relative});
  }
  if (check.kind == CheckKind::invariant || check.reference.empty()) {
    const Values target{check.target};
    Comparison comparison = compare({values, {}}, {target, {}}, {.norm = Norm::absolute});
    comparison.error /= check.scale.value_or(1.0);
    return comparison;
  }
  const Reference& reference = *find_reference(verification_case, check.reference);
  const Values expected = reference_values(reference, lookup);
  return compare({values, abscissa}, {expected, reference.abscissae},
                 {.norm = check.norm, .scale = check.scale, .threshold = check.threshold});
}

/// How far towards its tolerance, or beyond it, an error goes; what is not a number goes furthest.
double share(double error, double tolerance) {
  if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
  if (error == 0.0) return 0.0;
  return tolerance > 0.0 ? error / tolerance : std::numeric_limits<double>::infinity();
}

/// Counts the comparison, and shows it where it is the worst so far.
void keep_worst(CheckOutcome& outcome, const Comparison& comparison, double tolerance, std::size_t setting,
                Status if_wrong) {
  if (comparison.compared == 0) return;
  const bool first = outcome.compared == 0;
  outcome.compared += comparison.compared;
  if (first) outcome.status = Status::pass;
  if (!(comparison.error <= tolerance)) {
    outcome.status = if_wrong;
    if (outcome.first_wrong < 0) outcome.first_wrong = static_cast<int>(setting);
  }
  if (!first && !(share(comparison.error, tolerance) > share(outcome.error, outcome.tolerance))) return;
  outcome.error = comparison.error;
  outcome.value = comparison.value;
  outcome.reference = comparison.reference;
  outcome.tolerance = tolerance;
  outcome.setting = static_cast<int>(setting);
  outcome.slack = comparison.error > 0.0 ? tolerance / comparison.error : 0.0;
}

CheckOutcome outcome_of(const Case& verification_case, const Check& check) {
  CheckOutcome outcome;
  outcome.name = check.name;
  outcome.kind = word(check.kind);
  outcome.gates = check.gates;
  const Reference* reference = find_reference(verification_case, check.reference);
  outcome.evidence = reference                          ? word(reference->kind)
                     : check.kind == CheckKind::pin     ? "self"
                     : check.kind == CheckKind::refused ? "refusal"
                     : check.kind == CheckKind::bound   ? "bound"
                                                        : "law";
  outcome.basis = check.kind == CheckKind::refused ? "specification" : word(check.basis);
  return outcome;
}

void judge_numbers(const Case& verification_case, const Check& check, std::vector<SettingRun>& runs,
                   const RunnerOptions& options, std::vector<std::pair<std::string, Values>>& pins,
                   CheckOutcome& outcome) {
  const Status if_wrong = check.kind == CheckKind::pin         ? Status::changed_pin
                          : check.kind == CheckKind::invariant ? Status::broken_invariant
                                                               : Status::wrong_value;
  const Values* pin = nullptr;
  if (check.kind == CheckKind::pin) {
    if (const auto found = options.pins.find(check.name); found != options.pins.end()) pin = &found->second;
    pins.emplace_back(check.name, Values{});
  }
  std::size_t pinned = 0;  // values of the pin that earlier settings have used
  for (std::size_t i = 0; i < runs.size(); ++i) {
    SettingRun& run = runs[i];
    const bool counts = applies(check, verification_case, i, runs.size());
    if (run.row.status != Status::pass) {
      if (!counts || refused_by_name(verification_case, run.row)) continue;
      outcome.status = run.row.status;
      outcome.message = run.row.message;
      outcome.setting = static_cast<int>(i);
      return;
    }
    if (!counts && check.kind != CheckKind::value) continue;
    try {
      if (check.kind == CheckKind::pin) {
        const Values measured = evaluate(check.quantity, lookup_of(verification_case, run));
        pins.back().second.insert(pins.back().second.end(), measured.begin(), measured.end());
        if (!pin) continue;
        const Values here(pin->begin() + std::min(pinned, pin->size()),
                          pin->begin() + std::min(pinned + measured.size(), pin->size()));
        pinned += measured.size();
        if (here.size() != measured.size()) throw std::invalid_argument("fewer values are pinned than there are now");
        keep_worst(outcome, compare_at(verification_case, check, run, &here), tolerance_at(check, i), i, if_wrong);
      } else {
        const Comparison comparison = compare_at(verification_case, check, run, nullptr);
        if (comparison.compared > 0) run.row.errors.emplace_back(check.name, comparison.error);
        if (counts) keep_worst(outcome, comparison, tolerance_at(check, i), i, if_wrong);
      }
    } catch (const std::invalid_argument& error) {
      if (!counts) continue;
      outcome.status = Status::checked_nothing;
      outcome.message = error.what();
      outcome.setting = static_cast<int>(i);
      return;
    }
  }
  if (check.kind == CheckKind::pin && !pin) outcome.message = "no pin is stored yet; --update-pins stores it";
}

void judge_bound(const Case& verification_case, const Check& check, const std::vector<SettingRun>& runs,
                 CheckOutcome& outcome) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!applies(check, verification_case, i, runs.size())) continue;
    if (runs[i].row.status != Status::pass) {
      if (refused_by_name(verification_case, runs[i].row)) continue;
      outcome.status = runs[i].row.status;
      outcome.message = runs[i].row.message;
      outcome.setting = static_cast<int>(i);
      return;
    }
    for (const double value : evaluate(check.quantity, lookup_of(verification_case, runs[i]))) {
      const double excess =
          std::max(check.at_most ? value - *check.at_most : -1.0, check.at_least ? *check.at_least - value : -1.0);
      const double limit =
          check.at_most && (!check.at_least || value > *check.at_least) ? *check.at_most : *check.at_least;
      keep_worst(outcome, {std::max(excess, 0.0), value, limit, 1}, 0.0, i, Status::wrong_value);
      outcome.slack = 0.0;  // a bound has no margin in units of an error
    }
  }
}

void judge_refusal(const Case& verification_case, const Check& check, const std::vector<SettingRun>& runs,
                   CheckOutcome& outcome) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!applies(check, verification_case, i, runs.size())) continue;
    const SettingRow& row = runs[i].row;
    outcome.setting = static_cast<int>(i);
    if (row.status == Status::refused || row.status == Status::not_converged) {
      ++outcome.compared;
      outcome.message = row.message;
      outcome.status = row.message.find(check.message) != std::string::npos ? Status::pass : Status::wrong_value;
    } else {
      outcome.status = row.status == Status::pass ? Status::wrong_value : row.status;
      outcome.message = row.status == Status::pass ? "an answer was given where a refusal is due" : row.message;
    }
    if (outcome.status != Status::pass) return;
  }
}

/// The settings of each curve of the sweep, by the values of the keys that tell the curves apart.
std::vector<std::vector<std::size_t>> curves(const Case& verification_case, const Check& check,
                                             const std::vector<SettingRun>& runs) {
  const Sweep& sweep = *verification_case.sweep;
  std::vector<std::string> telling = sweep.series;
  if (telling.empty() && sweep.product)
    for (const auto& [key, values] : sweep.keys)
      if (key != check.over) telling.push_back(key);
  std::vector<std::string> names;  // in the order in which they come up
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::string name;
    for (const auto& [key, text] : runs[i].row.keys)
      if (std::find(telling.begin(), telling.end(), key) != telling.end()) name += text + ";";
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      names.push_back(name);
      result.push_back({i});
    } else {
      result[static_cast<std::size_t>(found - names.begin())].push_back(i);
    }
  }
  return result;
}

/// The size that a setting refines, as a length.
double size_of(const Check& check, const SettingRun& run) {
  const Literal* literal = literal_of(run.setting, check.over);
  if (!literal) literal = literal_of(run.setting, "scene." + check.over);
  if (!literal || !literal->number) throw std::invalid_argument("the setting has no number " + check.over);
  return check.over_counts ? 1.0 / *literal->number : *literal->number;
}

void judge_order(const Case& verification_case, const Check& check, std::vector<SettingRun>& runs,
                 CheckOutcome& outcome) {
  const auto all = curves(verification_case, check, runs);
  if (check.expected.size() != 1 && check.expected.size() != all.size())
    throw std::invalid_argument("one expected order, or one for each of the " + std::to_string(all.size()) +
                                " curves, is needed");
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::vector<Level> levels;
    for (const std::size_t i : all[k]) {
      if (runs[i].row.status != Status::pass) {
        outcome.status = runs[i].row.status;
        outcome.message = runs[i].row.message;
        outcome.setting = static_cast<int>(i);
        return;
      }
      if (check.reference.empty()) {
        const Values value = evaluate(check.quantity, lookup_of(verification_case, runs[i]));
        if (value.size() != 1) throw std::invalid_argument("an order without a reference needs one number");
        levels.push_back({size_of(check, runs[i]), value[0]});
      } else {
        const Comparison comparison = compare_at(verification_case, check, runs[i], nullptr);
        if (comparison.compared == 0) throw std::invalid_argument("there is nothing to compare");
        const double sign = comparison.value < comparison.reference ? -1.0 : 1.0;
        levels.push_back({size_of(check, runs[i]), sign * comparison.error});
        runs[i].row.errors.emplace_back(check.name, comparison.error);
      }
    }
    if (levels.size() < 4)
      throw std::invalid_argument("an order needs at least four levels, curve " + std::to_string(k) + " has " +
                                  std::to_string(levels.size()));
    OrderOptions options{.floor = check.floor};
    if (!check.reference.empty()) options.exact = 0.0;  // the levels are errors
    const OrderEstimate estimate = observed_order(levels, options);
    outcome.orders.push_back(estimate);
    const double expected = check.expected[check.expected.size() == 1 ? 0 : k];
    if (estimate.convergence == Convergence::at_floor) {
      outcome.message = "curve " + std::to_string(k) + " lies at the round-off floor: no order can be told";
      outcome.status = Status::checked_nothing;
      return;
    }
    keep_worst(outcome, {std::abs(estimate.order - expected), estimate.order, expected, estimate.levels_used},
               check.window, all[k].back(), Status::wrong_order);
    if (estimate.convergence == Convergence::divergent) {
      outcome.status = Status::wrong_order;
      outcome.message = "curve " + std::to_string(k) + " diverges";
    }
  }
}

/// What `path` names of the run's history: "time", a column from its first row to its last, or "time[3]".
Values of_history(const results::RunSummary& summary, std::string_view path) {
  if (!summary.history) throw std::invalid_argument("the run has no history");
  const results::History& history = *summary.history;
  const std::string_view wanted = path.substr(0, path.find('['));
  results::Quantity columns;
  for (std::size_t c = 0; c < history.columns().size(); ++c) {
    const std::string& name = history.columns()[c].name;
    std::vector<double> values;  // only of the column that is asked for
    for (std::size_t row = 0; name == wanted && row < history.rows(); ++row) values.push_back(history.at(row, c));
    columns[name] = results::Quantity(values);
  }
  return select(columns, path);
}

/// Materials are values, and numerics is entered by name only where it is all that works: others call both everywhere.
bool is_called_by_others(const std::string& part) {
  return part == "material" || part == "numerics";
}

}  // namespace

Lookup lookup_of(const Case& verification_case, const SettingRun& run) {
  return [&](std::string_view name) -> Values {
    const auto starts = [&](std::string_view prefix) { return name.substr(0, prefix.size()) == prefix; };
    if (starts("parameters.") || starts("scene.")) {
      const Literal* literal = literal_of(run.setting, name);
      if (!literal || literal->numbers.empty())
        throw std::invalid_argument("no number " + std::string(name) + " is set by the case");
      return literal->numbers;
    }
    if (starts("reference.")) {
      const Reference* reference = find_reference(verification_case, name.substr(10));
      if (!reference) throw std::invalid_argument("there is no " + std::string(name));
      return reference_values(*reference, lookup_of(verification_case, run));
    }
    const results::RunSummary& summary = run.output.summary;
    if (name == "run.dofs") return {static_cast<double>(summary.mesh.dofs)};
    if (name == "run.nodes") return {static_cast<double>(summary.mesh.nodes)};
    if (name == "run.polygons") return {static_cast<double>(summary.mesh.polygons)};
    if (starts("counts."))
      for (const auto& [counted, count] : summary.counts)
        if (counted == name.substr(7)) return {static_cast<double>(count)};
    if (starts("history.")) return of_history(summary, name.substr(8));
    return select(summary.quantities, name);
  };
}

bool refused_by_name(const Case& verification_case, const SettingRow& row) {
  if (!verification_case.ladder || (row.status != Status::refused && row.status != Status::not_converged)) return false;
  const auto& accepted = verification_case.ladder->refusals;
  return std::any_of(accepted.begin(), accepted.end(),
                     [&](const std::string& words) { return row.message.find(words) != std::string::npos; });
}

CheckOutcome judge(const Case& verification_case, const Check& check, std::vector<SettingRun>& runs,
                   const RunnerOptions& options, std::vector<std::pair<std::string, Values>>& pins) {
  CheckOutcome outcome = outcome_of(verification_case, check);
  try {
    switch (check.kind) {
      case CheckKind::value:
      case CheckKind::invariant:
      case CheckKind::pin:
        judge_numbers(verification_case, check, runs, options, pins, outcome);
        break;
      case CheckKind::bound:
        judge_bound(verification_case, check, runs, outcome);
        break;
      case CheckKind::refused:
        judge_refusal(verification_case, check, runs, outcome);
        break;
      case CheckKind::order:
        judge_order(verification_case, check, runs, outcome);
        break;
    }
  } catch (const std::invalid_argument& error) {
    outcome.status = Status::checked_nothing;
    outcome.message = error.what();
  }
  if (outcome.status == Status::checked_nothing && outcome.message.empty()) outcome.message = "no number was compared";
  return outcome;
}

CheckOutcome judge_parts(const Case& verification_case, const std::vector<SettingRun>& runs) {
  CheckOutcome outcome{
      .name = "parts", .kind = "contract", .status = Status::pass, .evidence = "law", .basis = "specification"};
  const auto& listed = verification_case.modules;
  std::set<std::string> touched;
  bool ran = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ran = ran || runs[i].row.status == Status::pass;
    for (const results::PartCost& part : runs[i].output.summary.parts) {
      ++outcome.compared;
      if (part.calls == 0 && part.matrix_entries == 0 && part.seconds == 0.0 && part.bytes == 0) continue;
      touched.insert(part.part);
      if (std::find(listed.begin(), listed.end(), part.part) != listed.end()) continue;
      outcome.status = Status::broken_invariant;
      outcome.setting = static_cast<int>(i);
      outcome.message =
          "part " + part.part + " was entered " + std::to_string(part.calls) + " times, the case does not list it";
    }
  }
  if (!ran) return outcome;  // refusals enter what they please before they refuse
  if (touched.empty() && !listed.empty()) {
    outcome.compared = 1;
    outcome.status = Status::checked_nothing;
    outcome.message = "no part was counted: the study keeps no ledger";
  }
  if (outcome.status != Status::pass) return outcome;
  for (const std::string& part : listed) {
    if (touched.contains(part) || is_called_by_others(part)) continue;
    outcome.message += (outcome.message.empty() ? "listed but never entered: " : ", ") + part;
  }
  return outcome;
}

CheckOutcome judge_ladder(const Case& verification_case, const std::vector<SettingRun>& runs,
                          const std::vector<CheckOutcome>& checks, const RunnerOptions& options,
                          int& first_failing_rung) {
  CheckOutcome outcome{
      .name = "ladder", .kind = "ladder", .status = Status::pass, .evidence = "law", .basis = "specification"};
  outcome.compared = static_cast<int>(runs.size());
  first_failing_rung = static_cast<int>(runs.size());
  for (std::size_t i = runs.size(); i-- > 0;)
    if (runs[i].row.status != Status::pass) first_failing_rung = static_cast<int>(i);
  for (const CheckOutcome& check : checks)  // a wrong answer is a failing rung too
    if (check.first_wrong >= 0) first_failing_rung = std::min(first_failing_rung, check.first_wrong);
  outcome.value = first_failing_rung;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].row.status != Status::pass && !refused_by_name(verification_case, runs[i].row)) {
      outcome.status = runs[i].row.status;
      outcome.setting = static_cast<int>(i);
      outcome.message = "rung " + std::to_string(i) + ": " + runs[i].row.message;
      return outcome;
    }
  const auto pin = options.pins.find("first_failing_rung");
  if (pin == options.pins.end() || pin->second.empty()) {
    outcome.status = Status::checked_nothing;
    outcome.message = "no rung is stored yet; --update-pins stores it";
  } else {
    outcome.reference = pin->second.front();
    if (first_failing_rung < outcome.reference) {
      outcome.status = Status::changed_pin;
      outcome.message = "the first failing rung is " + std::to_string(first_failing_rung) + ", it was " +
                        std::to_string(static_cast<int>(outcome.reference));
    } else if (first_failing_rung > outcome.reference) {
      outcome.message = "climbs higher than before: --update-pins stores it";
    }
  }
  return outcome;
}

}  // namespace sunder::verification
