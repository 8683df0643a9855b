#include "verification/harness/measure.hpp"

#include <sys/resource.h>

#include <ctime>
#include <fstream>
#include <string>

namespace sunder::verification {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void forget_peak_memory() {
  std::ofstream("/proc/self/clear_refs")
      << "5";  // resets VmHWM; without /proc the peak stays that of the whole process
}

long peak_resident_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6)) * 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

}  // namespace sunder::verification
