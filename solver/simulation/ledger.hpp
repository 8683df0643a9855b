#pragma once
/// What each part of a run did and cost: the proof that a scene does not pay for what it does not have.
///
/// A visit's CPU time and memory belong to its part alone: while a visit inside it lasts, they are the inner one's. So
/// the parts' seconds add up to no more than the run's. Work that every step does is metered where it is done
/// (numerics/meter.hpp) and moved to its part afterwards.

#include <string>
#include <string_view>

#include "solver/numerics/meter.hpp"
#include "solver/numerics/stopwatch.hpp"
#include "solver/results/run_summary.hpp"

namespace sunder::simulation {

class Ledger {
 public:
  /// Counts one call of `part` and, until it is destroyed, its CPU time and the memory that it has taken and not given
  /// back; the wall time goes to `phase`, inner visits included. Visits end in the reverse order of their beginning.
  class Visit {
   public:
    Visit(Ledger& ledger, std::string_view part, std::string_view phase);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    void add_entries(long long entries);

   private:
    Ledger* ledger_;
    std::size_t part_, outer_;
    std::string phase_;
    numerics::Stopwatch stopwatch_;
  };

  void count(std::string_view what, long long by = 1);

  /// Work that was metered inside visits of `from` is `to`'s: its calls and seconds move there.
  void move(std::string_view from, std::string_view to, const numerics::Meter& work);

  /// Writes parts, counts and seconds (with `total` since the ledger was made) into the summary.
  void close(results::RunSummary& summary) const;

 private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  std::size_t part(std::string_view name);
  void turn_to(std::size_t part);

  std::vector<results::PartCost> parts_;
  std::vector<std::pair<std::string, long long>> counts_;
  std::vector<std::pair<std::string, double>> seconds_;
  numerics::Stopwatch total_;
  std::size_t current_ = nobody;  // whose time it is, since total_.cpu() was `turned_` and the heap held `held_`
  double turned_ = 0.0;
  long long held_ = 0;
};

}  // namespace sunder::simulation
