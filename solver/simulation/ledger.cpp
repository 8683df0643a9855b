#include "solver/simulation/ledger.hpp"

#include <malloc.h>

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

/// Bytes that the program holds of its heap.
long long heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<long long>(heap.uordblks + heap.hblkhd);
}

}  // namespace

Ledger::Visit::Visit(Ledger& ledger, std::string_view part, std::string_view phase)
    : ledger_(&ledger), part_(ledger.part(part)), outer_(ledger.current_), phase_(phase) {
  ledger.turn_to(part_);
}

Ledger::Visit::~Visit() {
  ledger_->parts_[part_].calls += 1;
  entry(ledger_->seconds_, phase_) += stopwatch_.wall();
  ledger_->turn_to(outer_);
}

void Ledger::Visit::add_entries(long long entries) {
  ledger_->parts_[part_].matrix_entries += entries;
}

/// Listed when it is entered: parts appear in the order in which they were constructed.
std::size_t Ledger::part(std::string_view name) {
  const auto known =
      std::find_if(parts_.begin(), parts_.end(), [&](const results::PartCost& cost) { return cost.part == name; });
  if (known == parts_.end()) {
    parts_.push_back({.part = std::string(name)});
    return parts_.size() - 1;
  }
  return static_cast<std::size_t>(known - parts_.begin());
}

void Ledger::turn_to(std::size_t part) {
  const double now = total_.cpu();
  const long long held = heap_bytes();
  if (current_ != nobody) {
    parts_[current_].seconds += now - turned_;
    parts_[current_].bytes += held - held_;
  }
  current_ = part;
  turned_ = now;
  held_ = held;
}

void Ledger::count(std::string_view what, long long by) {
  entry(counts_, what) += by;
}

void Ledger::move(std::string_view from, std::string_view to, const numerics::Meter& work) {
  if (work.calls() == 0) return;
  const std::size_t source = part(from), target = part(to);
  parts_[target].calls += work.calls();
  parts_[target].seconds += work.seconds();
  parts_[source].seconds -= work.seconds();
}

void Ledger::close(results::RunSummary& summary) const {
  summary.parts = parts_;
  // a sample may overrate what was moved away; memory that was given back here was taken elsewhere
  for (results::PartCost& cost : summary.parts) {
    cost.seconds = std::max(cost.seconds, 0.0);
    cost.bytes = std::max(cost.bytes, 0LL);
  }
  summary.counts = counts_;
  summary.seconds = seconds_;
  summary.seconds.emplace_back("total", total_.wall());
}

}  // namespace sunder::simulation
