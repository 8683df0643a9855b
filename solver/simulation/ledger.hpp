#pragma once
/// What each part of a run did and cost: the proof that a scene does not pay for what it does not have.

#include <string>
#include <string_view>

#include "solver/numerics/stopwatch.hpp"
#include "solver/results/run_summary.hpp"

namespace sunder::simulation {

class Ledger {
 public:
  /// Counts one call of `part` and, until it is destroyed, its CPU time; the wall time goes to `phase`.
  class Visit {
   public:
    Visit(Ledger& ledger, std::string_view part, std::string_view phase);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    void add_entries(long long entries) { entries_ += entries; }

   private:
    Ledger* ledger_;
    std::string part_, phase_;
    long long entries_ = 0;
    numerics::Stopwatch stopwatch_;
  };

  void count(std::string_view what, long long by = 1);

  /// Writes parts, counts and seconds (with `total` since the ledger was made) into the summary.
  void close(results::RunSummary& summary) const;

 private:
  std::vector<results::PartCost> parts_;
  std::vector<std::pair<std::string, long long>> counts_;
  std::vector<std::pair<std::string, double>> seconds_;
  numerics::Stopwatch total_;
};

}  // namespace sunder::simulation
