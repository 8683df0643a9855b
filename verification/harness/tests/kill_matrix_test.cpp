#include "verification/harness/kill_matrix.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "verification/harness/fault_coverage.hpp"
#include "verification/harness/isolation.hpp"
#include "verification/harness/runner.hpp"
#include "verification/harness/tests/json_schema.hpp"
#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

// A stand-in for the faults of the solver: what a study asks for while it runs.
std::string planted_here;
bool listening_here = false;
std::set<std::string> asked_here;
const FaultControl control{[](std::string_view name) {
                             planted_here = name;
                             listening_here = false;
                           },
                           [] { return true; },
                           [] {
                             planted_here.clear();
                             listening_here = true;
                             asked_here.clear();
                           },
                           [] { return std::vector<std::string>(asked_here.begin(), asked_here.end()); }};
bool asks(const std::string& name) {
  if (listening_here) asked_here.insert(name);
  return name == planted_here;
}

StudyOutput study(const StudyInput&) {
  double answer = 2.0, other = 3.0;
  if (asks("fake/twice")) answer *= 2.0;
  if (asks("fake/harmless")) answer += 1e-9;
  if (asks("fake/aborts")) std::abort();
  if (other < 0.0 && asks("fake/never-reached")) other = 0.0;
  StudyOutput output;
  output.summary.quantities = results::Quantity(results::Quantity::Table{{"answer", answer}, {"other", other}});
  return output;
}

const std::string two_checks = plain_head + exact_two + check_two +
                               "[[check]]\nname = \"idle\"\nkind = \"bound\"\nquantity = \"other\"\nat_least = 0\n"
                               "basis = \"physics\"\nreason = \"three is positive\"\n";

KillMatrix measured(const std::string& text, const std::vector<std::string>& only = {}) {
  const TemporaryCases cases;
  const Case read = cases.read(text);
  return kill_matrix(
      read, control,
      [&](const auto& before, const auto& after) {
        return run_isolated(read, {}, [&] {
          before();
          CaseResult result = run_case(read, study);
          after(result);
          return result;
        });
      },
      only);
}

TEST(KillMatrix, FindsTheFaultsThatARunComesByAndTheChecksThatNoticeThem) {
  const KillMatrix matrix = measured(two_checks);
  EXPECT_EQ(matrix.baseline, Status::pass);
  ASSERT_EQ(matrix.effects.size(), 3u);  // by name; the fault that is not reached is not there
  EXPECT_EQ(matrix.effects[0].fault, "fake/aborts");
  EXPECT_EQ(matrix.effects[1].fault, "fake/harmless");
  EXPECT_EQ(matrix.effects[2].fault, "fake/twice");
  using Red = std::vector<std::pair<std::string, Status>>;
  EXPECT_EQ(matrix.effects[0].red, (Red{{"answer", Status::crash}, {"idle", Status::crash}}));
  EXPECT_EQ(matrix.effects[1].red, Red{});
  EXPECT_EQ(matrix.effects[2].red, (Red{{"answer", Status::wrong_value}}));
  const KillMatrix one = measured(two_checks, {"fake/twice"});
  ASSERT_EQ(one.effects.size(), 1u);
  EXPECT_NE(report_text(one).find("idle (bound): no fault turns it red"), std::string::npos) << report_text(one);
  EXPECT_EQ(report_text(one).find("answer ("), std::string::npos);
}

TEST(KillMatrix, NeedsABaseline) {
  std::string wrong = two_checks;
  wrong.replace(wrong.find("value = 2.0"), 11, "value = 7.0");
  const KillMatrix matrix = measured(wrong);
  EXPECT_EQ(matrix.baseline, Status::wrong_value);
  EXPECT_TRUE(matrix.effects.empty());
}

TEST(KillMatrix, FollowsItsSchema) {
  std::ifstream stream("verification/harness/kill-matrix.schema.json");  // tests run in the project's folder
  const JsonSchema schema(nlohmann::json::parse(stream));
  const auto line = nlohmann::json::parse(to_json(measured(two_checks), environment(1, "abc")));
  EXPECT_EQ(schema.complaint(line), "");
  EXPECT_EQ(line["faults"][2]["red"]["answer"], "wrong value");
  EXPECT_EQ(line["gating_checks"]["idle"], "bound");
}

TEST(FaultCoverage, ListsFaultsWithoutACaseAndChecksWithoutAFault) {
  const TemporaryCases cases;
  const Case idle = cases.read(two_checks + "[[negative]]\nfault = \"fake/twice\"\nchecks = [\"answer\"]\n");
  const std::string check = "demo/number: idle";
  const FaultCoverage coverage = fault_coverage({idle}, {"fake/harmless", "fake/twice"}, {});
  EXPECT_EQ(coverage.unnamed_faults, std::vector<std::string>{"fake/harmless"});
  EXPECT_EQ(coverage.idle_checks, std::vector<std::string>{check});
  EXPECT_TRUE(coverage.unknown_faults.empty());
  EXPECT_FALSE(coverage.sound());
  EXPECT_EQ(fault_coverage({idle}, {}, {}).unknown_faults.size(), 1u);
  EXPECT_FALSE(fault_coverage({idle}, {"fake/twice"}, {}).sound());
  EXPECT_TRUE(fault_coverage({idle}, {"fake/twice"}, {check}).sound());
  const Case whole = cases.read(two_checks + "[[negative]]\nfault = \"fake/twice\"\nchecks = [\"answer\", \"idle\"]\n");
  EXPECT_TRUE(fault_coverage({whole}, {"fake/twice"}, {}).sound());
  EXPECT_EQ(fault_coverage({whole}, {"fake/twice"}, {check}).stale, std::vector<std::string>{check});
  std::string informing = two_checks;  // a check that does not gate stops nothing, and needs no fault
  informing.replace(informing.find("at_least"), 0, "gates = false\n");
  const Case beside = cases.read(informing + "[[negative]]\nfault = \"fake/twice\"\nchecks = [\"answer\"]\n");
  EXPECT_TRUE(fault_coverage({beside}, {"fake/twice"}, {}).sound());
}

TEST(FaultCoverage, KeepsItsListInAFile) {
  const TemporaryCases cases;
  const auto file = cases.write("idle-checks.txt", "# a note\n\na/b: one\n");
  EXPECT_EQ(read_idle_checks(file), std::vector<std::string>{"a/b: one"});
  write_idle_checks(file, {"a/b: two", "c/d: three"});
  EXPECT_EQ(read_idle_checks(file), (std::vector<std::string>{"a/b: two", "c/d: three"}));
  EXPECT_TRUE(read_idle_checks(file / "nowhere").empty());
}

}  // namespace
}  // namespace sunder::verification
