#include "verification/harness/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "verification/harness/catalogue.hpp"
#include "verification/harness/junit.hpp"
#include "verification/harness/tests/json_schema.hpp"
#include "verification/harness/tests/temporary_case.hpp"

namespace sunder::verification {
namespace {

CaseResult full_result() {
  CaseResult result;
  result.id = "demo/number";
  result.family = "demo";
  result.tier = "quick";
  result.title = "A \"number\" & more";
  result.requirement = "It shall be <two>.";
  result.version = 3;
  result.status = Status::wrong_value;
  result.references = {{.name = "two",
                        .kind = ReferenceClass::published,
                        .expression = "",
                        .values = {2.0},
                        .abscissae = {},
                        .unit = "-",
                        .source = "s",
                        .locator = "l",
                        .uncertainty = 0.01,
                        .uncertainty_is_relative = true}};
  CheckOutcome check{.name = "answer",
                     .kind = "order",
                     .status = Status::wrong_order,
                     .evidence = "published",
                     .basis = "discretisation"};
  check.value = std::nextafter(0.1, 1.0);
  check.error = std::numeric_limits<double>::quiet_NaN();
  check.compared = 5;
  check.orders = {{Convergence::oscillatory, 1.5, {1.0, 2.0}, 3.0, 0.01, 4}};
  result.checks = {check};
  SettingRow row;
  row.keys = {{"mesh.order", "4"}};
  row.standard = true;
  row.status = Status::refused;
  row.message = "not star-shaped";
  row.errors = {{"answer", 1e-300}};
  row.cpu_seconds = 0.25;
  row.repeats = 7;
  row.dofs = 194;
  row.peak_bytes = 1L << 40;
  row.parts = {{"mesh", 1, 2, 0.5}};
  row.counts = {{"factorisations", 3}};
  result.settings = {row};
  result.first_failing_rung = 2;
  result.pins = {{"pin", {1.0 / 3.0}}};
  result.negatives = {{"fake/twice", {"answer"}, {"answer"}, true, NegativeOutcome::Verdict::killed}};
  return result;
}

TEST(Record, ComesBackAsItWent) {
  const CaseResult before = full_result();
  const std::string line = to_json(before, environment(2, "abc"));
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const CaseResult after = from_json(line);
  EXPECT_EQ(to_json(after, environment(2, "abc")), line);
  EXPECT_EQ(after.checks[0].value, before.checks[0].value);  // to the last bit
  EXPECT_TRUE(std::isnan(after.checks[0].error));
  EXPECT_EQ(after.settings[0].peak_bytes, before.settings[0].peak_bytes);
  EXPECT_EQ(after.settings[0].errors[0].second, 1e-300);
  EXPECT_EQ(after.pins[0].second[0], 1.0 / 3.0);
  EXPECT_EQ(after.negatives[0].verdict, NegativeOutcome::Verdict::killed);
  EXPECT_EQ(after.checks[0].orders[0].convergence, Convergence::oscillatory);
}

TEST(Record, FollowsItsSchema) {
  std::ifstream stream("verification/harness/record.schema.json");  // tests run in the project's folder
  const JsonSchema schema(nlohmann::json::parse(stream));
  nlohmann::json line = nlohmann::json::parse(to_json(full_result(), environment(2, "abc")));
  EXPECT_EQ(schema.complaint(line), "");
  for (int i = 0; i <= static_cast<int>(Status::crash); ++i) {
    line["status"] = word(static_cast<Status>(i));
    EXPECT_EQ(schema.complaint(line), "");
  }
  line["status"] = "fine";
  EXPECT_NE(schema.complaint(line).find("record.status: \"fine\" is none of"), std::string::npos);
  line["status"] = "pass";
  line["checks"][0].erase("evidence");
  EXPECT_EQ(schema.complaint(line), "record.checks[0]: evidence is missing");
  line["checks"][0]["evidence"] = "exact";
  line["settings"][0]["seconds"] = 1.0;
  EXPECT_EQ(schema.complaint(line), "record.settings[0]: seconds is not known");
}

TEST(Record, RejectsOtherLines) {
  EXPECT_THROW(static_cast<void>(from_json("{\"id\": 3}")), std::runtime_error);
  EXPECT_THROW(static_cast<void>(from_json("nonsense")), std::runtime_error);
  const std::string sound = to_json(full_result(), environment(2, "abc")), version = "\"version\":";
  for (const char* other : {"1.5", "1e300", "99999999999"}) {
    std::string line = sound;
    const std::size_t at = line.find(version) + version.size();
    line.replace(at, line.find(',', at) - at, other);
    EXPECT_THROW(static_cast<void>(from_json(line)), std::runtime_error) << other;
  }
}

TEST(Record, IsAppendedLineByLine) {
  const TemporaryCases folder;
  const auto file = folder.folders().cases / "records" / "all.jsonl";
  append(file, "{\"a\":1}");
  append(file, "{\"a\":2}");
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(), "{\"a\":1}\n{\"a\":2}\n");
}

TEST(Record, KeepsEveryStatusWord) {
  for (int i = 0; i <= static_cast<int>(Status::crash); ++i) {
    const auto status = static_cast<Status>(i);
    EXPECT_EQ(status_of(word(status)), status) << word(status);
  }
  EXPECT_EQ(status_of("fine"), std::nullopt);
}

TEST(Pins, StandBesideTheCase) {
  const TemporaryCases cases;
  const Case read = cases.read(plain_head + exact_two + check_two);
  EXPECT_TRUE(read_pins(read).empty());
  CaseResult result;
  result.pins = {{"pin", {0.1, -3.0}}, {"first_failing_rung", {4.0}}};
  write_pins(read, result);
  EXPECT_TRUE(std::filesystem::exists(cases.folders().cases / "demo" / "number.pins.json"));
  EXPECT_EQ(read_pins(read).at("pin"), (std::vector<double>{0.1, -3.0}));
  cases.write("cases/demo/number.pins.json", "{ broken");
  EXPECT_THROW(static_cast<void>(read_pins(read)), CaseError);
}

TEST(Junit, IsWellFormedAndCounts) {
  CaseResult passing;
  passing.id = "demo/right";
  passing.family = "demo";
  passing.status = Status::pass;
  CaseResult skipped = passing;
  skipped.id = "other/none";
  skipped.family = "other";
  skipped.status = Status::skipped;
  const std::string xml = junit_xml({full_result(), passing, skipped});
  EXPECT_NE(xml.find("<testsuite name=\"demo\" tests=\"2\" failures=\"1\" skipped=\"0\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"wrong value\">"), std::string::npos);
  EXPECT_NE(xml.find("<testsuite name=\"other\" tests=\"1\" failures=\"0\" skipped=\"1\""), std::string::npos);
}

TEST(Catalogue, CountsTheEvidence) {
  const TemporaryCases cases;
  const std::string published =
      "[[reference]]\nname = \"book\"\nclass = \"published\"\nvalue = 2\nunit = \"-\"\nsource = \"b\"\n"
      "locator = \"p. 1\"\nuncertainty = 0.1\n";
  const std::string more =
      "[[check]]\nname = \"printed\"\nquantity = \"answer\"\nreference = \"book\"\ntolerance = 0.1\n"
      "basis = \"uncertainty\"\nreason = \"as printed\"\n"
      "[[check]]\nname = \"kept\"\nkind = \"invariant\"\nquantity = \"answer\"\nlaw = \"sum\"\ntolerance = 1\n"
      "basis = \"physics\"\nreason = \"r\"\n"
      "[[check]]\nname = \"beside\"\ngates = false\nquantity = \"answer\"\nreference = \"two\"\ntolerance = 1\n"
      "basis = \"physics\"\nreason = \"r\"\n";
  const Case read = cases.read(plain_head + exact_two + published + check_two + more);
  const Evidence evidence = evidence_of({read});
  EXPECT_EQ(evidence.gating, 3);
  EXPECT_EQ(evidence.with_reference, 2);
  EXPECT_EQ(evidence.independent, 1);
  EXPECT_EQ(evidence.by_law, 1);
  EXPECT_EQ(evidence.share(), 0.5);
  EXPECT_NE(catalogue_page({read}, {}).find("2 have a reference, 1 of them (50 %)"), std::string::npos);
}

TEST(Catalogue, TellsClaimsFromFigures) {
  const TemporaryCases cases;
  const Case read = cases.read(plain_head + exact_two + check_two);
  CaseResult result = full_result();
  const std::string without = catalogue_page({read}, {}), with = catalogue_page({read}, {result});
  EXPECT_NE(with.find("The study shall give two."), std::string::npos) << with;
  EXPECT_NE(with.find("exact: arithmetic, 1 + 1"), std::string::npos);
  EXPECT_NE(without, with);
  EXPECT_EQ(claims_of(without), claims_of(with));
  const Case changed = cases.read(plain_head + exact_two + check_two + "gates = true\nscale = 3\n");
  EXPECT_EQ(claims_of(catalogue_page({changed}, {})), claims_of(without));  // the scale is no part of the claim's row
  Case tighter = read;
  tighter.checks[0].tolerance = {1e-4};
  EXPECT_NE(claims_of(catalogue_page({tighter}, {})), claims_of(without));
}

}  // namespace
}  // namespace sunder::verification
