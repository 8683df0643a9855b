#include "solver/sbfem/formation.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/sbfem/tests/meshes.hpp"

namespace sunder::sbfem {
namespace {

using namespace testing;

const std::vector<material::Isotropic> materials = {
    {.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0},
    {.youngs_modulus = 1e9, .poisson_ratio = 0.35, .density = 2000.0, .plane = material::Plane::stress},
    {.youngs_modulus = 40e9, .poisson_ratio = 0.0, .density = 2650.0},
};

/// Order 1 nearly everywhere, 2 and 3 on some edges, as around a crack.
int mixed_order(int polygon, int edge) {
  return polygon % 5 == 3 ? 1 + edge % 3 : 1;
}

bool same_bits(const Formation& a, const Formation& b) {
  for (int i = 0; i < a.polygon_count(); ++i) {
    const auto bytes = static_cast<std::size_t>(a.stiffness(i).size()) * sizeof(double);
    if (std::memcmp(a.stiffness(i).data(), b.stiffness(i).data(), bytes) != 0) return false;
    if (a.has_mass() && std::memcmp(a.mass(i).data(), b.mass(i).data(), bytes) != 0) return false;
  }
  return a.polygon_count() == b.polygon_count();
}

TEST(Formation, EqualsThePolygonsOneByOne) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(7, 5, 3), mixed_order);
  const Formation formation = form(mesh, materials, {.with_mass = true});
  ASSERT_EQ(formation.polygon_count(), 35);
  EXPECT_EQ(formation.summary().worst_status, PolygonStatus::converged);
  for (int i = 0; i < formation.polygon_count(); ++i) {
    const Coefficients c = coefficients(boundary_of(mesh, i), materials[static_cast<std::size_t>(i % 3)]);
    const PolygonSolution solution = solve_polygon(c, Route::matrix_sign);
    // the bar between two routes; masses by two solutions of the closed loop
    EXPECT_LT((formation.stiffness(i) - solution.K).norm(), 1e-12 * solution.K.norm()) << i;
    const Eigen::MatrixXd M = mass(c, solution);
    EXPECT_LT((formation.mass(i) - M).norm(), 1e-12 * M.norm()) << i;
    EXPECT_EQ(formation.stiffness(i), formation.stiffness(i).transpose());
    EXPECT_EQ(formation.mass(i), formation.mass(i).transpose());
  }
}

TEST(Formation, LargePolygonsGoOneByOneAndAgree) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(3, 2), [](int, int) { return 4; });
  const Formation batched = form(mesh, materials, {.with_mass = true});
  const Formation single = form(mesh, materials, {.with_mass = true, .largest_batched_size = 0});
  for (int i = 0; i < batched.polygon_count(); ++i) {
    EXPECT_LT((batched.stiffness(i) - single.stiffness(i)).norm(), 1e-12 * single.stiffness(i).norm());
    EXPECT_LT((batched.mass(i) - single.mass(i)).norm(), 1e-12 * single.mass(i).norm());
  }
}

TEST(Formation, HasTheSameBitsForAnyNumberOfThreads) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(9, 7, 2), mixed_order);
  const Formation one = form(mesh, materials, {.with_mass = true});
  for (const int threads : {1, 2, 3}) {
    numerics::ThreadPool pool(threads);
    EXPECT_TRUE(same_bits(one, form(mesh, materials, {.with_mass = true, .pool = &pool}))) << threads;
  }
}

TEST(Formation, PolygonDoesNotDependOnItsNeighboursInTheBatch) {
  mesh::PolygonMesh all = honeycomb(6, 4, 3);
  const Formation together = form(place_nodes(all, [](int, int) { return 1; }), materials, {.with_mass = true});
  for (const int chosen : {0, 7, 23}) {
    mesh::PolygonMesh alone = all;
    alone.polygons = {all.polygons[static_cast<std::size_t>(chosen)]};
    const Formation lonely = form(place_nodes(alone, [](int, int) { return 1; }), materials, {.with_mass = true});
    EXPECT_EQ(together.stiffness(chosen), lonely.stiffness(0));
    EXPECT_EQ(together.mass(chosen), lonely.mass(0));
  }
}

TEST(Formation, OtherRoutesAgree) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(3, 3), mixed_order);
  const Formation ring = form(mesh, materials);
  EXPECT_FALSE(ring.has_mass());
  for (const Route route : {Route::matrix_sign, Route::ordered_schur}) {
    const Formation other = form(mesh, materials, {.route = route});
    EXPECT_LT(other.summary().largest_asymmetry, 1e-10);
    for (int i = 0; i < ring.polygon_count(); ++i) {
      EXPECT_LT((ring.stiffness(i) - other.stiffness(i)).norm(), 1e-11 * ring.stiffness(i).norm());
    }
  }
}

TEST(Formation, WithoutDensityTheMassIsZero) {
  const std::vector<material::Isotropic> weightless = {{.youngs_modulus = 1.0, .poisson_ratio = 0.3}};
  const mesh::NodalMesh mesh = place_nodes(honeycomb(2, 2), [](int, int) { return 1; });
  const Formation formation = form(mesh, weightless, {.with_mass = true});
  for (int i = 0; i < formation.polygon_count(); ++i) EXPECT_EQ(formation.mass(i).norm(), 0.0);
}

TEST(Formation, NamesThePolygonAndTheEdgeThatTheCentreDoesNotSee) {
  mesh::PolygonMesh bad = honeycomb(3, 2);
  bad.polygons[4].scaling_centre += Eigen::Vector2d(5.0, 0.0);
  try {
    (void)form(place_nodes(bad, [](int, int) { return 1; }), materials);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("polygon 4: edge "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("J_b"), std::string::npos) << error.what();
  }
}

TEST(Formation, RefusesAMissingMaterial) {
  EXPECT_THROW((void)form(place_nodes(honeycomb(2, 2, 4), [](int, int) { return 1; }), materials),
               std::invalid_argument);
}

TEST(Formation, EmptyMeshIsEmpty) {
  const Formation formation =
      form(mesh::place_nodes(mesh::PolygonMesh{}, [](int, int) { return 1; }), materials, {.with_mass = true});
  EXPECT_EQ(formation.polygon_count(), 0);
  EXPECT_EQ(formation.summary().worst_polygon, -1);
}

TEST(Formation, TakesOverThePolygonsOfAnEarlierOne) {
  mesh::PolygonMesh polygons = honeycomb(7, 5, 3);
  const mesh::NodalMesh before = place_nodes(polygons, mixed_order);
  const Formation earlier = form(before, materials, {.with_mass = true});
  polygons.vertices[polygons.polygons[12].vertices[0]] += mesh::Point(1e-15, 1e-3);  // three polygons have it
  polygons.polygons[20].material = (polygons.polygons[20].material + 1) % 3;
  const mesh::NodalMesh mesh = place_nodes(polygons, [](int polygon, int edge) {
    return polygon == 30 ? 2 : mixed_order(polygon, edge);  // its neighbours get nodes too
  });
  std::vector<int> from(35);
  for (int i = 0; i < 35; ++i) from[i] = i;
  const std::vector<int> same = same_polygons(mesh, before, from);
  EXPECT_EQ(same[12], -1);
  EXPECT_EQ(same[20], -1);
  EXPECT_EQ(same[30], -1);
  EXPECT_EQ(same[1], 1);
  const Formation again = form_again(mesh, materials, {.with_mass = true}, earlier, same);
  EXPECT_TRUE(same_bits(again, form(mesh, materials, {.with_mass = true})));
  EXPECT_GT(again.summary().reused_count, 20);

  EXPECT_THROW(form_again(mesh, materials, {}, earlier, same), std::invalid_argument);  // without mass
  EXPECT_THROW(form_again(mesh, materials, {.with_mass = true}, earlier, std::vector<int>(3, -1)),
               std::invalid_argument);
  std::vector<int> wrong = same;
  wrong[30] = 1;  // of another size
  EXPECT_THROW(form_again(mesh, materials, {.with_mass = true}, earlier, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::sbfem
