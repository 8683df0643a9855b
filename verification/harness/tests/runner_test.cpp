#include "verification/harness/runner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

using results::Quantity;

/// A study that answers what it is told to.
Study answering(double answer) {
  return [answer](const StudyInput&) {
    StudyOutput output;
    output.summary.quantities = Quantity(Quantity::Table{{"answer", answer}, {"list", Quantity::List{}}});
    return output;
  };
}

/// A study whose answer is a function of the parameter h.
template <class Function>
Study answering_of_h(Function function) {
  return [function](const StudyInput& input) {
    StudyOutput output;
    output.summary.quantities = Quantity(Quantity::Table{{"answer", function(number_parameter(input, "h"))}});
    return output;
  };
}

CaseResult run(const std::string& text, const Study& study, const RunnerOptions& options = {}) {
  const TemporaryCases cases;
  return run_case(cases.read(text), study, options);
}

const std::string whole = plain_head + exact_two + check_two;
const std::string halving = "[sweep.keys]\nparameters.h = [1, 0.5, 0.25, 0.125, 0.0625]\n";
const std::string order_check =
    "[[check]]\nname = \"order\"\nkind = \"order\"\nquantity = \"answer\"\nreference = \"two\"\nover = "
    "\"parameters.h\"\n"
    "expected = 2\nwindow = 0.1\nfloor = 1e-12\nbasis = \"discretisation\"\nreason = \"the study is of second "
    "order\"\n";

TEST(Runner, ComparesAndTellsTheSlack) {
  const CaseResult right = run(whole, answering(2.001));
  EXPECT_EQ(right.status, Status::pass);
  ASSERT_EQ(right.checks.size(), 1u);
  EXPECT_NEAR(right.checks[0].error, 5e-4, 1e-12);
  EXPECT_NEAR(right.checks[0].slack, 2.0, 1e-9);
  EXPECT_EQ(slack_word(right.checks[0]), "");
  EXPECT_EQ(slack_word(run(whole, answering(2.00199)).checks[0]), "tight");
  EXPECT_EQ(slack_word(run(whole, answering(2.00001)).checks[0]), "loose");
  EXPECT_EQ(run(whole, answering(2.01)).status, Status::wrong_value);
}

TEST(Runner, NotANumberFailsBeforeAnythingElse) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const CaseResult result = run(whole, answering(bad));
    EXPECT_EQ(result.status, Status::wrong_value);
    EXPECT_NE(result.checks[0].message.find("answer is not a finite number"), std::string::npos);
  }
  // A quantity that no check looks at counts too.
  const Study hidden = [](const StudyInput&) {
    StudyOutput output;
    output.summary.quantities =
        Quantity(Quantity::Table{{"answer", 2.0}, {"other", Quantity(std::vector<double>{1.0, std::nan("")})}});
    return output;
  };
  EXPECT_NE(run(whole, hidden).checks[0].message.find("other[1]"), std::string::npos);
}

TEST(Runner, CheckedNothingFails) {
  const std::string of_list = plain_head + exact_two +
                              "[[check]]\nname = \"none\"\nquantity = \"list\"\nreference = \"two\"\ntolerance = 1\n"
                              "basis = \"physics\"\nreason = \"an empty list holds no number\"\n";
  EXPECT_EQ(run(of_list, answering(2.0)).status, Status::checked_nothing);
  const CaseResult absent = run(plain_head + exact_two +
                                    "[[check]]\nname = \"none\"\nquantity = \"reply\"\nreference = \"two\"\n"
                                    "tolerance = 1\nbasis = \"physics\"\nreason = \"misspelt\"\n",
                                answering(2.0));
  EXPECT_EQ(absent.status, Status::checked_nothing);
  EXPECT_NE(absent.checks[0].message.find("answer, list"), std::string::npos) << absent.checks[0].message;
  EXPECT_EQ(worst({}), Status::checked_nothing);
}

TEST(Runner, NamesHowARunEnded) {
  const auto status = [](const Study& study) { return run(whole, study).status; };
  EXPECT_EQ(status([](const StudyInput&) -> StudyOutput { throw std::invalid_argument("nu = 0.5, must be < 0.5"); }),
            Status::refused);
  EXPECT_EQ(status([](const StudyInput&) -> StudyOutput { throw std::bad_alloc(); }), Status::memory);
  EXPECT_EQ(status([](const StudyInput&) -> StudyOutput { throw std::runtime_error("lost"); }), Status::crash);
  EXPECT_EQ(status([](const StudyInput&) {
              StudyOutput output;
              output.summary.status = "stopped: 200 iterations";
              return output;
            }),
            Status::not_converged);
}

TEST(Runner, ARefusalCanBeTheRightAnswer) {
  const std::string refusing = plain_head +
                               "[[check]]\nname = \"refuses\"\nkind = \"refused\"\nmessage = \"must be < 0.5\"\n"
                               "reason = \"the plane-strain law is singular there\"\n";
  const Study refuses = [](const StudyInput&) -> StudyOutput {
    throw std::invalid_argument("nu = 0.5, must be < 0.5");
  };
  const Study other = [](const StudyInput&) -> StudyOutput { throw std::invalid_argument("no mesh"); };
  EXPECT_EQ(run(refusing, refuses).status, Status::pass);
  EXPECT_EQ(run(refusing, other).status, Status::wrong_value);
  EXPECT_EQ(run(refusing, answering(2.0)).status, Status::wrong_value);
}

TEST(Runner, GatesOnTheOrder) {
  const std::string text = plain_head + halving + exact_two + order_check;
  const CaseResult second = run(text, answering_of_h([](double h) { return 2.0 + h * h; }));
  EXPECT_EQ(second.status, Status::pass);
  EXPECT_NEAR(second.checks[0].orders.at(0).order, 2.0, 1e-10);
  EXPECT_EQ(run(text, answering_of_h([](double h) { return 2.0 + h; })).status, Status::wrong_order);
  EXPECT_EQ(run(text, answering_of_h([](double h) { return 2.0 + 1.0 / h; })).status, Status::wrong_order);
  EXPECT_EQ(run(text, answering_of_h([](double) { return 2.0; })).status, Status::checked_nothing);  // at the floor
}

TEST(Runner, KeepsClassRichardsonValueAndConvergenceIndexOfAnOrder) {
  // The NASA triplet (order_test.cpp) with a fourth grid that its own power law gives at h = 8: the finest three
  // decide.
  const std::string text = plain_head + "[sweep.keys]\nparameters.h = [8, 4, 2, 1]\n" +
                           "[[check]]\nname = \"order\"\nkind = \"order\"\nquantity = \"answer\"\n"
                           "law = \"second order, less what the shock costs\"\nover = \"parameters.h\"\n"
                           "expected = 1.786\nwindow = 0.001\nbasis = \"discretisation\"\nreason = \"as printed\"\n";
  const CaseResult result = run(text, answering_of_h([](double h) {
                                  return h == 1.0 ? 0.97050 : h == 2.0 ? 0.96854 : h == 4.0 ? 0.96178 : 0.93847;
                                }));
  EXPECT_EQ(result.status, Status::pass);
  const OrderEstimate& order = result.checks.at(0).orders.at(0);
  EXPECT_EQ(order.convergence, Convergence::monotone);
  EXPECT_EQ(order.levels_used, 4);
  EXPECT_NEAR(order.extrapolated, 0.97130, 5e-6);
  EXPECT_NEAR(order.convergence_index, 0.00103, 5e-6);
}

TEST(Runner, OrdersMayOscillateAndMeetTheFloor) {
  // (-1/4)^k: second order with alternating signs; from the fifth level on round-off of 1e-12 of either sign.
  const std::string text =
      plain_head + "[sweep.keys]\nparameters.h = [1, 0.5, 0.25, 0.125, 0.0625, 0.03125]\n" + exact_two + order_check;
  const auto swinging = [](double h) {
    const int level = static_cast<int>(std::lround(-std::log2(h)));
    return level < 5 ? 2.0 + 1e-8 * std::pow(-0.25, level) : 2.0 - 4e-13;
  };
  const CaseResult result = run(text, answering_of_h(swinging));
  EXPECT_EQ(result.status, Status::pass);
  EXPECT_EQ(result.checks.at(0).orders.at(0).convergence, Convergence::oscillatory);
  EXPECT_EQ(result.checks.at(0).orders.at(0).levels_used, 5);
}

TEST(Runner, RecordsErrorAndCostOfEverySetting) {
  const CaseResult result = run(plain_head + halving + exact_two + check_two + "at = \"last\"\nscale = 4\n",
                                answering_of_h([](double h) { return 2.0 + 0.5 * h * h; }));
  EXPECT_EQ(result.status, Status::pass);  // 0.5 / 256 / 4 = 4.9e-4
  ASSERT_EQ(result.settings.size(), 5u);
  EXPECT_EQ(result.settings[0].errors.at(0).second, 0.125);
  EXPECT_EQ(result.settings[1].keys.at(0).second, "0.5");
  EXPECT_GE(result.settings[0].cpu_seconds, 0.0);
  EXPECT_GT(result.settings[0].peak_bytes, 0);
}

TEST(Runner, RepeatsUntilTheMedianIsSettledAndHoldsTheBits) {
  int calls = 0;
  const Study steady = [&](const StudyInput& input) {
    ++calls;
    volatile double work = 0.0;
    for (int i = 0; i < 200000; ++i) work = work + std::sqrt(i);
    return answering(2.0)(input);
  };
  const CaseResult result = run(whole, steady, {.repeat = true, .spread = 0.5});
  EXPECT_EQ(result.status, Status::pass);
  EXPECT_GE(calls, 6);  // no interval of 95 % from fewer
  EXPECT_EQ(result.settings[0].repeats, calls);
  double answer = 2.0;
  const Study drifting = [&](const StudyInput& input) {
    return answering(answer = std::nextafter(answer, 3.0))(input);
  };
  EXPECT_EQ(run(whole, drifting, {.repeat = true}).status, Status::broken_invariant);
}

/// A case that lists parts, and a study whose run entered others.
CaseResult run_with_parts(const std::string& listed, const std::vector<results::PartCost>& entered) {
  std::string text = whole;
  text.replace(text.find("modules = []"), 12, "modules = [" + listed + "]");
  return run(text, [&](const StudyInput& input) {
    StudyOutput output = answering(2.0)(input);
    output.summary.parts = entered;
    return output;
  });
}

TEST(Runner, HoldsTheContractOnParts) {
  const CaseResult wandering =
      run_with_parts("\"numerics\"", {{.part = "numerics", .calls = 3}, {.part = "crackwater", .calls = 1}});
  EXPECT_EQ(wandering.status, Status::broken_invariant);
  EXPECT_NE(wandering.checks.back().message.find("crackwater"), std::string::npos);
  const CaseResult staying = run_with_parts("\"numerics\"", {{.part = "numerics", .calls = 3}, {.part = "crackwater"}});
  EXPECT_EQ(staying.status, Status::pass);
  EXPECT_EQ(staying.checks.back().message, "");
  const results::PartCost one_cost[] = {{.part = "crackwater", .calls = 1},
                                        {.part = "crackwater", .matrix_entries = 1},
                                        {.part = "crackwater", .seconds = 1e-9},
                                        {.part = "crackwater", .bytes = 1}};
  for (const results::PartCost& cost : one_cost) EXPECT_EQ(run_with_parts("", {cost}).status, Status::broken_invariant);
}

TEST(Runner, SaysWhichListedPartWasNeverEntered) {
  const CaseResult idle = run_with_parts("\"sbfem\", \"contact\"", {{.part = "sbfem", .calls = 3}});
  EXPECT_EQ(idle.status, Status::pass);
  EXPECT_EQ(idle.checks.back().message, "listed but never entered: contact");
  const CaseResult uncounted = run_with_parts("\"sbfem\"", {});
  EXPECT_EQ(uncounted.status, Status::checked_nothing);
}

TEST(Runner, PinsTellChange) {
  const std::string pinned = plain_head +
                             "[[check]]\nname = \"pin\"\nkind = \"pin\"\nquantity = \"answer\"\ntolerance = 1e-12\n"
                             "basis = \"round-off\"\nreason = \"one addition\"\n";
  const CaseResult without = run(pinned, answering(2.0));
  EXPECT_EQ(without.status, Status::checked_nothing);
  ASSERT_EQ(without.pins.size(), 1u);
  EXPECT_EQ(without.pins[0].second, std::vector<double>{2.0});
  EXPECT_EQ(run(pinned, answering(2.0), {.pins = {{"pin", {2.0}}}}).status, Status::pass);
  EXPECT_EQ(run(pinned, answering(2.1), {.pins = {{"pin", {2.0}}}}).status, Status::changed_pin);
}

TEST(Runner, InvariantsAndBounds) {
  const std::string checks =
      plain_head +
      "[[check]]\nname = \"kept\"\nkind = \"invariant\"\nquantity = \"answer - 2\"\nlaw = \"sum\"\n"
      "tolerance = 1e-12\nbasis = \"round-off\"\nreason = \"one addition\"\n"
      "[[check]]\nname = \"bound\"\nkind = \"bound\"\nquantity = \"answer\"\nat_least = 1\nat_most = 3\n"
      "basis = \"physics\"\nreason = \"between its parts\"\n";
  EXPECT_EQ(run(checks, answering(2.0)).status, Status::pass);
  const CaseResult off = run(checks, answering(2.5));
  EXPECT_EQ(off.checks[0].status, Status::broken_invariant);
  EXPECT_EQ(off.checks[1].status, Status::pass);
  EXPECT_EQ(run(checks, answering(3.5)).checks[1].status, Status::wrong_value);
  EXPECT_EQ(run(checks, answering(0.5)).checks[1].status, Status::wrong_value);
}

TEST(Runner, KnownLimitsExpire) {
  const std::string text = whole + "known_limit = { reason = \"not refined yet\", expires = \"2030-01-01\" }\n";
  EXPECT_EQ(run(text, answering(2.5), {.today = "2029-12-31"}).status, Status::known_limit);
  EXPECT_EQ(run(text, answering(2.5), {.today = "2030-01-01"}).status, Status::wrong_value);
  EXPECT_TRUE(fails(run(text, answering(2.0), {.today = "2029-12-31"}).status));  // the mark must go
}

TEST(Runner, ChecksThatOnlyInformDoNotGate) {
  const std::string text =
      whole +
      "[[check]]\nname = \"beside\"\nquantity = \"answer\"\nreference = \"two\"\ntolerance = 1e-9\n"
      "gates = false\nbasis = \"uncertainty\"\nreason = \"printed without its inputs\"\n";
  const CaseResult result = run(text, answering(2.001));
  EXPECT_EQ(result.checks[1].status, Status::wrong_value);
  EXPECT_EQ(result.status, Status::pass);
}

TEST(Runner, SkipsWhatTheMachineCannotRun) {
  const CaseResult result = run(plain_head + "[needs]\ncores = 100000\n" + exact_two + check_two, answering(2.0));
  EXPECT_EQ(result.status, Status::skipped);
  EXPECT_NE(result.message.find("100000 cores"), std::string::npos);
  const CaseResult memory = run(plain_head + "[needs]\nmemory = 1e9\n" + exact_two + check_two, answering(2.0));
  EXPECT_EQ(memory.status, Status::skipped);
  EXPECT_NE(memory.message.find("GiB of memory"), std::string::npos);
  EXPECT_FALSE(fails(memory.status));
  EXPECT_EQ(run(plain_head + "[needs]\nmemory = 0.001\n" + exact_two + check_two, answering(2.0)).status, Status::pass);
}

const std::string ladder =
    plain_head + "[ladder]\nrefusals = [\"too small\"]\n" + halving + exact_two + check_two + "at = \"every\"\n";

TEST(Ladder, StopsWithANamedReason) {
  const Study climbs_to_three = answering_of_h([](double h) {
    if (h < 0.2) throw std::invalid_argument("h is too small");
    return 2.0;
  });
  const CaseResult first = run(ladder, climbs_to_three);
  EXPECT_EQ(first.status, Status::checked_nothing);  // no rung is stored yet
  EXPECT_EQ(first.first_failing_rung, 3);
  const auto with_pin = [&](double rung) {
    return run(ladder, climbs_to_three, {.pins = {{"first_failing_rung", {rung}}}});
  };
  EXPECT_EQ(with_pin(3).status, Status::pass);
  EXPECT_EQ(with_pin(2).status, Status::pass);         // climbs higher than before
  EXPECT_EQ(with_pin(4).status, Status::changed_pin);  // fell back
}

TEST(Ladder, IsBrokenBySilentErrorsAndUnnamedRefusals) {
  const RunnerOptions options{.pins = {{"first_failing_rung", {0}}}};
  const CaseResult silently_wrong =
      run(ladder, answering_of_h([](double h) { return h < 0.2 ? 2.0 + 1.0 / h : 2.0; }), options);
  EXPECT_EQ(silently_wrong.status, Status::wrong_value);
  EXPECT_EQ(silently_wrong.first_failing_rung, 3);
  const CaseResult unnamed = run(ladder, answering_of_h([](double h) {
                                   if (h < 0.2) throw std::invalid_argument("failed");
                                   return 2.0;
                                 }),
                                 options);
  EXPECT_EQ(unnamed.status, Status::refused);
}

TEST(Runner, NoticesBitsThatDependOnThreads) {
  const Study steady = answering(2.0);
  const Study shaky = [](const StudyInput& input) {
    StudyOutput output;
    output.summary.quantities["answer"] = std::nextafter(2.0, 2.0 + (input.threads - 1));
    return output;
  };
  EXPECT_EQ(run(whole, steady, {.other_threads = 2}).status, Status::pass);
  EXPECT_EQ(run(whole, shaky).status, Status::pass);
  const CaseResult found = run(whole, shaky, {.other_threads = 2});
  EXPECT_EQ(found.status, Status::broken_invariant);
  EXPECT_NE(found.settings[0].message.find("2 threads give other bits than 1"), std::string::npos);
}

}  // namespace
}  // namespace sunder::verification
