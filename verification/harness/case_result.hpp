#pragma once
/// What came of a case: a verdict for each check, and for each setting of its sweep the error and what it cost.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/results/run_summary.hpp"
#include "verification/harness/case.hpp"
#include "verification/harness/order.hpp"

namespace sunder::verification {

/// Worst last: the verdict of a case is the worst of its checks.
enum class Status {
  pass,
  known_limit,       ///< fails for a stated reason, until a stated date
  skipped,           ///< this machine cannot run it, for a stated reason
  changed_pin,       ///< differs from our own earlier value
  refused,           ///< the program declined with a named reason where an answer was asked for
  not_converged,     ///< the program said that it did not reach an answer
  broken_invariant,  ///< a law, or the contract on parts, does not hold
  wrong_order,
  wrong_value,      ///< also where a quantity is not a number
  checked_nothing,  ///< no number was compared: fails
  timeout,
  memory,
  crash,
};

/// pass, known limit and skipped do not stop a build; anything else does.
bool fails(Status status);
std::string_view word(Status status);
std::optional<Status> status_of(std::string_view word);

struct CheckOutcome {
  std::string name;
  std::string kind;  ///< word of the check's kind
  bool gates = true;
  Status status = Status::checked_nothing;
  std::string evidence;  ///< class of the reference; "law", "bound", "refusal" where there is none
  std::string basis;
  double value = 0.0;  ///< of the worst comparison
  double reference = 0.0;
  double error = 0.0;
  double tolerance = 0.0;
  double slack = 0.0;    ///< tolerance / error; > 20 is loose, < 1.2 tight; 0 where the error is 0
  int compared = 0;      ///< numbers that were compared
  int setting = -1;      ///< of the worst comparison
  int first_wrong = -1;  ///< the first setting that is not right
  std::string message = {};
  std::vector<OrderEstimate> orders = {};  ///< one a series
};

/// "loose", "tight", "" from the slack of a passing check.
std::string_view slack_word(const CheckOutcome& outcome);

/// One point of error against run time.
struct SettingRow {
  std::vector<std::pair<std::string, std::string>> keys;  ///< as written
  bool standard = false;                                  ///< the program's default
  Status status = Status::pass;  ///< of the run: pass, refused, not_converged, wrong_value (NaN)
  std::string message;
  std::vector<std::pair<std::string, double>> errors;  ///< check name, its error here
  double cpu_seconds = 0.0;                            ///< median of the repeats
  double cpu_spread = 0.0;                             ///< half-width of the 95 % interval of the median / median
  int repeats = 0;
  long dofs = 0;
  long peak_bytes = 0;  ///< largest resident size while it ran
  std::vector<results::PartCost> parts;
  std::vector<std::pair<std::string, long long>> counts;
};

struct NegativeOutcome {
  std::string fault;
  std::vector<std::string> checks;  ///< that should turn red
  std::vector<std::string> red;     ///< that did, named or not
  bool reached = false;
  enum class Verdict { killed, survived, never_reached, no_baseline } verdict = Verdict::survived;
};
std::string_view word(NegativeOutcome::Verdict verdict);

struct CaseResult {
  std::string id, family, tier, title, requirement;
  int version = 1;
  Status status = Status::checked_nothing;
  std::string message;
  std::vector<Reference> references;  ///< of the case, as read
  std::vector<CheckOutcome> checks;
  std::string error_check;          ///< the check whose errors the figure of error against run time shows
  std::vector<std::string> series;  ///< keys whose values tell its curves apart
  std::vector<SettingRow> settings;
  std::optional<int> first_failing_rung;  ///< of a ladder: index of the first rung that was not right; the number of
                                          ///< rungs where all were
  std::vector<std::pair<std::string, std::vector<double>>> pins;  ///< values measured for pin checks and the ladder
  std::vector<std::pair<std::string, double>> digits_trusted;     ///< by quantity; only where the input was jittered
  std::vector<NegativeOutcome> negatives;                         ///< only from `negatives`
  double cpu_seconds = 0.0;                                       ///< of the whole case
  long peak_bytes = 0;
};

/// The worst status among the checks that gate, with the contract on parts; known limits count as such.
Status worst(const std::vector<CheckOutcome>& checks);

}  // namespace sunder::verification
