/// The water of a scene as a medium of its body: which nodes it moves with, its mass, the pressure at a mouth.

#include <gtest/gtest.h>

#include <string>

#include "solver/scene/reader.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/attached_medium.hpp"

namespace sunder::simulation {
namespace {

scene::Scene wall(const std::string& model, const std::string& level, bool water_on_the_right) {
  return scene::read_scene_text(
      "name = \"wall\"\nanalysis = \"modal\"\n[geometry]\noutline = [[0, 0], [4, 0], [4, 10], "
      "[0, 10]]\nboundaries = { base = [0], right = [1], left = [3] }\n[mesh]\nsize = 1.0\n"
      "[material]\nyoungs_modulus = 25e9\npoisson_ratio = 0.2\ndensity = 2450\n[reservoir]\n"
      "boundary = \"" +
          std::string(water_on_the_right ? "right" : "left") + "\"\nlevel = " + level + "\nmodel = \"" + model +
          "\"\n[[support]]\nboundary = \"base\"\nfix = [\"x\", \"y\"]\n",
      "wall.toml");
}

TEST(AttachedReservoir, IsAMassOfTheWetNodes) {
  numerics::ThreadPool pool(1);
  Ledger ledger;
  for (const bool right : {false, true}) {
    const scene::Scene scene = wall("incompressible", "8.3", right);
    const Body body = build_body(scene, ledger);
    const auto medium = attach_reservoir(scene, body, {}, pool, ledger);
    ASSERT_NE(medium, nullptr);
    EXPECT_EQ(medium->driven_by, DrivenBy::total);
    for (const int dof : medium->dofs) {
      EXPECT_EQ(dof % 2, 0);
      EXPECT_NEAR(body.nodes.coordinates()(0, dof / 2), right ? 4.0 : 0.0, 1e-9);
    }
    // 14 ζ(3)/π³ ρ H²; the sum of the series ends within 1e-7
    EXPECT_NEAR(medium->convolution->instantaneous_mass().sum() / (1000.0 * 8.3 * 8.3), 0.5427545144, 1e-7);
    Eigen::VectorXd history(medium->convolution->size());
    medium->convolution->history_force(history);
    EXPECT_EQ(history.norm(), 0.0);
  }
}

TEST(AttachedReservoir, PressesWhereTheFaceMovesIntoTheWater) {
  numerics::ThreadPool pool(1);
  Ledger ledger;
  for (const bool right : {false, true}) {
    const scene::Scene scene = wall("incompressible", "10", right);
    const Body body = build_body(scene, ledger);
    const auto medium = attach_reservoir(scene, body, {}, pool, ledger);
    const Eigen::VectorXd a = Eigen::VectorXd::Constant(medium->convolution->size(), right ? 1.0 : -1.0);
    const Eigen::VectorXd R = medium->convolution->instantaneous_mass() * a;
    const double base = reservoir_pressure_weights(scene, body, 0.0).dot(R);
    EXPECT_NEAR(base / (1000.0 * 10.0), 0.7424537454, 0.01);  // 8 G/π², by ten linear elements
    EXPECT_EQ(reservoir_pressure_weights(scene, body, 10.0).norm(), 0.0);
  }
}

TEST(AttachedReservoir, HasMemoryWhereTheWaterIsCompressible) {
  numerics::ThreadPool pool(1);
  Ledger ledger;
  const scene::Scene scene = wall("compressible", "10", false);
  const Body body = build_body(scene, ledger);
  const auto medium = attach_reservoir(scene, body, {.time_step = 0.002, .steps = 200}, pool, ledger);
  const Eigen::VectorXd a = Eigen::VectorXd::Ones(medium->convolution->size());
  Eigen::VectorXd history(a.size());
  medium->convolution->append(a);
  medium->convolution->history_force(history);
  EXPECT_GT(history.sum(), 0.0);
  EXPECT_LT(history.sum(), 0.5427545144 * 1000.0 * 100.0);
  EXPECT_EQ(attach_reservoir(wall("hydrostatic", "10", false), body, {}, pool, ledger), nullptr);
}

TEST(AttachedReservoir, RefusesALevelOffTheFaceAtItsTable) {
  numerics::ThreadPool pool(1);
  Ledger ledger;
  const scene::Scene scene = wall("westergaard", "10.5", false);
  const Body body = build_body(scene, ledger);
  try {
    (void)attach_reservoir(scene, body, {}, pool, ledger);
    FAIL() << "a level above the crest was accepted";
  } catch (const scene::SceneError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("wall.toml:12: [reservoir]"), std::string::npos) << said;
    EXPECT_NE(said.find("10.5"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace sunder::simulation
