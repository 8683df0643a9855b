#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "solver/crack/crack_path.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/face_compliance.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/static_solution.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::number;
using tests::numbers;
using tests::Overrides;
using tests::run_text;
using tests::scene_of;

/// Two bars, one on the other, pressed together by 0.1 mm.
const char* const two_bars = R"(
name = "two bars"
analysis = "static"
[geometry]
outline = [[0, 0], [1, 0], [1, 2], [0, 2]]
boundaries = { bottom = [0], right = [1], top = [2], left = [3] }
[mesh]
cells = "squares"
size = 0.5
order = 2
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
[[crack]]
path = [[0, 1], [1, 1]]
through = true
[[support]]
boundary = "bottom"
fix = ["y"]
[[support]]
point = [0, 0]
fix = ["x"]
[[support]]
boundary = "top"
fix = ["y"]
displacement = [0, -1e-4]
[[support]]
point = [0, 2]
fix = ["x"]
[contact]
)";
constexpr double plane_modulus = 25e9 / 0.96;

TEST(FaceCompliance, IsTheFlexibilityOfTheFaces) {
  const scene::Scene scene = scene_of(
      two_bars,
      {{"crack[0].path", "[[0.2, 0.8], [0.8, 1.2]]"}, {"crack[0].through", "false"}, {"crack[0].inner", "true"}});
  Ledger ledger;
  const Body body = build_body(scene, ledger);
  const Supports supports = supports_of(scene, body, false);
  const sbfem::Formation formation = sbfem::form(body.nodes, body.materials, {});
  const Eigen::SparseMatrix<double> stiffness = sbfem::assemble_stiffness(body.nodes, formation);
  const StaticEquations equations(stiffness, supports.constraints);
  const FacePairs faces = face_pairs(body.polygons, body.nodes);
  ASSERT_EQ(body.polygons.cracks.size(), 2u);
  // The pair in the middle, which the faces to both tips share, is there once, with the lengths of both sides.
  int apart = 0;
  for (int tip = 0; tip < 2; ++tip) apart += crack::crack_pairs(body.polygons, body.nodes, tip).count();
  EXPECT_EQ(faces.count(), apart - 1);

  const FaceCompliance compliance =
      face_compliance(equations.factor(), pair_operator(faces.pairs, body.dofs(), true), supports.constraints.fixed);
  // By the inverse of the matrix of the free dofs.
  Eigen::SparseMatrix<double> full = stiffness.selfadjointView<Eigen::Lower>();
  Eigen::MatrixXd dense = full;
  for (int dof = 0; dof < body.dofs(); ++dof) {
    if (!supports.constraints.fixed[dof]) continue;
    dense.row(dof).setZero();
    dense.col(dof).setZero();
    dense(dof, dof) = 1e300;
  }
  const Eigen::MatrixXd expected = compliance.B.transpose() * dense.partialPivLu().solve(Eigen::MatrixXd(compliance.B));
  EXPECT_LE((compliance.F - expected).norm(), 1e-9 * expected.norm());
  EXPECT_EQ((compliance.F - compliance.F.transpose()).norm(), 0.0);
  // Opening is Bᵀ u.
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(body.dofs(), -1.0, 2.0);
  const crack::CrackMotion motion = crack::crack_motion(faces.pairs, u);
  const Eigen::VectorXd both = compliance.B.transpose() * u;
  EXPECT_LE((both.head(faces.count()) - motion.opening).norm(), 1e-14 * u.norm());
  EXPECT_LE((both.tail(faces.count()) - motion.sliding).norm(), 1e-14 * u.norm());
}

TEST(StaticContact, TwoBarsAndThePenaltyBetweenThemAreThreeSpringsInARow) {
  // σ = δ / (H/E' + 1/k), the same under every node of the faces, and a penetration σ/k.
  for (const double k : {1e8, 1e10, 1e14}) {
    const results::RunSummary summary = run_text(two_bars, {{"contact.initial_stiffness", std::to_string(k)}});
    ASSERT_TRUE(summary.completed()) << summary.status;
    const double stress = 1e-4 / (2.0 / plane_modulus + 1.0 / k);
    EXPECT_NEAR(number(summary, "reactions[0].force[1]") / stress, 1.0, 1e-10);
    EXPECT_NEAR(number(summary, "contact.max_penetration"), stress / k, 1e-10 * 1e-4);
    const std::vector<double> force = numbers(summary, "contact.contact_force"),
                              length = numbers(summary, "contact.tributary_length");
    ASSERT_GE(force.size(), 3u);
    for (std::size_t i = 0; i < force.size(); ++i) EXPECT_NEAR(force[i] / length[i] / stress, 1.0, 1e-9) << i;
    EXPECT_LE(number(summary, "residual"), 1e-12);
  }
}

TEST(StaticContact, OpenFacesAreFree) {
  const results::RunSummary summary = run_text(two_bars, {{"support[2].displacement", "[0, 1e-4]"}});
  ASSERT_TRUE(summary.completed());
  EXPECT_EQ(number(summary, "contact.closed"), 0.0);
  EXPECT_NEAR(number(summary, "crack_mouth_opening"), 1e-4, 1e-16);
  EXPECT_NEAR(number(summary, "reactions[0].force[1]"), 0.0, 1e-3);
}

TEST(StaticContact, FrictionThatHoldsMakesTheCutBodyWhole) {
  // Pressed and dragged: with friction enough the cut changes nothing.
  const Overrides drag = {{"support[2].fix", "[\"x\", \"y\"]"},
                          {"support[2].displacement", "[2e-5, -1e-4]"},
                          {"contact.model", "\"exact\""},
                          {"contact.friction_coefficient", "10.0"},
                          {"mesh.size", "0.25"},
                          {"mesh.order", "3"}};
  const results::RunSummary cut = run_text(two_bars, drag);
  ASSERT_TRUE(cut.completed()) << cut.status;
  for (const double slide : numbers(cut, "contact.sliding")) EXPECT_NEAR(slide, 0.0, 1e-18);
  // The cut leaves other polygons behind it, and the held corners are singular: on this mesh that is worth 1e-3. That
  // sticking is exact where the stress is uniform is the case contact/friction-inclined-plane.
  std::string whole = two_bars;
  whole.erase(whole.find("[[crack]]"), whole.find("[[support]]") - whole.find("[[crack]]"));
  whole.erase(whole.find("[contact]"));
  const results::RunSummary uncut = run_text(whole, {drag[0], drag[1], {"mesh.size", "0.25"}, {"mesh.order", "3"}});
  for (const char* path : {"reactions[2].force[0]", "reactions[2].force[1]"}) {
    EXPECT_NEAR(number(cut, path) / number(uncut, path), 1.0, 2e-3) << path;
  }
}

TEST(StaticContact, SameBitsForOneAndTwoThreads) {
  const Overrides edge = {{"crack[0].through", "false"}, {"crack[0].path", "[[0, 1], [0.6, 1]]"}};
  const results::RunSummary one = run_text(two_bars, edge, 1), two = run_text(two_bars, edge, 2);
  EXPECT_EQ(numbers(one, "contact.contact_force"), numbers(two, "contact.contact_force"));
  EXPECT_EQ(number(one, "tips[0].K_I"), number(two, "tips[0].K_I"));
}

TEST(StaticContact, HeldMouthsNeitherPartNorPenetrate) {
  // The pairs at both faces of the body are held on both sides: their flexibility is zero, and so is their gap.
  const results::RunSummary summary =
      run_text(two_bars, {{"support[1]", "{ boundary = \"left\", fix = [\"x\", \"y\"] }"},
                          {"support[3]", "{ boundary = \"right\", fix = [\"x\", \"y\"] }"},
                          {"contact.model", "\"exact\""}});
  ASSERT_TRUE(summary.completed()) << summary.status;
  EXPECT_EQ(numbers(summary, "contact.opening").front(), 0.0);
  EXPECT_EQ(numbers(summary, "contact.contact_force").front(), 0.0);
  EXPECT_LE(number(summary, "contact.max_penetration"), 1e-17);
}

TEST(StaticContact, ThroughCracksMustComeOut) {
  EXPECT_THROW((void)run_text(two_bars, {{"crack[0].path", "[[0, 1], [0.9, 1]]"}}), crack::CrackError);
  EXPECT_THROW((void)run_text(two_bars, {{"support[2].fix", "[\"x\"]"}}), scene::SceneError);  // the upper bar floats
}

/// A wall with a crack at its wet face.
const char* const wall = R"(
name = "wall"
analysis = "static"
[geometry]
outline = [[0, 0], [4, 0], [4, 8], [0, 8]]
boundaries = { base = [0], upstream = [3] }
[mesh]
size = 0.8
order = 2
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
[[crack]]
path = [[0, 3], [1, 2.5], [1.5, 2.5]]
[[support]]
boundary = "base"
fix = ["x", "y"]
)";

TEST(StandingWater, OfTheReservoirIsThatOfALoad) {
  const std::string as_load = std::string(wall) + "[[load]]\nboundary = \"upstream\"\nwater_level = 6.0\n";
  const results::RunSummary load = run_text(as_load);
  for (const char* model : {"hydrostatic", "westergaard", "incompressible", "compressible"}) {
    const results::RunSummary reservoir =
        run_text(std::string(wall) + "[reservoir]\nboundary = \"upstream\"\nlevel = 6.0\nmodel = \"" + model + "\"\n");
    EXPECT_EQ(number(reservoir, "tips[0].K_I"), number(load, "tips[0].K_I"));
    EXPECT_EQ(number(reservoir, "reactions[0].force[0]"), number(load, "reactions[0].force[0]"));
  }
  EXPECT_NEAR(number(load, "reactions[0].force[0]"), -0.5 * 9810.0 * 36.0, 1e-6);
}

TEST(StandingWater, FillsACrackHydrostaticallyFromItsMouth) {
  // Water of the crack and of the reservoir together act like the reservoir on a wetted, kinked face: the forces on the
  // base are those of the flat face, whatever the crack's shape, since both its faces bear the same.
  const std::string wet = std::string(wall) + "[reservoir]\nboundary = \"upstream\"\nlevel = 6.0\n[crack_water]\n";
  const results::RunSummary filled = run_text(wet),
                            dry = run_text(std::string(wall) + "[reservoir]\nboundary = \"upstream\"\nlevel = 6.0\n");
  EXPECT_NEAR(number(filled, "reactions[0].force[0]") / number(dry, "reactions[0].force[0]"), 1.0, 1e-10);
  EXPECT_NEAR(number(filled, "reactions[0].force[1]"), 0.0, 1e-5);
  EXPECT_GT(number(filled, "tips[0].K_I"), number(dry, "tips[0].K_I"));
  // Both models rest alike, and a horizontal crack bears the scene's own pressure of that size.
  const Overrides horizontal = {{"crack[0].path", "[[0, 3], [1.5, 3]]"}};
  Overrides moving = horizontal, pressed = horizontal;
  moving.push_back({"crack_water.model", "\"uniform\""});
  const double K_I = number(run_text(wet, horizontal), "tips[0].K_I");
  EXPECT_EQ(number(run_text(wet, moving), "tips[0].K_I"), K_I);
  pressed.push_back({"crack[0].pressure", "29430.0"});
  EXPECT_NEAR(number(run_text(std::string(wall) + "[reservoir]\nboundary = \"upstream\"\nlevel = 6.0\n", pressed),
                     "tips[0].K_I") /
                  K_I,
              1.0, 1e-10);
  // Above the water it stays dry, and says so.
  const results::RunSummary above = run_text(wet, {{"reservoir.level", "2.0"}});
  EXPECT_EQ(above.warnings.size(), 1u);
}

}  // namespace
}  // namespace sunder::simulation
