#include "verification/harness/runner.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <thread>

#include "verification/harness/float_traps.hpp"
#include "verification/harness/measure.hpp"
#include "verification/harness/statistics.hpp"
#include "verification/harness/verdict.hpp"

namespace sunder::verification {
namespace {

/// Every number of the quantities, in order.
void append_bits(const results::Quantity& quantity, Values& bits) {
  if (const double* number = quantity.number()) bits.push_back(*number);
  if (const auto* list = quantity.list())
    for (const auto& entry : *list) append_bits(entry, bits);
  if (const auto* table = quantity.table())
    for (const auto& [name, entry] : *table) append_bits(entry, bits);
}

/// What must be the same bits in every repeat and for any number of threads.
Values bits_of(const results::RunSummary& summary) {
  Values bits;
  append_bits(summary.quantities, bits);
  if (summary.history)
    for (std::size_t row = 0; row < summary.history->rows(); ++row)
      for (std::size_t column = 0; column < summary.history->columns().size(); ++column)
        bits.push_back(summary.history->at(row, column));
  return bits;
}

bool same_bits(const Values& a, const Values& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// The name of the first quantity that is not finite; empty where all are.
std::string not_finite(const results::Quantity& quantity, const std::string& name) {
  if (const double* number = quantity.number()) return std::isfinite(*number) ? "" : name;
  if (const auto* list = quantity.list())
    for (std::size_t i = 0; i < list->size(); ++i)
      if (auto bad = not_finite((*list)[i], name + "[" + std::to_string(i) + "]"); !bad.empty()) return bad;
  if (const auto* table = quantity.table())
    for (const auto& [key, entry] : *table)
      if (auto bad = not_finite(entry, name.empty() ? key : name + "." + key); !bad.empty()) return bad;
  return "";
}

void run_once(const Study& study, const StudyInput& input, bool trap, SettingRun& run) {
  run.output = {};
  run.row.status = Status::pass;
  run.row.message.clear();
  try {
    const FloatTraps traps(trap);
    run.output = study(input);
    if (!run.output.refusal.empty()) {
      run.row.status = Status::refused;
      run.row.message = run.output.refusal;
    } else if (!run.output.summary.completed()) {
      run.row.status = Status::not_converged;
      run.row.message = run.output.summary.status;
    }
  } catch (const CaseError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    run.row.status = Status::refused;
    run.row.message = error.what();
  } catch (const std::bad_alloc&) {
    run.row.status = Status::memory;
    run.row.message = "out of memory";
  } catch (const std::exception& error) {
    run.row.status = Status::crash;
    run.row.message = std::string("exception: ") + error.what();
  }
  if (run.row.status != Status::pass) return;
  if (const std::string bad = not_finite(run.output.summary.quantities, ""); !bad.empty()) {
    run.row.status = Status::wrong_value;
    run.row.message = bad + " is not a finite number";
  } else if (const auto& history = run.output.summary.history; history && !results::not_finite(*history).empty()) {
    run.row.status = Status::wrong_value;
    run.row.message = "history: " + results::not_finite(*history).front() + " is not a finite number";
  }
}

/// The setting once more with another number of threads: the same verdict, and the same bits where it has any.
void compare_threads(const Study& study, StudyInput input, const RunnerOptions& options, SettingRun& run) {
  if (run.row.status == Status::broken_invariant) return;
  input.threads = options.other_threads;
  SettingRun other;
  run_once(study, input, options.trap, other);
  const std::string who = std::to_string(options.other_threads) + " threads ";
  if (other.row.status != run.row.status)
    run.row.message = who + "end otherwise: " + std::string(word(other.row.status)) + ": " + other.row.message;
  else if (!same_bits(bits_of(run.output.summary), bits_of(other.output.summary)))
    run.row.message = who + "give other bits than " + std::to_string(options.threads);
  else
    return;
  run.row.status = Status::broken_invariant;
}

SettingRun run_setting(const Case& verification_case, const Study& study, const Setting& setting,
                       const RunnerOptions& options) {
  SettingRun run;
  StudyInput input{verification_case, verification_case.overrides, verification_case.parameters, options.threads};
  const std::string prefix = "parameters.";
  for (const auto& [key, value] : setting) {
    run.row.keys.emplace_back(key, value.text);
    if (key.rfind(prefix, 0) == 0)
      input.parameters.emplace_back(key.substr(prefix.size()), value);
    else
      input.scene_keys.emplace_back(key, value);
  }
  for (const auto& [key, value] : input.scene_keys) run.setting.emplace_back("scene." + key, value);
  for (const auto& [key, value] : input.parameters) run.setting.emplace_back(prefix + key, value);

  std::vector<double> times;
  Values first;
  forget_peak_memory();
  const double begin = cpu_seconds();
  do {
    const double before = cpu_seconds();
    run_once(study, input, options.trap, run);
    times.push_back(cpu_seconds() - before);
    if (run.row.status != Status::pass) break;
    Values bits = bits_of(run.output.summary);
    if (times.size() == 1) {
      first = std::move(bits);
    } else if (!same_bits(first, bits)) {
      run.row.status = Status::broken_invariant;
      run.row.message = "repeat " + std::to_string(times.size()) + " gave other bits than the first";
      break;
    }
  } while (options.repeat && static_cast<int>(times.size()) < options.most_repeats &&
           cpu_seconds() - begin < options.most_seconds && relative_spread(median_interval(times)) > options.spread);

  if (options.other_threads > 0) compare_threads(study, input, options, run);

  const MedianEstimate estimate = median_interval(times);
  run.row.cpu_seconds = estimate.median;
  run.row.cpu_spread = times.size() < 2 ? 0.0 : 0.5 * (estimate.high - estimate.low) / estimate.median;
  run.row.repeats = static_cast<int>(times.size());
  run.row.peak_bytes = peak_resident_bytes();
  run.row.dofs = run.output.summary.mesh.dofs;
  run.row.parts = run.output.summary.parts;
  run.row.counts = run.output.summary.counts;
  return run;
}

/// Every number below the quantity with its path: "tips[0].K_I".
void append_named(const results::Quantity& quantity, const std::string& path,
                  std::vector<std::pair<std::string, double>>& named) {
  if (const double* number = quantity.number()) named.emplace_back(path, *number);
  if (const auto* list = quantity.list())
    for (std::size_t i = 0; i < list->size(); ++i)
      append_named((*list)[i], path + "[" + std::to_string(i) + "]", named);
  if (const auto* table = quantity.table())
    for (const auto& [name, entry] : *table) append_named(entry, path.empty() ? name : path + "." + name, named);
}

CaseResult head_of(const Case& verification_case) {
  CaseResult result;
  result.id = verification_case.id;
  result.family = verification_case.family;
  result.tier = word(verification_case.tier);
  result.title = verification_case.title;
  result.requirement = verification_case.requirement;
  result.version = verification_case.version;
  result.references = verification_case.references;
  if (verification_case.sweep) {
    result.error_check = verification_case.sweep->error;
    result.series = verification_case.sweep->series;
  }
  return result;
}

/// A failing check with a known limit that has not expired counts as such; one that passes must lose the mark.
void apply_known_limit(const Check& check, const std::string& today, CheckOutcome& outcome) {
  if (!check.known_limit) return;
  if (!fails(outcome.status)) {
    outcome.status = Status::changed_pin;
    outcome.message = "passes although a known limit is declared (" + check.known_limit->reason + "): remove the mark";
  } else if (today < check.known_limit->expires) {
    outcome.message = std::string(word(outcome.status)) + ", known: " + check.known_limit->reason + " (until " +
                      check.known_limit->expires + ")" + (outcome.message.empty() ? "" : "; " + outcome.message);
    outcome.status = Status::known_limit;
  } else {
    outcome.message = "the known limit expired on " + check.known_limit->expires + ": " + check.known_limit->reason;
  }
}

/// What the case needs and this machine has not, in words; empty where nothing.
std::string lacking(const Needs& needs) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  if (needs.cores > cores)
    return "needs " + std::to_string(needs.cores) + " cores, " + std::to_string(cores) + " are here";
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) /
                        1024.0 / 1024.0 / 1024.0;
  if (needs.memory > memory)
    return "needs " + std::to_string(needs.memory) + " GiB of memory, " + std::to_string(memory) + " are here";
  return "";
}

}  // namespace

CaseResult unfinished(const Case& verification_case, Status status, std::string message) {
  CaseResult result = head_of(verification_case);
  result.status = status;
  result.message = std::move(message);
  return result;
}

CaseResult run_case(const Case& verification_case, const Study& study, const RunnerOptions& options) {
  if (const std::string reason = lacking(verification_case.needs); !reason.empty())
    return unfinished(verification_case, Status::skipped, reason);
  CaseResult result = head_of(verification_case);
  const double begin = cpu_seconds();
  std::vector<SettingRun> runs;
  try {
    for (const Setting& setting : settings(verification_case)) {
      runs.push_back(run_setting(verification_case, study, setting, options));
      const bool standard =
          verification_case.sweep && verification_case.sweep->standard == static_cast<int>(runs.size()) - 1;
      runs.back().row.standard = standard;
    }
  } catch (const CaseError& error) {
    return unfinished(verification_case, Status::checked_nothing, error.what());
  }
  for (const Check& check : verification_case.checks) {
    result.checks.push_back(judge(verification_case, check, runs, options, result.pins));
    apply_known_limit(check, options.today, result.checks.back());
  }
  if (verification_case.ladder) {
    int rung = 0;
    result.checks.push_back(judge_ladder(verification_case, runs, result.checks, options, rung));
    result.first_failing_rung = rung;
    result.pins.emplace_back("first_failing_rung", Values{static_cast<double>(rung)});
  }
  if (CheckOutcome parts = judge_parts(verification_case, runs); parts.compared > 0)
    result.checks.push_back(std::move(parts));
  for (SettingRun& run : runs) {
    result.peak_bytes = std::max(result.peak_bytes, run.row.peak_bytes);
    if (run.row.status == Status::broken_invariant)
      result.checks.push_back({.name = "repeatability",
                               .kind = "contract",
                               .status = Status::broken_invariant,
                               .evidence = "law",
                               .basis = "specification",
                               .compared = 1,
                               .message = run.row.message});
    if (const auto* digits = run.output.summary.quantities.find("digits")) {
      result.digits_trusted.clear();
      append_named(*digits, "", result.digits_trusted);  // of the last setting
    }
    result.settings.push_back(std::move(run.row));
  }
  result.status = worst(result.checks);
  result.cpu_seconds = cpu_seconds() - begin;
  return result;
}

}  // namespace sunder::verification
