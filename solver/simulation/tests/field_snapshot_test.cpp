#include "solver/simulation/field_snapshot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/crack/crack_faces.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/scene/reader.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/polygon_loads.hpp"
#include "solver/simulation/run.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/static_solution.hpp"

namespace sunder::simulation {
namespace {

namespace fs = std::filesystem;

const char* const kinked_crack = R"(
name = "kinked crack"
analysis = "static"
[geometry]
outline = [[0, -1], [1, -1], [1, 1], [0, 1]]
boundaries = { bottom = [0], top = [2] }
[mesh]
size = 0.2
order = 2
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2400
[[crack]]
path = [[0, 0], [0.3, 0.02], [0.5, 0.12]]
[[support]]
boundary = "bottom"
fix = ["y"]
[[support]]
point = [1, -1]
fix = ["x"]
)";

scene::Scene scene_of(const std::string& more = "") {
  return scene::read_scene_text(std::string(kinked_crack) + more, "test.scene.toml");
}

Body body_of(const scene::Scene& scene) {
  Ledger ledger;
  return build_body(scene, ledger);
}

/// x ↦ C + G x at the nodes.
Eigen::VectorXd linear(const Body& body, const Eigen::Vector2d& shift, const Eigen::Matrix2d& gradient) {
  const Eigen::Matrix2Xd values = (gradient * body.nodes.coordinates()).colwise() + shift;
  return values.reshaped();
}

double area_of(const results::FieldMesh& mesh, std::size_t polygon) {
  double twice = 0.0;
  const std::int64_t first = mesh.offsets[polygon], last = mesh.offsets[polygon + 1];
  for (std::int64_t i = first; i < last; ++i) {
    const Eigen::Vector2d a = mesh.points.col(mesh.connectivity[i]);
    const Eigen::Vector2d b = mesh.points.col(mesh.connectivity[i + 1 < last ? i + 1 : first]);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(FieldGeometry, CoversTheBodyOnceAndIsOpenAlongTheCrack) {
  const Body body = body_of(scene_of());
  const results::FieldMesh mesh = field_geometry(body).mesh;
  ASSERT_EQ(mesh.polygon_count(), body.nodes.polygon_count());
  ASSERT_EQ(mesh.point_count(), body.nodes.node_count() + 1) << "one tip";
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < mesh.offsets.size(); ++i) {
    EXPECT_GT(area_of(mesh, i), 0.0) << "polygon " << i << " is not counter-clockwise";
    area += area_of(mesh, i);
  }
  EXPECT_NEAR(area, 2.0, 1e-12);
  const Eigen::Vector2d tip = mesh.points.rightCols<1>();
  EXPECT_NEAR((tip - Eigen::Vector2d(0.5, 0.12)).norm(), 0.0, 1e-14);
  EXPECT_EQ(std::count(mesh.connectivity.begin(), mesh.connectivity.end(), mesh.point_count() - 1), 1);

  // No polygon has nodes of both faces, but for that of the tip.
  const crack::CrackPairs pairs = crack::crack_pairs(body.polygons, body.nodes, 0);
  ASSERT_GT(pairs.count(), 3);
  const std::set<std::int64_t> lower(pairs.lower.begin(), pairs.lower.end());
  const std::set<std::int64_t> upper(pairs.upper.begin(), pairs.upper.end());
  int both = 0;
  for (std::size_t i = 0; i + 1 < mesh.offsets.size(); ++i) {
    const auto on = [&](const std::set<std::int64_t>& face) {
      return std::any_of(mesh.connectivity.begin() + mesh.offsets[i], mesh.connectivity.begin() + mesh.offsets[i + 1],
                         [&](std::int64_t point) { return face.count(point) > 0; });
    };
    both += on(lower) && on(upper) ? 1 : 0;
  }
  EXPECT_EQ(both, 1);
}

// A rigid motion leaves the body without stress, and carries the tip with it; so does a linear field with its uniform
// stress in all closed polygons. 1e-12 of E times the gradient: sums of a dozen products over lengths of 1e-2.
TEST(FieldGeometry, GivesLinearFieldsTheirExactStressAndTip) {
  const scene::Scene scene = scene_of();
  const Body body = body_of(scene);
  const FieldGeometry geometry = field_geometry(body);
  const Eigen::Matrix2d turn{{0.0, -1e-3}, {1e-3, 0.0}};
  const Eigen::VectorXd rigid = linear(body, {0.2, -0.1}, turn);
  const results::Field moved = vector_field(geometry, "displacement", rigid);
  ASSERT_EQ(moved.values.rows(), 3);
  ASSERT_EQ(moved.values.cols(), geometry.mesh.point_count());
  EXPECT_EQ(moved.values.row(2).norm(), 0.0);
  const Eigen::Vector2d tip = Eigen::Vector2d(0.2, -0.1) + turn * Eigen::Vector2d(0.5, 0.12);
  EXPECT_LE((moved.values.rightCols<1>().head<2>() - tip).norm(), 1e-12);
  EXPECT_LE(stress_field(geometry, rigid).values.cwiseAbs().maxCoeff(), 1e-12 * 25e9);

  const Eigen::Matrix2d gradient{{2e-3, 1e-3}, {0.0, -1e-3}};
  const results::Field stress = stress_field(geometry, linear(body, {0.0, 0.0}, gradient));
  const Eigen::Vector3d in_plane = material::elasticity_matrix(*scene.material) * Eigen::Vector3d(2e-3, -1e-3, 1e-3);
  ASSERT_EQ(stress.values.rows(), 6);
  for (Eigen::Index i = 0; i < stress.values.cols(); ++i) {
    if (body.polygons.polygons[i].open) continue;  // its faces are free: the linear field is not its solution
    Eigen::VectorXd expected(6);
    expected << in_plane[0], in_plane[1], 0.2 * (in_plane[0] + in_plane[1]), in_plane[2], 0.0, 0.0;
    EXPECT_LE((stress.values.col(i) - expected).norm(), 1e-12 * 25e9) << "polygon " << i;
  }
}

TEST(FieldGeometry, HasNoStressAcrossThePlaneInPlaneStress) {
  const Body body = body_of(scene::read_scene_text(kinked_crack, "test.scene.toml",
                                                   std::vector{scene::Override{"material.plane", "\"stress\""}}));
  const results::Field stress =
      stress_field(field_geometry(body), linear(body, {0.0, 0.0}, Eigen::Matrix2d::Identity()));
  EXPECT_GT(stress.values.row(0).minCoeff(), 0.0);
  EXPECT_EQ(stress.values.row(2).norm(), 0.0);
}

// Virtual work with y e_y: ∫ σ_yy dA = Σ force times lever. Tension 1e6 on both ends at y = ±1 gives 2e6; its own
// weight 2400 · 9.81 · 2 hangs between y = 0 and the support at y = -1; water on the two faces cancels. ∫ σ_xx dA = 0.
// Round-off of the solution: residual 1e-13 times the forces.
TEST(FieldGeometry, HasMeanStressesThatBalanceTheLoads) {
  std::string text = kinked_crack;
  text.replace(text.find("[0.5, 0.12]]"), 12, "[0.5, 0.12]]\npressure = [2e5, 1e5]");
  text += "[[load]]\nboundary = \"top\"\ntraction = [0, 1e6]\n[gravity]\nacceleration = 9.81\n";
  const scene::Scene scene = scene::read_scene_text(text, "test.scene.toml");
  const Body body = body_of(scene);
  numerics::ThreadPool pool(1);
  const sbfem::Formation formation = sbfem::form(body.nodes, body.materials);
  const Eigen::VectorXd force = boundary_forces(scene, body) + crack_face_forces(scene, body) +
                                interior_loads(scene, body, formation, pool).force;
  const StaticSolution solution = solve_static(sbfem::assemble_stiffness(body.nodes, formation, nullptr), force,
                                               supports_of(scene, body, false).constraints);
  const FieldGeometry geometry = field_geometry(body, [&](int polygon, const sbfem::Boundary& boundary) {
    return polygon_loads(scene, body, polygon, boundary);
  });
  const results::Field stress = stress_field(geometry, solution.displacement);
  Eigen::VectorXd integral = Eigen::VectorXd::Zero(6);
  for (Eigen::Index i = 0; i < stress.values.cols(); ++i) {
    integral += area_of(geometry.mesh, static_cast<std::size_t>(i)) * stress.values.col(i);
  }
  EXPECT_NEAR(integral[1], 2e6 - 2400.0 * 9.81 * 2.0, 1e-4);
  EXPECT_NEAR(integral[0], 0.0, 1e-4);
  EXPECT_NEAR(integral[3], 0.0, 1e-4);
}

class FieldRun : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "sunder-field-run-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  bool in_ledger(const results::RunSummary& summary) const {
    return std::any_of(summary.parts.begin(), summary.parts.end(),
                       [](const results::PartCost& cost) { return cost.part == "results"; });
  }
  fs::path folder_;
};

constexpr const char* load = "[[load]]\nboundary = \"top\"\ntraction = [0, 1e6]\n";
constexpr const char* fields = "[output]\nfields_every = 1\n";

TEST_F(FieldRun, IsWrittenWhereItIsAskedForAndCostsNothingWhereItIsNot) {
  const RunOptions options{.threads = 1, .output = folder_ / "made"};
  for (const char* absent : {"", "[output]\nfields_every = 0\n"}) {
    const results::RunSummary without = run(scene_of(std::string(load) + absent), options);
    EXPECT_TRUE(without.completed()) << without.status;
    EXPECT_FALSE(in_ledger(without));
    EXPECT_FALSE(fs::exists(folder_ / "made"));
  }
  const results::RunSummary with = run(scene_of(std::string(load) + fields), options);
  EXPECT_TRUE(with.completed()) << with.status;
  EXPECT_TRUE(in_ledger(with));
  EXPECT_GT(fs::file_size(folder_ / "made" / field_file_name), 0u);
}

TEST_F(FieldRun, OfAModalAnalysisHasItsOwn) {
  std::string text = kinked_crack;
  text.replace(text.find("\"static\""), 8, "\"modal\"");
  const results::RunSummary summary =
      run(scene::read_scene_text(text + "[modal]\ncount = 2\n" + fields, "test.scene.toml"),
          {.threads = 1, .output = folder_});
  EXPECT_TRUE(summary.completed()) << summary.status;
  EXPECT_GT(fs::file_size(folder_ / field_file_name), 0u);
}

TEST_F(FieldRun, WithoutAFolderIsRefusedBeforeAnythingIsDone) {
  try {
    static_cast<void>(run(scene_of(std::string(load) + fields)));
    FAIL() << "fields without a folder were accepted";
  } catch (const scene::SceneError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("test.scene.toml:"), std::string::npos) << said;
    EXPECT_NE(said.find("[output] fields_every: this run has no folder"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace sunder::simulation
