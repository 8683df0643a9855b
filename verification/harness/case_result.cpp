#include "verification/harness/case_result.hpp"

#include <algorithm>
#include <array>

namespace sunder::verification {
namespace {

constexpr std::array all_statuses = {
    Status::pass,          Status::known_limit,      Status::skipped,     Status::changed_pin, Status::refused,
    Status::not_converged, Status::broken_invariant, Status::wrong_order, Status::wrong_value, Status::checked_nothing,
    Status::timeout,       Status::memory,           Status::crash};
constexpr double loose = 20.0, tight = 1.2;

}  // namespace

bool fails(Status status) {
  return status > Status::skipped;
}

std::string_view word(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::known_limit:
      return "known limit";
    case Status::skipped:
      return "skipped";
    case Status::changed_pin:
      return "changed pin";
    case Status::refused:
      return "refused";
    case Status::not_converged:
      return "not converged";
    case Status::broken_invariant:
      return "broken invariant";
    case Status::wrong_order:
      return "wrong order";
    case Status::wrong_value:
      return "wrong value";
    case Status::checked_nothing:
      return "checked nothing";
    case Status::timeout:
      return "timeout";
    case Status::memory:
      return "memory";
    case Status::crash:
      return "crash";
  }
  return "";
}

std::optional<Status> status_of(std::string_view given) {
  for (const Status status : all_statuses)
    if (word(status) == given) return status;
  return std::nullopt;
}

std::string_view slack_word(const CheckOutcome& outcome) {
  if (outcome.status != Status::pass || !(outcome.slack > 0.0)) return "";
  return outcome.slack > loose ? "loose" : outcome.slack < tight ? "tight" : "";
}

std::string_view word(NegativeOutcome::Verdict verdict) {
  switch (verdict) {
    case NegativeOutcome::Verdict::killed:
      return "killed";
    case NegativeOutcome::Verdict::survived:
      return "survived";
    case NegativeOutcome::Verdict::never_reached:
      return "never reached";
    case NegativeOutcome::Verdict::no_baseline:
      return "no baseline";
  }
  return "";
}

Status worst(const std::vector<CheckOutcome>& checks) {
  Status status = Status::pass;
  bool any = false;
  for (const CheckOutcome& check : checks) {
    if (!check.gates) continue;
    any = any || check.compared > 0 || fails(check.status) || check.status == Status::known_limit;
    status = std::max(status, check.status);
  }
  return any ? status : Status::checked_nothing;
}

}  // namespace sunder::verification
