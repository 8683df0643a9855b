#include "verification/harness/isolation.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include "verification/harness/record.hpp"
#include "verification/harness/runner.hpp"

namespace sunder::verification {
namespace {

constexpr int out_of_memory = 90, threw = 91, cut_off = 92;  // exit statuses of the child besides 0

/// Sanitizers reserve terabytes of addresses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

void limit_memory(double gibibytes) {
  if (gibibytes > 0.0 && !sanitized) {
    const auto bytes = static_cast<rlim_t>(gibibytes * 1024.0 * 1024.0 * 1024.0);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

bool write_all(int pipe, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = write(pipe, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

[[noreturn]] void child(int pipe, const IsolationLimits& limits, const std::function<CaseResult()>& run) {
  limit_memory(limits.memory);
  int status = 0;
  std::string line;
  try {
    line = to_json(run(), environment(1, ""));
  } catch (const std::bad_alloc&) {
    status = out_of_memory;
  } catch (const std::exception& error) {
    status = threw;
    line = error.what();
  }
  if (!write_all(pipe, line)) status = cut_off;
  std::fflush(nullptr);
  _exit(status);
}

/// Reads until the child closes its end; false when the time is up first.
bool read_until(int pipe, std::chrono::steady_clock::time_point deadline, std::string& text) {
  char buffer[65536];
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    if (left <= 0) return false;
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1'000'000)));
    if (ready < 0 && errno != EINTR) return true;
    if (ready <= 0) continue;
    const ssize_t n = read(pipe, buffer, sizeof buffer);
    if (n == 0) return true;
    if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

IsolationLimits limits_of(const Case& verification_case) {
  IsolationLimits limits;
  switch (verification_case.tier) {
    case Tier::quick:
      limits.seconds = 60.0;
      break;
    case Tier::full:
      limits.seconds = 600.0;
      break;
    case Tier::long_:
      limits.seconds = 7200.0;
      break;
  }
  limits.memory = std::max(limits.memory, 1.5 * verification_case.needs.memory);
  return limits;
}

CaseResult run_isolated(const Case& verification_case, const IsolationLimits& limits,
                        const std::function<CaseResult()>& run) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
  if (process == 0) {
    close(ends[0]);
    child(ends[1], limits, run);
  }
  close(ends[1]);
  std::string line;
  const auto deadline =
      std::chrono::steady_clock::now() +
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(limits.seconds));
  const bool in_time = read_until(ends[0], deadline, line);
  if (!in_time) kill(process, SIGKILL);
  close(ends[0]);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (!in_time)
    return unfinished(verification_case, Status::timeout,
                      "did not end within " + std::to_string(limits.seconds) + " s");
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGKILL)
      return unfinished(verification_case, Status::memory, "ended by the system, most likely for its memory");
    return unfinished(verification_case, Status::crash, std::string("signal: ") + strsignal(WTERMSIG(status)));
  }
  switch (WEXITSTATUS(status)) {
    case 0:
      return from_json(line);
    case out_of_memory:
      return unfinished(verification_case, Status::memory, "out of memory");
    case threw:
      return unfinished(verification_case, Status::crash, "exception: " + line);
    default:
      return unfinished(verification_case, Status::crash,
                        "exit status " + std::to_string(WEXITSTATUS(status)) + " without a result");
  }
}

}  // namespace sunder::verification
