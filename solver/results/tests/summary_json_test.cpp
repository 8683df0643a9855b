#include "solver/results/summary_json.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

namespace sunder::results {
namespace {

RunSummary small_summary() {
  RunSummary summary;
  summary.name = "edge crack \"α\"";
  summary.analysis = "static";
  summary.parts = {{"mesh", 1, 0, 0.25}, {"sbfem", 7, 448, 0.5}};
  summary.mesh = {3, 8, 16};
  summary.counts = {{"factorisations", 1}};
  summary.seconds = {{"mesh", 0.25}, {"total", 1.0}};
  summary.threads = 2;
  summary.warnings = {"coarse"};
  return summary;
}

TEST(SummaryJson, HoldsEveryMemberUnderItsName) {
  RunSummary summary = small_summary();
  summary.quantities["strain_energy"] = 1.5;
  summary.quantities["tips"] = Quantity::List{Quantity::Table{{"K_I", 2.0}, {"method", "energy"}}};
  const auto json = nlohmann::json::parse(to_json(summary));
  EXPECT_EQ(json["name"], summary.name);
  EXPECT_EQ(json["analysis"], "static");
  EXPECT_EQ(json["status"], "completed");
  EXPECT_EQ(json["parts"][1]["part"], "sbfem");
  EXPECT_EQ(json["parts"][1]["matrix_entries"], 448);
  EXPECT_EQ(json["mesh"]["dofs"], 16);
  EXPECT_EQ(json["quantities"]["tips"][0]["method"], "energy");
  EXPECT_EQ(json["counts"]["factorisations"], 1);
  EXPECT_EQ(json["seconds"]["total"], 1.0);
  EXPECT_EQ(json["environment"]["threads"], 2);
  EXPECT_FALSE(json["environment"]["version"].get<std::string>().empty());
  EXPECT_FALSE(json["environment"]["compiler"].get<std::string>().empty());
  EXPECT_EQ(json["environment"]["flags"].get<std::string>().find('/'), std::string::npos) << "no paths";
  EXPECT_EQ(json["warnings"], nlohmann::json::array({"coarse"}));
}

TEST(SummaryJson, KeepsTheOrderOfTheQuantities) {
  RunSummary summary = small_summary();
  summary.quantities["zeta"] = 1.0;
  summary.quantities["alpha"] = 2.0;
  const std::string text = to_json(summary);
  EXPECT_LT(text.find("zeta"), text.find("alpha"));
}

TEST(SummaryJson, GivesEveryDoubleBackBitForBit) {
  std::vector<double> values = {0.0,
                                -0.0,
                                0.1,
                                1.0 / 3.0,
                                std::numbers::pi,
                                1e23,
                                5e-324,
                                std::numeric_limits<double>::min(),
                                std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::epsilon(),
                                9007199254740993.0,
                                -1.7976931348623157e308};
  std::uint64_t state = 88172645463325252u;  // xorshift64: bit patterns from the whole range
  while (values.size() < 20000) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    const double value = std::bit_cast<double>(state);
    if (std::isfinite(value)) values.push_back(value);
  }
  RunSummary summary = small_summary();
  summary.quantities["values"] = Quantity(values);
  const auto json = nlohmann::json::parse(to_json(summary));
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(json["quantities"]["values"][i].get<double>()),
              std::bit_cast<std::uint64_t>(values[i]))
        << values[i];
}

TEST(SummaryJson, StopsARunWhoseNumbersAreNotFiniteAndNamesThem) {
  RunSummary summary = small_summary();
  summary.quantities["strain_energy"] = 1.0;
  summary.quantities["tips"] = Quantity::List{Quantity::Table{{"K_I", std::numeric_limits<double>::quiet_NaN()}},
                                              Quantity::Table{{"K_I", -std::numeric_limits<double>::infinity()}}};
  const std::string text = to_json(summary);
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["status"], "stopped: tips[0].K_I is not a finite number");
  EXPECT_EQ(json["warnings"], nlohmann::json::array({"coarse", "tips[0].K_I is not a finite number",
                                                     "tips[1].K_I is not a finite number"}));
  EXPECT_TRUE(json["quantities"]["tips"][0]["K_I"].is_null());
  EXPECT_TRUE(json["quantities"]["tips"][1]["K_I"].is_null());
  EXPECT_EQ(json["quantities"]["strain_energy"], 1.0) << "what was reached stays";

  stop_if_not_finite(summary);
  stop_if_not_finite(summary);
  EXPECT_FALSE(summary.completed());
  EXPECT_EQ(summary.warnings.size(), 3u) << "each named once";
}

TEST(SummaryJson, KeepsTheReasonOfARunThatStoppedBefore) {
  RunSummary summary = small_summary();
  summary.status = "stopped: step 7";
  summary.quantities["energy"] = std::numeric_limits<double>::infinity();
  stop_if_not_finite(summary);
  EXPECT_EQ(summary.status, "stopped: step 7");
  EXPECT_EQ(summary.warnings.back(), "energy is not a finite number");
}

TEST(SummaryJson, WritesANameThatIsNotUtf8) {
  RunSummary summary = small_summary();
  summary.name = "caf\xe9";
  EXPECT_NO_THROW({ EXPECT_TRUE(nlohmann::json::accept(to_json(summary))); });
}

}  // namespace
}  // namespace sunder::results
