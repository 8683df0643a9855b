#pragma once
/// Ctrl-C ends a run in good order: the first asks it to stop with what was reached, the second ends the program.

#include <atomic>

namespace sunder::app {

/// Listens for SIGINT and SIGTERM as long as it lives; at most one at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// Becomes true with the first signal.
  const std::atomic<bool>& stop() const;

  /// 130 after Ctrl-C, 143 after SIGTERM (128 + signal), 0 where there was none.
  int exit_status() const;
};

}  // namespace sunder::app
