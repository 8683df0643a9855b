#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "solver/scene/scene_error.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::number;
using tests::run_text;

const char* const closing_crack = R"(name = "45 m crack"
analysis = "crack-water"
[crack_water]
[crack_line]
length = 45.0
segments = 45
aperture = [0.10, 0.05]
opening_rate = [-0.10, 0.0]
upstream_head = 50.0
downstream_head = 0.0
)";

std::string refusal(std::vector<scene::Override> overrides) {
  try {
    static_cast<void>(run_text(closing_crack, std::move(overrides)));
  } catch (const scene::SceneError& error) {
    return error.what();
  }
  return "";
}

// Reference: 40-digit computation, reference-data/independent-crack-water-2026.
TEST(CrackWaterRun, GivesTheQuantitiesOfTheClosingCrackWithoutABody) {
  const results::RunSummary summary = run_text(closing_crack);
  ASSERT_TRUE(summary.completed()) << summary.status;
  EXPECT_NEAR(number(summary, "uplift_force"), 146995198.365368616, 1e-12 * 146995198.0);
  EXPECT_NEAR(number(summary, "upstream_flux"), -1.65874217599189056, 1e-12);
  EXPECT_NEAR(number(summary, "downstream_flux"), 0.591257824008109439, 1e-12);
  EXPECT_NEAR(number(summary, "peak_position"), 21.9320126233930305, 1e-11);
  EXPECT_NEAR(number(summary, "pressure[20]"), 4302500.4137781886, 1e-12 * 4305211.0);
  EXPECT_EQ(*summary.quantities.find("status")->text(), "converged");
  EXPECT_GT(number(summary, "gradient_evaluations"), 0.0);
  ASSERT_EQ(summary.parts.size(), 1u);
  EXPECT_EQ(summary.parts[0].part, "crackwater");
  EXPECT_EQ(summary.mesh.polygons, 0);
}

TEST(CrackWaterRun, ReadsApertureAndRateAtEveryNode) {
  const results::RunSummary summary = run_text(closing_crack, {{"crack_line.segments", "3"},
                                                               {"crack_line.aperture", "[0.04, 0.05, 0.05, 0.04]"},
                                                               {"crack_line.opening_rate", "[0, -0.1, -0.1, 0]"},
                                                               {"crack_line.upstream_head", "0"}});
  ASSERT_TRUE(summary.completed());
  // symmetric: 3 segments of 15 m displace 15 (0.05 + 0.1 + 0.05) = 3 m²/s, one half through each mouth
  EXPECT_NEAR(number(summary, "upstream_flux"), -1.5, 1e-12);
  EXPECT_NEAR(number(summary, "downstream_flux"), 1.5, 1e-12);
}

TEST(CrackWaterRun, MarchesWithTheWaterBalanced) {
  const results::RunSummary summary =
      run_text(closing_crack, {{"crack_line.opening_rate", "0.01"},
                               {"crack_line.march", "{ time_step = 0.3, duration = 1.0, initially = \"empty\" }"}});
  ASSERT_TRUE(summary.completed()) << summary.status;
  EXPECT_LE(number(summary, "water_volume_error"), 1e-13);
  const double front = number(summary, "front_position");
  EXPECT_GT(front, 0.0);
  EXPECT_LT(front, 45.0);
  long long steps = 0;
  for (const auto& [name, count] : summary.counts) steps += name == "steps" ? count : 0;
  EXPECT_EQ(steps, 4);  // three of 0.3 s and one of 0.1 s
  ASSERT_TRUE(summary.history);
  const results::History& history = *summary.history;
  ASSERT_EQ(history.rows(), 4u);
  EXPECT_EQ(history.columns()[1].name, "front_position");
  EXPECT_EQ(history.at(3, 0), 1.0);
  EXPECT_EQ(history.at(3, 1), front);
  for (std::size_t row = 0; row < 4; ++row) {  // content = inflow - outflow from the empty crack on
    EXPECT_NEAR(history.at(row, 2), history.at(row, 3) - history.at(row, 4), 1e-13);
  }
  EXPECT_FALSE(run_text(closing_crack).history) << "an instant has none";
}

TEST(CrackWaterRun, WritesEveryFewStepsAndTheLast) {
  const results::RunSummary summary =
      run_text(closing_crack, {{"crack_line.opening_rate", "0"},
                               {"crack_line.march", "{ time_step = 0.1, duration = 1.0, history_every = 4 }"}});
  ASSERT_TRUE(summary.history);
  ASSERT_EQ(summary.history->rows(), 3u);  // steps 4, 8 and 10
  EXPECT_NEAR(summary.history->at(1, 0), 0.8, 1e-15);
  EXPECT_EQ(summary.history->at(2, 0), 1.0);
}

TEST(CrackWaterRun, TakesTheLargerOrTheSumOfOpeningAndRoughness) {
  const auto flux = [](const char* rule, const char* opening) {
    return number(
        run_text(closing_crack,
                 {{"crack_line.opening_rate", "0"}, {"crack_line.aperture", opening}, {"crack_water.aperture", rule}}),
        "upstream_flux");
  };
  EXPECT_EQ(flux("\"sum\"", "[0.07, 0.02]"), flux("\"larger\"", "[0.10, 0.05]"));
  EXPECT_EQ(flux("\"larger\"", "[0.02, 0.02]"), flux("\"larger\"", "[0.03, 0.03]"));
}

TEST(CrackWaterRun, CarriesTheWeightOfWaterInAnInclinedCrack) {
  const results::RunSummary summary =
      run_text(closing_crack, {{"crack_line.opening_rate", "0"}, {"crack_line.rise", "9"}});
  // At rest the drop per unit of s goes with w⁻³ less a constant: the uplift is that of the level crack with the head
  // less the rise, and the weight's triangle.
  EXPECT_NEAR(number(summary, "uplift_force"), 14052825.0, 1e-12 * 14052825.0);
  EXPECT_NE(refusal({{"crack_line.rise", "-45.1"}}).find("crack_line.rise"), std::string::npos);
}

TEST(CrackWaterRun, RefusesBadInputWithTheKeyTheValueAndTheBound) {
  struct Bad {
    const char *key, *value, *shown, *bound;
  };
  const Bad cases[] = {
      {"crack_line.aperture", "[nan, 0.05]", "nan", "finite"},
      {"crack_line.aperture", "[0.1, inf]", "inf", "finite"},
      {"crack_line.aperture", "[0.1, 0.0]", "0", "> 0"},
      {"crack_line.aperture", "[0.1, -0.05]", "-0.05", "> 0"},
      {"crack_line.aperture", "[0.1, 0.1, 0.05]", "3 values", "46 (segments + 1)"},
      {"crack_line.opening_rate", "[-inf, 0.0]", "inf", "finite"},
      {"crack_line.opening_rate", "[0.1, 0.1, 0.05]", "3 values", "46 (segments + 1)"},
      {"crack_line.segments", "0", "0", ">= 1"},
      {"crack_line.length", "0.0", "0", "> 0"},
      {"crack_line.upstream_head", "-1.0", "-1", ">= 0"},
      {"crack_line.upstream_head", "nan", "nan", "finite"},
      {"crack_line.downstream_head", "-1.0", "-1", ">= 0"},
      {"crack_line.rise", "46.0", "rise", "-length … length"},
      {"crack_line.tip", "\"closed\"", "tip = \"closed\"", "one of them"},
      {"crack_line.tolerance", "1.0", "1", "< 1"},
      {"crack_line.search", "\"regula-falsi\"", "regula-falsi", "bisection"},
      {"crack_line.quadrature", "\"gauss\"", "gauss", "midpoint"},
      {"crack_line.march", "{ time_step = 0.0, duration = 1.0 }", "0", "> 0"},
      {"crack_line.march", "{ time_step = 0.1, duration = -1.0 }", "-1", "> 0"},
      {"crack_line.march", "{ time_step = 0.1, duration = 1.0, history_every = 0 }", "0", ">= 1"},
      {"crack_line.march", "{ time_step = 1e-8, duration = 1.0 }", "march.history_every", "1e7 rows"},
      {"crack_water.minimum_aperture", "0.0", "0", "> 0"},
      {"crack_water.minimum_aperture", "-0.03", "-0.03", "> 0"},
      {"crack_water.aperture", "\"product\"", "product", "larger"},
      {"crack_water.relative_roughness", "0.0", "0", "> 0"},
      {"crack_water.relative_roughness", "0.51", "0.51", "<= 0.5"},
      {"crack_water.relative_roughness", "0.006", "0.006", ">= 0.00687879"},
      {"crack_water.density", "-1000.0", "-1000", "> 0"},
      {"crack_water.dynamic_viscosity", "-1e-3", "-0.001", "> 0"},
      {"crack_water.dynamic_viscosity", "nan", "nan", "finite"},
  };
  for (const Bad& bad : cases) {
    const std::string said = refusal({{bad.key, bad.value}});
    SCOPED_TRACE(std::string(bad.key) + " = " + bad.value + ": " + said);
    EXPECT_NE(said.find("crack_"), std::string::npos);
    EXPECT_NE(said.find(bad.shown), std::string::npos);
    EXPECT_NE(said.find(bad.bound), std::string::npos);
  }
}

TEST(CrackWaterRun, NamesTheTableAndTheKeyThatItCannotUse) {
  const std::string said = refusal({{"crack_water.relative_roughness", "1e-3"}});
  EXPECT_EQ(said.find("test.scene.toml:3: [crack_water] relative_roughness = 0.001"), 0u) << said;
  EXPECT_NE(said.find(">= 0.00687879"), std::string::npos) << said;
  const scene::Override march{"crack_line.march", "{ time_step = 0.1, duration = 1 }"};
  EXPECT_NE(refusal({march, {"crack_line.quadrature", "\"midpoint\""}}).find("[crack_line] quadrature"),
            std::string::npos);
  EXPECT_NE(refusal({march, {"crack_line.tolerance", "1e-3"}}).find("[crack_line] tolerance"), std::string::npos);
  EXPECT_NE(refusal({march, {"crack_water.model", "\"uniform\""}}).find("[crack_water] model"), std::string::npos);
  EXPECT_NE(refusal({{"crack_line.march", "{ time_step = 1e-300, duration = 1 }"}}).find("[crack_line] march.duration"),
            std::string::npos);
}

}  // namespace
}  // namespace sunder::simulation
