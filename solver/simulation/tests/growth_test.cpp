#include "solver/simulation/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "solver/crack/crack_faces.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/state_transfer.hpp"
#include "solver/simulation/static_state.hpp"
#include "solver/simulation/tests/scene_runs.hpp"

namespace sunder::simulation {
namespace {

using tests::number;
using tests::scene_of;

const char* const plate = R"(
name = "edge crack"
analysis = "static"
[geometry]
outline = [[0, -1], [1, -1], [1, 1], [0, 1]]
boundaries = { bottom = [0], right = [1], top = [2], left = [3] }
[mesh]
cells = "squares"
size = 0.125
[material]
youngs_modulus = 1.0
poisson_ratio = 0.25
density = 2.0
[[crack]]
path = [[0, 0.02], [0.3, 0.02]]
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

struct Start {
  scene::Scene scene;
  Body body;
  sbfem::Formation formation;
};

Start start(const std::vector<scene::Override>& overrides = {}) {
  Start s{.scene = scene_of(plate, overrides), .body = {}, .formation = {}};
  Ledger ledger;
  s.body = build_body(s.scene, ledger);
  s.formation = sbfem::form(s.body.nodes, s.body.materials, {.with_mass = true});
  return s;
}

/// Straight on, left, right, over several polygons, by a small part of one.
const mesh::Point advances[] = {{0.36, 0.02}, {0.40, 0.06}, {0.47, 0.05}, {0.75, 0.01}, {0.7501, 0.0101}};

TEST(Growth, FormsOnlyWhatChangedToTheSameBits) {
  for (const char* order : {"1", "3"}) {
    Start now = start({{"mesh.order", order}});
    for (const mesh::Point& to : advances) {
      Growth growth = grow(now.body, now.formation, 0, to);
      ASSERT_EQ(growth.event, crack::TipEvent::advanced) << growth.reason;
      const sbfem::Formation anew = sbfem::form(growth.body.nodes, growth.body.materials, {.with_mass = true});
      for (int i = 0; i < anew.polygon_count(); ++i) {
        const auto bytes = static_cast<std::size_t>(anew.stiffness(i).size()) * sizeof(double);
        ASSERT_EQ(std::memcmp(anew.stiffness(i).data(), growth.formation.stiffness(i).data(), bytes), 0) << i;
        ASSERT_EQ(std::memcmp(anew.mass(i).data(), growth.formation.mass(i).data(), bytes), 0) << i;
      }
      EXPECT_EQ(anew.summary().most_iterations, growth.formation.summary().most_iterations);
      // The way of a step runs through at most three of the 16 x 8 squares, each with its neighbours.
      EXPECT_GE(growth.formation.summary().reused_count, anew.polygon_count() - 30);
      now.body = std::move(growth.body);
      now.formation = std::move(growth.formation);
    }
  }
}

/// Translations, rotation, and a uniform tension along the direction of the crack at its tip, which leaves its faces
/// free of traction.
Eigen::MatrixXd linear_fields(const Body& body, double direction) {
  const Eigen::Matrix3d D = material::elasticity_matrix(body.materials.front());
  const mesh::Point t(std::cos(direction), std::sin(direction)), n(-t.y(), t.x());
  const double contraction = D(0, 1) / D(0, 0);
  Eigen::MatrixXd fields(body.dofs(), 4);
  for (int i = 0; i < body.nodes.node_count(); ++i) {
    const mesh::Point x = body.nodes.coordinates().col(i), stretch = x.dot(t) * t - contraction * x.dot(n) * n;
    fields.row(2 * i) << 1.0, 0.0, -x.y(), stretch.x();
    fields.row(2 * i + 1) << 0.0, 1.0, x.x(), stretch.y();
  }
  return fields;
}

TEST(StateTransfer, KeepsRigidMotionsAndTensionAlongTheCrack) {
  for (const char* order : {"1", "4"}) {
    Start now = start({{"mesh.order", order}});
    for (const mesh::Point& to : advances) {
      Growth growth = grow(now.body, now.formation, 0, to);
      ASSERT_EQ(growth.event, crack::TipEvent::advanced) << growth.reason;
      const double direction = tip_direction(now.body.polygons, 0);
      const Eigen::MatrixXd fields = linear_fields(now.body, direction);
      const TransferredFields moved =
          transfer_fields(now.body, now.formation, growth.body, growth.same, growth.report, fields);
      const TransferredEnergies energies = transferred_energies(
          {now.body, now.formation, fields}, {growth.body, growth.formation, moved.values}, growth.same);
      // Round-off of A (condition of a polygon's modes, below 1e3) and of about 15 products of its exponential.
      const Eigen::MatrixXd exact = linear_fields(growth.body, direction);
      EXPECT_LE((moved.values - exact).cwiseAbs().maxCoeff(), 1e-11) << to.transpose();
      EXPECT_GT(moved.interpolated_nodes, 0);
      // Rigid motions have no strain energy, translations the kinetic energy of the whole body: ½ ρ A = ½ · 2 · 2.
      EXPECT_LE(energies.strain_energy_change.head(3).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_LE(energies.kinetic_energy_change.head(2).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_NEAR(energies.kinetic_energy[0], 2.0, 1e-11);
      now.body = std::move(growth.body);
      now.formation = std::move(growth.formation);
    }
  }
}

TEST(StateTransfer, TheCrackOpensFromClosedAndStaysOpenBehind) {
  Start now = start({{"mesh.order", "2"}});
  numerics::ThreadPool pool(1);
  Ledger ledger;
  const Supports supports = supports_of(now.scene, now.body, false);
  const StaticState state = static_state(now.scene, now.body, now.formation, supports, pool, ledger);
  for (const mesh::Point& to : {mesh::Point(0.45, 0.02), mesh::Point(0.4, 0.12), mesh::Point(0.31, 0.02)}) {
    const Growth growth = grow(now.body, now.formation, 0, to);
    ASSERT_EQ(growth.event, crack::TipEvent::advanced) << growth.reason;
    const TransferredFields moved =
        transfer_fields(now.body, now.formation, growth.body, growth.same, growth.report, state.solution.displacement);
    const TransferredEnergies energies =
        transferred_energies({now.body, now.formation, state.solution.displacement},
                             {growth.body, growth.formation, moved.values}, growth.same);
    const crack::CrackPairs pairs = crack::crack_pairs(growth.body.polygons, growth.body.nodes, 0);
    const crack::CrackMotion motion = crack::crack_motion(pairs, moved.values.col(0));
    const crack::CrackPairs before = crack::crack_pairs(now.body.polygons, now.body.nodes, 0);
    const double mouth = crack::crack_motion(before, state.solution.displacement).opening[0];
    ASSERT_GT(mouth, 0.0);
    for (int i = 0; i < pairs.count(); ++i) {
      if (pairs.position[i] > 0.3 - 1e-12) {
        EXPECT_NEAR(motion.opening[i], 0.0, 1e-12 * mouth) << "new face at " << pairs.position[i];
      } else {  // an edge crack opens monotonically towards its mouth, like a square root near its tip
        EXPECT_GT(motion.opening[i], 0.3 * mouth * std::sqrt(1.0 - pairs.position[i] / 0.3)) << pairs.position[i];
        EXPECT_LE(motion.opening[i], 1.001 * mouth);
      }
    }
    EXPECT_EQ(motion.opening[0], mouth);
    // What the transfer adds to or takes from the energy is that of the polygons around the tip, a part of the whole.
    EXPECT_LT(std::abs(energies.strain_energy_change[0]), 0.05 * energies.strain_energy[0]);
  }
}

TEST(StateTransfer, RefusesFieldsOfAnotherBody) {
  const Start now = start();
  const Growth growth = grow(now.body, now.formation, 0, {0.4, 0.02});
  EXPECT_THROW(static_cast<void>(transfer_fields(now.body, now.formation, growth.body, growth.same, growth.report,
                                                 Eigen::VectorXd::Zero(3))),
               std::invalid_argument);
}

const std::string growing = std::string(plate) + "[propagation]\nfracture_toughness = 1\nincrement = 0.1\nsteps = 4\n";

std::string text(const results::RunSummary& summary, const std::string& path) {
  const results::Quantity* quantity = summary.quantities.find(path);
  return quantity != nullptr && quantity->text() != nullptr ? *quantity->text() : "";
}

TEST(PropagationRun, GivesFactorPathAndHistoryTheSameForAnyThreads) {
  const results::RunSummary one = run(scene_of(growing), {.threads = 1}), two = run(scene_of(growing), {.threads = 2});
  ASSERT_TRUE(one.completed()) << one.status;
  EXPECT_EQ(text(one, "end"), "steps");
  ASSERT_TRUE(one.history && two.history);
  ASSERT_EQ(one.history->rows(), 5u);
  for (std::size_t row = 0; row < 5; ++row) {
    for (std::size_t column = 0; column < one.history->columns().size(); ++column) {
      EXPECT_EQ(one.history->at(row, column), two.history->at(row, column)) << row << ' ' << column;
    }
    // The factor brings K_eq to the toughness; with K_II of a few percent K_eq is K_I to its square.
    const double K_I = number(one, "growth[0].K_I[" + std::to_string(row) + "]");
    EXPECT_NEAR(K_I * one.history->at(row, 1), 1.0, 0.01);
  }
  EXPECT_LT(number(one, "load_factors[4]"), number(one, "load_factors[3]"));
}

TEST(PropagationRun, EndsWhereTheBodyIsCutInTwo) {
  const results::RunSummary summary = run(scene_of(growing, {{"propagation.steps", "50"}}));
  ASSERT_TRUE(summary.completed()) << summary.status;
  EXPECT_EQ(text(summary, "end"), "cut in two");
  EXPECT_EQ(text(summary, "events[0].event"), "reached boundary right");
  EXPECT_EQ(text(summary, "events[1].event"), "cut in two");
  EXPECT_NEAR(number(summary, "events[0].position[0]"), 1.0, 1e-12);
}

TEST(PropagationRun, StopsAtALengthAndWhereNothingOpens) {
  const results::RunSummary length = run(scene_of(growing, {{"propagation.until_length", "0.5"}}));
  EXPECT_EQ(text(length, "end"), "until_length");
  EXPECT_EQ(number(length, "growths"), 2.0);
  const results::RunSummary closed =
      run(scene_of(growing, {{"load[0].traction", "[0, -1]"}, {"load[1].traction", "[0, 1]"}}));
  EXPECT_EQ(closed.status, "stopped: no crack opens under these loads: K_I is negative at every tip after 0 growths");
}

TEST(PropagationRun, RefusesWhatMakesNoSense) {
  const auto refusal = [&](const std::vector<scene::Override>& overrides) -> std::string {
    try {
      static_cast<void>(scene_of(growing, overrides));
    } catch (const scene::SceneError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refusal({{"propagation.increment", "3"}}).find("increment: 3 m is larger than the body"),
            std::string::npos);
  EXPECT_NE(refusal({{"propagation.fracture_toughness", "0"}}).find("accepted: a number > 0"), std::string::npos);
  EXPECT_NE(refusal({{"crack", "[]"}}).find("a crack must be there to grow"), std::string::npos);
}

}  // namespace
}  // namespace sunder::simulation
