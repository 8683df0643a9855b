#include "verification/harness/doctor.hpp"

#include <gtest/gtest.h>

#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

CaseResult result_with(const std::string& check, Status status, double value) {
  CaseResult result;
  result.status = status;
  CheckOutcome outcome;
  outcome.name = check;
  outcome.status = status;
  outcome.value = value;
  outcome.reference = 2.0;
  outcome.error = std::abs(value - 2.0);
  outcome.tolerance = 1e-3;
  outcome.compared = 1;
  result.checks.push_back(outcome);
  return result;
}

const std::vector<DoctorNumber> two_of_one_case{{"a number", "demo/a", "answer", 4}, {"another", "demo/a", "none", 4}};

TEST(Doctor, RunsACaseOnceAndSaysThatTheInstallationIsSound) {
  int runs = 0;
  const auto readings = read_numbers({two_of_one_case[0], two_of_one_case[0]}, [&](const std::string& id) {
    EXPECT_EQ(id, "demo/a");
    ++runs;
    return result_with("answer", Status::pass, 2.0001);
  });
  EXPECT_EQ(runs, 1);
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_TRUE(readings[0].right());
  const std::string text = doctor_text(readings, 1.25);
  EXPECT_NE(text.find("2, should be 2: error 0.0001, tolerance 0.001  (demo/a)"), std::string::npos) << text;
  EXPECT_NE(text.find("2 numbers in 1.2 s: this installation is sound."), std::string::npos) << text;
}

TEST(Doctor, NamesWhatIsWrongOrMissing) {
  const auto readings =
      read_numbers(two_of_one_case, [](const std::string&) { return result_with("answer", Status::wrong_value, 2.5); });
  EXPECT_FALSE(readings[0].right());
  EXPECT_EQ(readings[1].outcome.status, Status::wrong_value);  // the case fails, and has no such check
  const std::string text = doctor_text(readings, 1.0);
  EXPECT_NE(text.find("wrong value  a number"), std::string::npos) << text;
  EXPECT_NE(text.find("the case has no check of this name"), std::string::npos) << text;
  EXPECT_NE(text.find("2 are wrong: do not use this installation."), std::string::npos) << text;
}

TEST(Doctor, ACheckThatIsNotThereIsNotRight) {
  const auto readings =
      read_numbers({two_of_one_case[1]}, [](const std::string&) { return result_with("answer", Status::pass, 2.0); });
  EXPECT_FALSE(readings[0].right());
  EXPECT_EQ(readings[0].outcome.status, Status::checked_nothing);
}

TEST(Doctor, ReadsItsNumbersAndNamesTheLineOfAMistake) {
  const TemporaryCases folder;
  const std::string head = "[[number]]\nwords = \"w\"\ncase = \"a/b\"\ncheck = \"c\"\n";
  const auto numbers = read_doctor_numbers(folder.write("doctor.toml", head + "digits = 9\n"));
  ASSERT_EQ(numbers.size(), 1U);
  EXPECT_EQ(numbers[0].case_id, "a/b");
  EXPECT_EQ(numbers[0].digits, 9);
  for (const auto& [text, complaint] : std::vector<std::pair<std::string, std::string>>{
           {head + "digits = 18\n", "doctor.toml:1"}, {head + "unit = \"m\"\n", "doctor.toml:5"}, {"", "number"}}) {
    try {
      (void)read_doctor_numbers(folder.write("doctor.toml", text));
      ADD_FAILURE() << "accepted: " << text;
    } catch (const CaseError& error) {
      EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace sunder::verification
