#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/sbfem/assembly.hpp"
#include "solver/simulation/crack_face_loads.hpp"
#include "solver/simulation/moving_water.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/static_solution.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::number;
using tests::scene_of;

using Eigen::VectorXd;

/// An edge crack of 2 m in a block, with own weight, on a grid of squares of order `order`: pairs outside its tip
/// polygon.
scene::Scene cracked_block(int order, const std::string& pressure) {
  const std::string text = R"(
name = "block"
analysis = "static"
[geometry]
outline = [[0, 0], [4, 0], [4, 4], [0, 4]]
boundaries = { base = [0] }
[mesh]
cells = "squares"
size = 0.5
[material]
youngs_modulus = 1e9
poisson_ratio = 0.2
density = 2000
[gravity]
[[crack]]
path = [[0, 2], [2.25, 2]]
)" + pressure + R"(
[[support]]
boundary = "base"
fix = ["x", "y"]
)";
  const std::vector<scene::Override> overrides{{"mesh.order", std::to_string(order)}};
  return scene_of(text, overrides);
}

struct Block {
  scene::Scene scene;
  Body body;
  sbfem::Formation formation;
  CrackFaceLoads faces;

  explicit Block(int order) : scene(cracked_block(order, "")) {
    Ledger ledger;
    body = build_body(scene, ledger);
    formation = sbfem::form(body.nodes, body.materials);
    faces = crack_face_loads(scene, body, formation, 0);
  }
};

TEST(CrackFaceLoads, GiveTheOpeningAndTheFactorsThatAStaticSceneHas) {
  for (const int order : {1, 2}) {
    const Block block(order);
    const double p = 3e5;
    const VectorXd force = p * (block.faces.loads * block.faces.uniform_share());
    const StaticSolution solution = solve_static(sbfem::assemble_stiffness(block.body.nodes, block.formation), force,
                                                 supports_of(block.scene, block.body, false).constraints);
    // The same pressure, as the static run applies it, less the weight alone: the same equations, so round-off only.
    const results::RunSummary wet = run(cracked_block(order, "pressure = 3e5")), dry = run(block.scene);
    const double opening = block.faces.loads.col(0).dot(solution.displacement);
    const double wanted = number(wet, "crack_mouth_opening") - number(dry, "crack_mouth_opening");
    EXPECT_NEAR(opening, wanted, 1e-9 * std::abs(wanted)) << order;
    CrackFaceLoads weightless = block.faces;
    weightless.tip->of_constant_loads.setZero();
    const Eigen::Vector3d K = weightless.tip->factors(solution.displacement, p, 0.0);
    const double K_I = number(wet, "tips[0].K_I") - number(dry, "tips[0].K_I");
    EXPECT_NEAR(K[0], K_I, 1e-9 * std::abs(K_I)) << order;
    EXPECT_NEAR(K[1], number(wet, "tips[0].K_II") - number(dry, "tips[0].K_II"), 1e-9 * std::abs(K_I)) << order;
  }
}

TEST(CrackFaceLoads, PressureLiftsOneFaceByItsLengthTimesPressure) {
  const Block block(1);
  const VectorXd force = block.faces.loads * block.faces.uniform_share();
  double up = 0.0, down = 0.0;
  for (Eigen::Index dof = 1; dof < force.size(); dof += 2) (force[dof] > 0.0 ? up : down) += force[dof];
  EXPECT_NEAR(up + down, 0.0, 1e-12);
  // Pairs share 2.25 m less the tip polygon's part; the rest is spread over that polygon's nodes in both senses.
  EXPECT_NEAR(block.faces.edge_share.sum(), block.faces.pairs.position[block.faces.pairs.count() - 1], 1e-14);
}

class MovingWaterTest : public ::testing::Test {
 protected:
  Block block{1};
  std::vector<double> opening;
  MovingWater water_of(double longest_segment, bool full) {
    const mesh::Point tip = block.faces.tip->position;
    opening.assign(static_cast<std::size_t>(block.faces.pairs.count()), 0.0);
    for (std::size_t i = 0; i < opening.size(); ++i) opening[i] = 1e-3 * (1.0 - 0.3 * static_cast<double>(i));
    return {water_nodes(block.faces.pairs, block.body.nodes, &tip, longest_segment),
            block.faces.pairs.count(),
            {.water = {}, .minimum_aperture = 0.03, .rule = crackwater::ApertureRule::sum, .initially_full = full},
            opening};
  }
};

TEST_F(MovingWaterTest, AtRestItIsTheUniformPressureOfTheMouth) {
  for (const double segment : {10.0, 0.1}) {
    MovingWater water = water_of(segment, true);
    faces::WaterForces forces(water.forces(), water.pairs());
    ASSERT_TRUE(water.trial(opening, 2e5, 0.01, forces));
    const VectorXd wanted = 2e5 * block.faces.uniform_share();
    EXPECT_LE((forces.force - wanted).lpNorm<Eigen::Infinity>(), 1e-12 * wanted.lpNorm<Eigen::Infinity>()) << segment;
    EXPECT_LE((forces.by_mouth - block.faces.uniform_share()).lpNorm<Eigen::Infinity>(), 1e-12) << segment;
  }
}

TEST_F(MovingWaterTest, DerivativesAgreeWithDifferences) {
  for (const bool full : {true, false}) {
    MovingWater water = water_of(0.2, full);
    faces::WaterForces forces(water.forces(), water.pairs()), more(forces), less(forces);
    std::vector<double> moved = opening;
    for (std::size_t i = 0; i < moved.size(); ++i)
      moved[i] -= (full ? 2e-4 : 2e-2) * (1.0 - 0.2 * static_cast<double>(i));
    const double p = 2e5, dt = 0.01;
    ASSERT_TRUE(water.trial(moved, p, dt, forces));
    // Central differences: step² / 6 times the third derivative against eps / step; 1e-6 of the largest entry at this
    // step.
    const double step = 1e-8, scale = forces.by_opening.cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < moved.size(); ++i) {
      std::vector<double> up = moved, down = moved;
      up[i] += step;
      down[i] -= step;
      ASSERT_TRUE(water.trial(up, p, dt, more) && water.trial(down, p, dt, less));
      const VectorXd difference = (more.force - less.force) / (2.0 * step);
      EXPECT_LE((difference - forces.by_opening.col(static_cast<Eigen::Index>(i))).lpNorm<Eigen::Infinity>(),
                1e-5 * scale)
          << full << " " << i;
    }
    ASSERT_TRUE(water.trial(moved, p + 1.0, dt, more) && water.trial(moved, p - 1.0, dt, less));
    EXPECT_LE(((more.force - less.force) / 2.0 - forces.by_mouth).lpNorm<Eigen::Infinity>(), 1e-6) << full;
  }
}

TEST_F(MovingWaterTest, AcceptingKeepsTheWaterOfTheCrack) {
  MovingWater water = water_of(0.2, true);
  faces::WaterForces forces(water.forces(), water.pairs());
  for (int step = 0; step < 50; ++step) {
    std::vector<double> moved = opening;
    for (double& value : moved) value += 5e-4 * std::sin(0.7 * step);
    ASSERT_TRUE(water.trial(moved, 2e5, 0.01, forces));
    water.accept();
  }
  EXPECT_LE(std::abs(water.state().balance_error), 1e-13 * water.state().moved);
}

}  // namespace
}  // namespace sunder::simulation
