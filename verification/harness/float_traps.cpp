#include "verification/harness/float_traps.hpp"

#include <execinfo.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstring>

namespace sunder::verification {
namespace {

constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

const char* name_of(int code) {
  switch (code) {
    case FPE_FLTDIV:
      return "floating-point trap: division by zero\n";
    case FPE_FLTOVF:
      return "floating-point trap: overflow\n";
    case FPE_FLTINV:
      return "floating-point trap: invalid operation\n";
    default:
      return "floating-point trap\n";
  }
}

/// Says which and where, and lets the signal end the program after all.
void report(int signal, siginfo_t* info, void* /*context*/) {
  const char* name = name_of(info->si_code);
  void* frames[16];
  if (write(STDERR_FILENO, name, std::strlen(name)) > 0)
    backtrace_symbols_fd(frames, backtrace(frames, 16), STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

FloatTraps::FloatTraps(bool set) : set_(set) {
  if (!set_) return;
  void* frame;
  static_cast<void>(backtrace(&frame, 1));  // loads what it needs: no allocation in the handler
  struct sigaction action {};
  action.sa_sigaction = report;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGFPE, &action, nullptr);
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(trapped);
}

FloatTraps::~FloatTraps() {
  if (set_) fedisableexcept(trapped);
}

}  // namespace sunder::verification
