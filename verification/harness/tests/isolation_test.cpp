#include "verification/harness/isolation.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "verification/harness/runner.hpp"

namespace sunder::verification {
namespace {

Case some_case() {
  Case some;
  some.id = "demo/number";
  some.family = "demo";
  return some;
}

TEST(Isolation, BringsTheResultBack) {
  const CaseResult result = run_isolated(some_case(), {}, [] {
    CaseResult inside = unfinished(some_case(), Status::pass, "from the child");
    inside.pins = {{"pin", {0.1, 1e300}}};
    return inside;
  });
  EXPECT_EQ(result.status, Status::pass);
  EXPECT_EQ(result.message, "from the child");
  EXPECT_EQ(result.pins.at(0).second, (std::vector<double>{0.1, 1e300}));
}

TEST(Isolation, ACrashIsAVerdict) {
  const CaseResult result = run_isolated(some_case(), {}, []() -> CaseResult {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would turn the signal into an exit status
    raise(SIGSEGV);
    std::abort();
  });
  EXPECT_EQ(result.status, Status::crash);
  EXPECT_NE(result.message.find("Segmentation fault"), std::string::npos) << result.message;
  EXPECT_EQ(result.id, "demo/number");
}

TEST(Isolation, AnExceptionAndASilentExitAreVerdicts) {
  const CaseResult thrown = run_isolated(some_case(), {}, []() -> CaseResult { throw std::runtime_error("lost"); });
  EXPECT_EQ(thrown.status, Status::crash);
  EXPECT_NE(thrown.message.find("lost"), std::string::npos);
  const CaseResult left = run_isolated(some_case(), {}, []() -> CaseResult { _exit(3); });
  EXPECT_EQ(left.status, Status::crash);
  EXPECT_NE(left.message.find("exit status 3"), std::string::npos) << left.message;
}

TEST(Isolation, EndsWhatDoesNotEnd) {
  const CaseResult result = run_isolated(some_case(), {.seconds = 0.2}, []() -> CaseResult {
    for (;;) pause();
  });
  EXPECT_EQ(result.status, Status::timeout);
}

TEST(Isolation, LimitsTheMemory) {
  const CaseResult thrown = run_isolated(some_case(), {}, []() -> CaseResult { throw std::bad_alloc(); });
  EXPECT_EQ(thrown.status, Status::memory);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const CaseResult greedy = run_isolated(some_case(), {.memory = 1.0}, [] {
    const std::vector<double> large(std::size_t{1} << 28);  // 2 GiB
    return unfinished(some_case(), Status::pass, std::to_string(large.back()));
  });
  EXPECT_EQ(greedy.status, Status::memory);
#endif
}

}  // namespace
}  // namespace sunder::verification
