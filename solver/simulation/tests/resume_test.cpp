/// A run that is interrupted and taken up again.

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cstdint>
#include <fstream>
#include <string>

#include "solver/scene/reader.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/run.hpp"

namespace sunder::simulation {
namespace {

const char* const wall = R"(
name = "wall in water"
analysis = "dynamic"
[geometry]
outline = [[0, 0], [3, 0], [2, 10], [0, 10]]
boundaries = { base = [0], crest = [2], upstream = [3] }
[mesh]
size = 1.5
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2450
[gravity]
[[support]]
boundary = "base"
fix = ["x", "y"]
[reservoir]
boundary = "upstream"
level = 9
model = "compressible"
[ground_motion]
horizontal = "shaking.csv"
vertical = "shaking.csv"
[dynamics]
time_step = 0.002
duration = 1.0
damping_modes = 1
[output]
checkpoint_every = 50
)";

class Resume : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("resume-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::ofstream record(folder_ / "shaking.csv");
    for (int i = 0; i <= 100; ++i) record << 0.01 * i << ',' << (i % 7 - 3) * 0.5 + (i == 0 ? 1.0 : 0.0) << '\n';
  }

  scene::Scene scene_with(const std::vector<scene::Override>& overrides = {}) const {
    return scene::read_scene_text(wall, folder_ / "wall.toml", overrides);
  }
  std::filesystem::path results() const { return folder_ / "results"; }

  /// Ends early at `fraction` of the steps.
  results::RunSummary interrupted(double fraction, bool resume = false,
                                  const std::vector<scene::Override>& overrides = {}) const {
    std::atomic<bool> stop{false};
    return run(scene_with(overrides), {.progress =
                                           [&](std::string_view phase, double done) {
                                             if (phase == "steps" && done > fraction) stop = true;
                                           },
                                       .stop = &stop,
                                       .output = results(),
                                       .resume = resume});
  }
  std::string refusal(const std::vector<scene::Override>& overrides) const {
    try {
      (void)run(scene_with(overrides), {.output = results(), .resume = true});
    } catch (const scene::SceneError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

void expect_same_bits(const results::RunSummary& a, const results::RunSummary& b) {
  ASSERT_TRUE(a.history && b.history);
  ASSERT_EQ(a.history->rows(), b.history->rows());
  for (std::size_t row = 0; row < a.history->rows(); ++row) {
    for (std::size_t column = 0; column < a.history->columns().size(); ++column) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.history->at(row, column)),
                std::bit_cast<std::uint64_t>(b.history->at(row, column)))
          << a.history->columns()[column].name << " in row " << row;
    }
  }
  for (const auto& [name, value] : *a.quantities.table()) {
    if (value.number() == nullptr) continue;
    EXPECT_EQ(*value.number(), *b.quantities.find(name)->number()) << name;
  }
}

TEST_F(Resume, GivesTheSameBitsAsARunInOnePiece) {
  const results::RunSummary whole = run(scene_with({{"output.checkpoint_every", "0"}}));
  ASSERT_TRUE(whole.completed());
  ASSERT_FALSE(interrupted(0.3).completed());
  ASSERT_TRUE(std::filesystem::exists(checkpoint_file(results())));
  ASSERT_FALSE(interrupted(0.6, true).completed());
  const results::RunSummary resumed = run(scene_with(), {.threads = 2, .output = results(), .resume = true});
  ASSERT_TRUE(resumed.completed()) << resumed.status;
  expect_same_bits(whole, resumed);
  EXPECT_FALSE(std::filesystem::exists(checkpoint_file(results())));  // nothing is left to go on with
}

TEST_F(Resume, RefusesWhatIsNotItsOwn) {
  EXPECT_NE(refusal({}).find("is not there"), std::string::npos);
  EXPECT_NE(refusal({{"output.checkpoint_every", "0"}}).find("a run without checkpoints cannot be taken up again"),
            std::string::npos);
  ASSERT_FALSE(interrupted(0.3).completed());
  EXPECT_NE(refusal({{"material.youngs_modulus", "26e9"}}).find("belongs to another run"), std::string::npos);
  EXPECT_NE(refusal({{"ground_motion.vertical_scale", "0.5"}}).find("belongs to another run"), std::string::npos);
  EXPECT_NE(refusal({{"dynamics.duration", "1.5"}}).find("belongs to another run"), std::string::npos);
  const auto size = std::filesystem::file_size(checkpoint_file(results()));
  std::filesystem::resize_file(checkpoint_file(results()), size - 8);
  EXPECT_NE(refusal({}).find("is damaged"), std::string::npos);
  std::ofstream(checkpoint_file(results())) << "sunder";
  EXPECT_NE(refusal({}).find("is no checkpoint"), std::string::npos);
}

TEST_F(Resume, IsRefusedForScenesThatCannotBeTakenUp) {
  try {
    (void)scene_with({{"output.fields_every", "10"}});
    FAIL() << "accepted";
  } catch (const scene::SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("fields cannot be taken up again"), std::string::npos) << error.what();
  }
}

TEST_F(Resume, GivesTheSameBitsWithACrackWhoseFacesTouch) {
  const std::vector<scene::Override> crack{
      {"crack[0].path", "[[0, 5], [1, 5]]"}, {"contact.model", "\"penalty\""}, {"crack_water.model", "\"moving\""}};
  std::vector<scene::Override> without = crack;
  without.push_back({"output.checkpoint_every", "0"});
  const results::RunSummary whole = run(scene_with(without));
  ASSERT_TRUE(whole.completed()) << whole.status;
  ASSERT_FALSE(interrupted(0.3, false, crack).completed());
  std::vector<scene::Override> softer = crack;
  softer.push_back({"contact.initial_stiffness", "2e8"});
  EXPECT_NE(refusal(softer).find("belongs to another run"), std::string::npos);
  std::vector<scene::Override> smoother = crack;
  smoother.push_back({"crack_water.relative_roughness", "0.25"});
  EXPECT_NE(refusal(smoother).find("belongs to another run"), std::string::npos);
  const results::RunSummary resumed = run(scene_with(crack), {.threads = 2, .output = results(), .resume = true});
  ASSERT_TRUE(resumed.completed()) << resumed.status;
  expect_same_bits(whole, resumed);
}

}  // namespace
}  // namespace sunder::simulation
