#include "solver/app/interrupt.hpp"

#include <csignal>

namespace sunder::app {
namespace {

// A signal handler can reach nothing but globals.
std::atomic<bool> stop_asked = false;
std::atomic<int> signal_caught = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);
struct sigaction interrupt_before, terminate_before;

extern "C" void ask_to_stop(int signal) {
  signal_caught.store(signal);
  stop_asked.store(true);
}

}  // namespace

InterruptWatch::InterruptWatch() {
  stop_asked.store(false);
  signal_caught.store(0);
  struct sigaction action = {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  // The second signal meets the default action, and system calls are resumed, so that a write in progress is not cut.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &interrupt_before);
  sigaction(SIGTERM, &action, &terminate_before);
}

InterruptWatch::~InterruptWatch() {
  sigaction(SIGINT, &interrupt_before, nullptr);
  sigaction(SIGTERM, &terminate_before, nullptr);
}

const std::atomic<bool>& InterruptWatch::stop() const {
  return stop_asked;
}

int InterruptWatch::exit_status() const {
  return signal_caught.load() == 0 ? 0 : 128 + signal_caught.load();
}

}  // namespace sunder::app
