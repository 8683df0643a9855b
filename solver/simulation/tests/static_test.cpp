#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "solver/scene/scene_error.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::number;
using tests::run_text;

/// Edge crack a/W = 0.5, H/W = 1 (half height), tension 1: K_I = 2.8254653223 √(π/2), T = -0.41019754 from one polygon
/// of order 8 … 12, self-converged to 1e-10 and 1e-8.
const char* const edge_crack = R"(
name = "edge crack"
analysis = "static"
[geometry]
outline = [[0, -1], [1, -1], [1, 1], [0, 1]]
boundaries = { bottom = [0], right = [1], top = [2], left = [3] }
[mesh]
cells = "one"
order = 6
edge_size = 0.5
[material]
youngs_modulus = 1.0
poisson_ratio = 0.3
[[crack]]
path = [[0, 0], [0.5, 0]]
[[load]]
boundary = "top"
traction = [0, 1]
[[load]]
boundary = "bottom"
traction = [0, -1]
[[support]]
point = [1, -1]
fix = ["x", "y"]
[[support]]
point = [1, 1]
fix = ["x"]
)";
const double K_reference = 2.8254653223 * std::sqrt(std::numbers::pi / 2.0);
constexpr double T_reference = -0.41019754;

TEST(StaticRun, EdgeCrackInOnePolygon) {
  const results::RunSummary summary = run_text(edge_crack);
  ASSERT_TRUE(summary.completed()) << summary.status;
  EXPECT_EQ(summary.mesh.polygons, 1);
  // Order 6 on twelve edges errs by 3e-8 in K_I and 2e-6 in T (energy projection): three times that.
  EXPECT_NEAR(number(summary, "tips[0].K_I") / K_reference, 1.0, 1e-7);
  EXPECT_NEAR(number(summary, "tips[0].T_stress") / T_reference, 1.0, 6e-6);
  EXPECT_NEAR(number(summary, "tips[0].K_II"), 0.0, 1e-10 * K_reference);
}

TEST(StaticRun, EdgeCrackInAGridAndInDualPolygons) {
  const results::RunSummary grid =
      run_text(edge_crack, {{"mesh.cells", "\"squares\""}, {"mesh.size", "0.125"}, {"mesh.order", "2"}});
  // Quadratic polygons with h = a/4 and 16 edges of order 3 at the tip: 2.3e-4 with order 2 everywhere.
  EXPECT_NEAR(number(grid, "tips[0].K_I") / K_reference, 1.0, 2.3e-4);
  const results::RunSummary dual =
      run_text(edge_crack, {{"mesh.cells", "\"dual\""}, {"mesh.size", "0.06"}, {"mesh.order", "2"}});
  EXPECT_NEAR(number(dual, "tips[0].K_I") / K_reference, 1.0, 5e-4);  // the bar for p = 2 meshes
}

TEST(StaticRun, FacePressureActsLikeRemoteTension) {
  // Superposition: the two differ by a uniform σ_yy, which has neither K nor T. The extraction's own error, 5e-10 at
  // these orders, is all that may differ; T carries two digits less.
  std::string text = edge_crack;
  text.replace(text.find("path = [[0, 0], [0.5, 0]]"), 25, "path = [[0, 0], [0.5, 0]]\npressure = 1.0");
  for (const char* boundary : {"top", "bottom"}) {
    const std::size_t load = text.find("[[load]]\nboundary = \"" + std::string(boundary));
    text.erase(load, text.find("[[", load + 2) - load);
  }
  for (const auto& [cells, order] : {std::pair{"\"one\"", "8"}, {"\"squares\"", "6"}}) {
    const std::vector<scene::Override> mesh = {{"mesh.cells", cells}, {"mesh.size", "0.125"}, {"mesh.order", order}};
    const results::RunSummary pressed = run_text(text, mesh), pulled = run_text(edge_crack, mesh);
    ASSERT_TRUE(pressed.completed());
    EXPECT_NEAR(number(pressed, "tips[0].K_I") / number(pulled, "tips[0].K_I"), 1.0, 1e-9) << cells;
    EXPECT_NEAR(number(pressed, "tips[0].T_stress"), number(pulled, "tips[0].T_stress"), 1e-7) << cells;
  }
}

TEST(StaticRun, SameBitsForOneAndTwoThreads) {
  const std::vector<scene::Override> mesh = {{"mesh.cells", "\"dual\""}, {"mesh.size", "0.2"}};
  const results::RunSummary one = run_text(edge_crack, mesh, 1), two = run_text(edge_crack, mesh, 2);
  for (const char* path : {"tips[0].K_I", "tips[0].T_stress", "strain_energy", "max_displacement", "residual"}) {
    EXPECT_EQ(number(one, path), number(two, path)) << path;
  }
}

/// A bar under its own weight with ν = 0, hung at the top: u_y = -ρg (L² - y²) / (2E), energy ρ²g²L³ / (6E) an area.
const char* const hanging_bar = R"(
name = "hanging bar"
analysis = "static"
[geometry]
outline = [[0, 0], [1, 0], [1, 3], [0, 3]]
boundaries = { top = [2] }
[mesh]
size = 0.5
order = 2
[material]
youngs_modulus = 2.0
poisson_ratio = 0.0
density = 0.5
[gravity]
acceleration = 10
[[support]]
boundary = "top"
fix = ["x", "y"]
)";

TEST(StaticRun, OwnWeightIsExactFromOrderTwo) {
  const results::RunSummary summary = run_text(hanging_bar);
  ASSERT_TRUE(summary.completed()) << summary.status;
  const double weight = 5.0, length = 3.0, modulus = 2.0;
  // Round-off of a few hundred unknowns with condition about 1e4.
  EXPECT_NEAR(number(summary, "max_displacement") / (weight * length * length / (2 * modulus)), 1.0, 1e-11);
  EXPECT_NEAR(number(summary, "strain_energy") / (weight * weight * length * length * length / (6 * modulus)), 1.0,
              1e-11);
  EXPECT_NEAR(number(summary, "reactions[0].force[1]") / (weight * length), 1.0, 1e-11);
  EXPECT_NEAR(number(summary, "reactions[0].force[0]"), 0.0, 1e-11 * weight * length);
}

TEST(StaticRun, PrescribedStretchGivesTheUniformState) {
  std::string text = hanging_bar;
  text.erase(text.find("[gravity]"), text.find("[[support]]") - text.find("[gravity]"));
  text.replace(text.find("boundaries = { top = [2] }"), 26, "boundaries = { top = [2], bottom = [0] }");
  text += "[[support]]\nboundary = \"bottom\"\nfix = [\"y\"]\ndisplacement = [0, -0.3]\n";
  const results::RunSummary summary = run_text(text);
  // ν = 0, strain 0.1, stress E · 0.1 over a width of 1; round-off as above.
  EXPECT_NEAR(number(summary, "reactions[0].force[1]"), 0.2, 1e-11);
  EXPECT_NEAR(number(summary, "strain_energy"), 0.5 * 2.0 * 0.1 * 0.1 * 3.0, 1e-11);
}

TEST(StaticRun, StandingWaterPushesWithItsWholeWeight) {
  // ½ ρ g h² on the side, wherever the surface cuts an edge, at any order; ν = 0 lets the bar of the scene stand in.
  for (const char* order : {"1", "2", "5"}) {
    for (const double level : {0.5, 1.3, 3.0, 4.0}) {
      std::string text = hanging_bar;
      text.erase(text.find("[gravity]"), text.find("[[support]]") - text.find("[gravity]"));
      text.replace(text.find("boundaries = { top = [2] }"), 26, "boundaries = { top = [2], left = [3] }");
      text += "[[load]]\nboundary = \"left\"\nwater_level = " + std::to_string(level) + "\n";
      const results::RunSummary summary = run_text(text, {{"mesh.order", order}});
      const double wet = std::min(level, 3.0);
      const double push = 1000.0 * 9.81 * (level - 0.5 * wet) * wet;
      EXPECT_NEAR(number(summary, "reactions[0].force[0]") / -push, 1.0, 1e-11) << order << " " << level;  // round-off
    }
  }
}

TEST(StaticRun, APartThatCanMoveIsRefusedWithItsPlace) {
  // Two squares that share no edge, one of them held: only the mesh shows that the other one floats.
  const char* const two_bodies = R"(
name = "two bodies"
analysis = "static"
[mesh]
vertices = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [3, 0], [3, 1], [2, 1]]
polygons = [[0, 1, 2, 3], [4, 5, 6, 7]]
boundaries = { left = [[3, 0]], right = [[5, 6]] }
[material]
youngs_modulus = 1.0
poisson_ratio = 0.2
[[support]]
boundary = "left"
fix = ["x", "y"]
[[load]]
boundary = "right"
traction = [1, 0]
)";
  try {
    (void)run_text(two_bodies);
    FAIL() << "the second square is held by nothing";
  } catch (const scene::SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("can still move rigidly in 3 way"), std::string::npos) << error.what();
  }
}

TEST(StaticRun, OnlyThePartsOfTheSceneAreConstructed) {
  const results::RunSummary summary = run_text(hanging_bar);
  for (const results::PartCost& cost : summary.parts) {
    EXPECT_TRUE(cost.part == "mesh" || cost.part == "sbfem" || cost.part == "numerics") << cost.part;
    EXPECT_GT(cost.calls, 0) << cost.part;
  }
}

TEST(StaticRun, StopsWhereItIsAskedTo) {
  const std::atomic<bool> stop = true;
  const results::RunSummary summary =
      run(scene::read_scene_text(hanging_bar, "test.scene.toml"), {.threads = 1, .stop = &stop});
  EXPECT_EQ(summary.status.substr(0, 7), "stopped");
}

}  // namespace
}  // namespace sunder::simulation
