#include "solver/simulation/ledger.hpp"

#include <algorithm>

namespace sunder::simulation {
namespace {

/// The entry of this name, made at the end where there is none: the order is that of first use.
template <class Value>
Value& entry(std::vector<std::pair<std::string, Value>>& list, std::string_view name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& pair) { return pair.first == name; });
  if (found != list.end()) return found->second;
  return list.emplace_back(std::string(name), Value{}).second;
}

}  // namespace

Ledger::Visit::Visit(Ledger& ledger, std::string_view part, std::string_view phase)
    : ledger_(&ledger), part_(part), phase_(phase) {
  // Listed when it is entered: parts appear in the order in which they were constructed.
  const auto known = std::any_of(ledger.parts_.begin(), ledger.parts_.end(),
                                 [&](const results::PartCost& cost) { return cost.part == part; });
  if (!known) ledger.parts_.push_back({.part = part_});
}

Ledger::Visit::~Visit() {
  const auto cost = std::find_if(ledger_->parts_.begin(), ledger_->parts_.end(),
                                 [&](const results::PartCost& candidate) { return candidate.part == part_; });
  cost->calls += 1;
  cost->matrix_entries += entries_;
  cost->seconds += stopwatch_.cpu();
  entry(ledger_->seconds_, phase_) += stopwatch_.wall();
}

void Ledger::count(std::string_view what, long long by) {
  entry(counts_, what) += by;
}

void Ledger::close(results::RunSummary& summary) const {
  summary.parts = parts_;
  summary.counts = counts_;
  summary.seconds = seconds_;
  summary.seconds.emplace_back("total", total_.wall());
}

}  // namespace sunder::simulation
