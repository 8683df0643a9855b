#pragma once
/// Wall and CPU seconds since the stopwatch was made.

#include <chrono>
#include <ctime>

namespace sunder::numerics {

class Stopwatch {
 public:
  /// Elapsed wall time [s].
  double wall() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// CPU time of all threads of this process [s]: what to compare on a machine that others use too.
  double cpu() const { return process_cpu() - cpu_start_; }

 private:
  using Clock = std::chrono::steady_clock;
  static double process_cpu() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  Clock::time_point start_ = Clock::now();
  double cpu_start_ = process_cpu();
};

}  // namespace sunder::numerics
