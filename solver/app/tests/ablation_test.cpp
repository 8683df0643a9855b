// What is cut from a scene, what is told of a run, and the command as a whole.
#include "solver/app/ablation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "solver/app/program.hpp"
#include "solver/app/tests/folder.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::app {
namespace {

scene::Scene dam() {
  scene::Scene scene;
  scene.analysis = scene::Analysis::dynamic;
  scene.cracks.emplace_back();
  scene.contact.emplace();
  scene.crack_water.emplace();
  scene.reservoir.emplace();
  scene.propagation.emplace();
  scene.foundation = scene::Foundation{.boundary = "base",
                                       .youngs_modulus = 1e10,
                                       .poisson_ratio = 0.2,
                                       .density = 2600.0,
                                       .half_width = {},
                                       .near_field = {}};
  scene.ground_motion.emplace();
  scene.output.emplace().fields_every = 3;
  return scene;
}

const Cut& cut_of(const std::vector<Cut>& cuts, const std::string& part) {
  for (const Cut& cut : cuts)
    if (cut.part == part) return cut;
  throw std::runtime_error("no cut of " + part);
}

TEST(Ablation, CutsEachPartWithWhatHangsOnIt) {
  const std::vector<Cut> cuts = cuts_of(dam());
  for (const Cut& cut : cuts) EXPECT_EQ(cut.scene.output->fields_every, 0) << cut.part;
  EXPECT_FALSE(cut_of(cuts, "contact").scene.contact);
  EXPECT_TRUE(cut_of(cuts, "contact").scene.crack_water);
  const scene::Scene whole_body = cut_of(cuts, "cracks").scene;
  EXPECT_FALSE(whole_body.contact || whole_body.crack_water || whole_body.propagation);
  EXPECT_TRUE(whole_body.reservoir);
  EXPECT_FALSE(cut_of(cuts, "reservoir").scene.crack_water) << "its water comes from the reservoir";
  EXPECT_EQ(cut_of(cuts, "reservoir: its inertia").scene.reservoir->model, scene::ReservoirModel::hydrostatic);
  EXPECT_EQ(cut_of(cuts, "crack water: its motion").scene.crack_water->model, scene::CrackWaterModel::uniform);
  const scene::Scene rigid = cut_of(cuts, "foundation").scene;
  ASSERT_EQ(rigid.supports.size(), 1u);
  EXPECT_EQ(rigid.supports[0].boundary, "base");
  EXPECT_TRUE(rigid.supports[0].fix[0] && rigid.supports[0].fix[1]);
}

TEST(Ablation, CutsNothingThatIsNotThere) {
  scene::Scene scene;
  EXPECT_TRUE(cuts_of(scene).empty());
  scene.gravity.emplace();
  ASSERT_EQ(cuts_of(scene).size(), 1u);
  EXPECT_EQ(cuts_of(scene)[0].part, "gravity");
  scene.analysis = scene::Analysis::response;
  EXPECT_TRUE(cuts_of(scene).empty());
}

TEST(Ablation, FindsTheNumbersOfStaticDynamicAndGrowingRuns) {
  using results::Quantity;
  results::RunSummary still;
  still.quantities["max_displacement"] = 0.5;
  still.quantities["tips"] = Quantity::List{Quantity::Table{{"K_I", 1e6}}, Quantity::Table{{"K_I", 3e6}}};
  still.quantities["growth"] = Quantity::List{Quantity::Table{{"length", Quantity(std::vector<double>{1.0, 2.0})}}};
  EXPECT_EQ(findings_of(still).displacement, 0.5);
  EXPECT_EQ(findings_of(still).K_I, 3e6);
  EXPECT_EQ(findings_of(still).crack_length, 2.0);
  EXPECT_FALSE(findings_of(still).uplift);
  results::RunSummary moving;
  moving.quantities["peak_crest_displacement"] = 0.06;
  moving.history = results::History({{"time", "s"}, {"uplift_force", "N/m"}});
  moving.history->add_row(std::array{0.0, 2e6});
  moving.history->add_row(std::array{1.0, 1e6});
  EXPECT_EQ(findings_of(moving).uplift, 2e6);
  EXPECT_EQ(findings_of(moving).displacement, 0.06);
}

TEST(Ablation, TellsSharesAndChanges) {
  std::vector<AblationRun> runs(3);
  runs[0].seconds = 4.0;
  runs[0].findings.displacement = 0.1;
  runs[0].findings.K_I = 2e6;
  runs[1].part = "contact";
  runs[1].seconds = 3.0;
  runs[1].findings.displacement = 0.11;
  runs[1].findings.K_I = 1e6;
  runs[2].part = "gravity";
  runs[2].seconds = 1.0;
  runs[2].trouble = "stopped: no rest";
  const std::string text = ablation_table("dam", runs);
  EXPECT_NE(text.find("25 %"), std::string::npos) << text;
  EXPECT_NE(text.find("0.11 (+10.0 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("1 (-50.0 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("without gravity: stopped: no rest"), std::string::npos) << text;
  EXPECT_EQ(text.find("uplift"), std::string::npos) << "no run has it";
}

constexpr const char* plate =
    "name = \"plate\"\nanalysis = \"static\"\n"
    "[geometry]\noutline = [[0, 0], [1, 0], [1, 1], [0, 1]]\nboundaries = { bottom = [0], top = [2] }\n"
    "[mesh]\nsize = 0.5\n[material]\nyoungs_modulus = 1\npoisson_ratio = 0\ndensity = 1\n"
    "[[support]]\nboundary = \"bottom\"\nfix = [\"x\", \"y\"]\n";

struct Outcome {
  int status;
  std::string out, err;
};

/// `sunder ablate` with a solver that refuses a scene without loads and counts its runs.
Outcome ablate(const std::string& scene_text, int& runs) {
  const TestFolder folder;
  const std::string file = folder.write("plate.toml", scene_text);
  std::ostringstream out, err;
  const Solver solver{[&](const scene::Scene& scene, const simulation::RunOptions&) {
                        ++runs;
                        if (scene.loads.empty()) throw scene::SceneError("nothing pulls");
                        results::RunSummary summary;
                        summary.quantities["max_displacement"] = scene.gravity ? 2.0 : 1.0;
                        return summary;
                      },
                      {}};
  const int status = program(std::vector<std::string>{"ablate", file}, {out, err, false}, solver);
  return {status, out.str(), err.str()};
}

TEST(Ablation, RunsTheWholeAndEachCutAndSaysWhatWasRefused) {
  int runs = 0;
  const Outcome outcome = ablate(std::string(plate) + "[gravity]\n[[load]]\nboundary = \"top\"\npressure = 1\n", runs);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(runs, 3);
  EXPECT_NE(outcome.out.find("1 (-50.0 %)"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("without loads: refused: nothing pulls"), std::string::npos) << outcome.out;
}

TEST(Ablation, RefusesASceneWithoutParts) {
  int runs = 0;
  const Outcome outcome = ablate(plate, runs);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(runs, 0);
  EXPECT_NE(outcome.err.find("no part that it could do without"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace sunder::app
