#pragma once
/// Calls and CPU seconds of a piece of work that every step does, cheaply enough to stay in the step.
///
/// Reading the CPU clock costs 0.7 μs where it is a system call, which would be several per cent of a short step. So
/// the calls are all counted, but only the first and every eighth of them is timed; `seconds` scales the sample up.

#include <optional>

#include "solver/numerics/stopwatch.hpp"

namespace sunder::numerics {

class Meter {
 public:
  /// One call, from here to the end of the scope.
  class Lap {
   public:
    explicit Lap(Meter& meter) : meter_(meter) {
      if (meter.calls_++ % every == 0) watch_.emplace();
    }
    ~Lap() {
      if (!watch_) return;
      meter_.timed_ += 1;
      meter_.sample_ += watch_->cpu();
    }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;

   private:
    Meter& meter_;
    std::optional<Stopwatch> watch_;
  };

  long calls() const { return calls_; }
  /// Of all calls, estimated from those that were timed [s].
  double seconds() const {
    return timed_ > 0 ? sample_ * (static_cast<double>(calls_) / static_cast<double>(timed_)) : 0.0;
  }

 private:
  static constexpr long every = 8;
  long calls_ = 0, timed_ = 0;
  double sample_ = 0.0;
};

}  // namespace sunder::numerics
