#include "verification/harness/negatives.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "verification/harness/fault_names.hpp"
#include "verification/harness/isolation.hpp"
#include "verification/harness/runner.hpp"
#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

// A stand-in for the faults of the solver: what a study asks for while it runs.
std::string planted_here;
bool reached_here = false;
const FaultControl control{[](std::string_view name) {
                             planted_here = name;
                             reached_here = false;
                           },
                           [] { return reached_here; }, nullptr, nullptr};  // nobody listens here
bool asks(const std::string& name) {
  if (planted_here != name) return false;
  reached_here = true;
  return true;
}

StudyOutput study(const StudyInput&) {
  double answer = 2.0;
  if (asks("fake/twice")) answer *= 2.0;
  if (asks("fake/harmless")) answer += 1e-9;
  if (asks("fake/throws")) throw std::runtime_error("broken");
  if (asks("fake/aborts")) std::abort();
  StudyOutput output;
  output.summary.quantities = results::Quantity(results::Quantity::Table{{"answer", answer}});
  return output;
}

std::string negative(const std::string& fault) {
  return "[[negative]]\nfault = \"" + fault + "\"\nchecks = [\"answer\"]\n";
}

CaseResult run(const std::string& text, bool isolated) {
  const TemporaryCases cases;
  const Case read = cases.read(text);
  return run_negatives(read, control, [&](const auto& before, const auto& after) {
    const auto body = [&] {
      before();
      CaseResult result = run_case(read, study);
      after(result);
      return result;
    };
    return isolated ? run_isolated(read, {}, body) : body();
  });
}

TEST(Negatives, TellKilledFromSurvivedFromNeverReached) {
  using Verdict = NegativeOutcome::Verdict;
  const std::string text = plain_head + exact_two + check_two + negative("fake/twice") + negative("fake/harmless") +
                           negative("fake/misspelt") + negative("fake/throws");
  for (const bool isolated : {false, true}) {
    const CaseResult result = run(text, isolated);
    ASSERT_EQ(result.negatives.size(), 4u);
    EXPECT_EQ(result.negatives[0].verdict, Verdict::killed);
    EXPECT_EQ(result.negatives[0].red, std::vector<std::string>{"answer"});
    EXPECT_EQ(result.negatives[1].verdict, Verdict::survived);
    EXPECT_TRUE(result.negatives[1].reached);
    EXPECT_EQ(result.negatives[2].verdict, Verdict::never_reached);
    EXPECT_EQ(result.negatives[3].verdict, Verdict::killed);
    EXPECT_TRUE(fails(result.status));
    EXPECT_NE(result.message.find("2 of 4"), std::string::npos) << result.message;
    EXPECT_EQ(result.checks[0].status, Status::pass);  // the baseline
  }
}

TEST(Negatives, AnAbortIsNoticed) {
  const CaseResult result = run(plain_head + exact_two + check_two + negative("fake/aborts"), true);
  EXPECT_EQ(result.negatives[0].verdict, NegativeOutcome::Verdict::killed);
  EXPECT_EQ(result.status, Status::pass);
}

TEST(Negatives, NeedABaseline) {
  const std::string wrong = plain_head + exact_two + check_two + negative("fake/twice");
  const auto at = wrong.find("value = 2.0");
  const CaseResult result = run(std::string(wrong).replace(at, 11, "value = 7.0"), false);
  EXPECT_EQ(result.negatives[0].verdict, NegativeOutcome::Verdict::no_baseline);
  EXPECT_TRUE(fails(result.status));
}

TEST(FaultNames, ComeFromTheSources) {
  const TemporaryCases folder;
  folder.write(
      "solver/a/one.cpp",
      "if (planted_fault(\"a/one\")) x = numerics::planted_fault(\"a/two\") ? 1 : 2; planted_fault(\"a/one\");");
  folder.write("solver/b/three.cpp", "planted_fault(name)");
  folder.write("solver/b/three.hpp", "planted_fault(\"b/in-a-header\")");
  EXPECT_EQ(fault_names(folder.folders().cases.parent_path() / "solver"), (std::vector<std::string>{"a/one", "a/two"}));
}

}  // namespace
}  // namespace sunder::verification
