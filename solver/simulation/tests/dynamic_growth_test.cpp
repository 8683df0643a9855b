/// Cracks that grow while the body shakes: the same bits from run to run and for any number of threads; what such a run
/// refuses.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "solver/scene/reader.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/run.hpp"

namespace sunder::simulation {
namespace {

const char* const block = R"(
name = "cracked block"
analysis = "dynamic"
[geometry]
outline = [[0, 0], [10, 0], [10, 20], [0, 20]]
boundaries = { base = [0], crest = [2], upstream = [3] }
[mesh]
cells = "squares"
size = 2.0
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2450
[gravity]
[[support]]
boundary = "base"
fix = ["x", "y"]
[[crack]]
path = [[0, 10], [5, 10]]
[reservoir]
boundary = "upstream"
level = 18
[ground_motion]
horizontal = "shaking.csv"
[dynamics]
time_step = 0.005
duration = 0.16
[contact]
[crack_water]
aperture = "sum"
[propagation]
fracture_toughness = 2e6
increment = 0.5
)";

class DynamicGrowth : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / "dynamic-growth";
    std::filesystem::create_directories(folder_);
    std::ofstream record(folder_ / "shaking.csv");
    for (int i = 0; i <= 20; ++i) record << 0.01 * i << ',' << (i % 8 < 4 ? 40.0 : -40.0) << '\n';
  }
  scene::Scene scene_with(const std::vector<scene::Override>& overrides = {}) const {
    return scene::read_scene_text(block, (folder_ / "block.scene.toml").string(), overrides);
  }
  std::string refusal(const std::vector<scene::Override>& overrides) const {
    try {
      (void)scene_with(overrides);
    } catch (const scene::SceneError& error) {
      return error.what();
    }
    return {};
  }

  std::filesystem::path folder_;
};

std::vector<std::uint64_t> bits(const results::RunSummary& summary) {
  std::vector<std::uint64_t> all;
  for (std::size_t row = 0; row < summary.history->rows(); ++row) {
    for (std::size_t column = 0; column < summary.history->columns().size(); ++column) {
      all.push_back(std::bit_cast<std::uint64_t>(summary.history->at(row, column)));
    }
  }
  return all;
}

long long growths(const results::RunSummary& summary) {
  for (const auto& [name, count] : summary.counts) {
    if (name == "growths") return count;
  }
  return 0;
}

TEST_F(DynamicGrowth, GivesTheSameBitsFromRunToRunAndForAnyThreads) {
  const results::RunSummary one = run(scene_with(), {.threads = 1}), again = run(scene_with(), {.threads = 1}),
                            two = run(scene_with(), {.threads = 2});
  ASSERT_GE(growths(one), 2);  // else nothing was grown that could differ
  EXPECT_EQ(bits(one), bits(again));
  EXPECT_EQ(bits(one), bits(two));
}

TEST_F(DynamicGrowth, RefusesFacesThatItCannotMove) {
  EXPECT_NE(refusal({{"contact.friction_coefficient", "0.6"}}).find("contact.friction_coefficient: 0.6 has no effect"),
            std::string::npos);
  EXPECT_NE(refusal({{"crack", "[{ path = [[3, 10], [7, 10]], inner = true }]"}}).find("crack[0].inner"),
            std::string::npos);
}

}  // namespace
}  // namespace sunder::simulation
