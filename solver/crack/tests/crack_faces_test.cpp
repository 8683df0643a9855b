#include "solver/crack/crack_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/crack/advance_tip.hpp"
#include "solver/crack/insert_crack.hpp"
#include "solver/crack/tests/crack_meshes.hpp"

namespace sunder::crack {
namespace {

using testing::Point;

mesh::NodalMesh nodes_of_order(const mesh::PolygonMesh& mesh, int order) {
  return mesh::place_nodes(mesh, [order](int, int) { return order; });
}

TEST(CrackFaces, TributaryLengthsAreTheIntegralsOfTheShapeFunctions) {
  for (const int order : {1, 2, 3, 5}) {
    mesh::PolygonMesh mesh = testing::grid(8, 1);
    insert_crack(mesh, {{{0, 4.5}, {5.5, 4.5}}}, 0, {.tip_edges = 1});
    const mesh::NodalMesh nodes = nodes_of_order(mesh, order);
    const CrackPairs pairs = crack_pairs(mesh, nodes, 0);
    ASSERT_EQ(pairs.count(), 5 * order + 1);  // five cells are cut through, the tip lies in the middle of the sixth
    EXPECT_NEAR(pairs.tip_position, 5.5, 1e-14 * 5.5);
    // ∫ f ds over the cut cells is exact for polynomials to degree 2p - 1 and at least 1; the last half cell carries
    // the hat that falls to 0 at the tip, ½ · ½ · f at the last pair.
    for (int degree = 0; degree <= 2 * order - 1; ++degree) {
      double sum = 0.0;
      for (int i = 0; i < pairs.count(); ++i) sum += pairs.tributary_length[i] * std::pow(pairs.position[i], degree);
      const double exact = std::pow(5.0, degree + 1) / (degree + 1) + 0.25 * std::pow(5.0, degree);
      EXPECT_NEAR(sum, exact, 1e-13 * exact) << "order " << order << " degree " << degree;
    }
    for (int i = 0; i < pairs.count(); ++i) {
      // Nodes between the ends are placed from opposite ends on the two faces: a unit or two in the last place.
      EXPECT_NEAR((nodes.coordinates().col(pairs.lower[i]) - nodes.coordinates().col(pairs.upper[i])).norm(), 0.0,
                  1e-14);
      EXPECT_NEAR((pairs.normals.col(i) - Point(0, 1)).norm(), 0.0, 1e-15);
      EXPECT_NEAR(nodes.coordinates()(0, pairs.lower[i]), pairs.position[i], 1e-14 * 8);
    }
  }
}

/// Which side a node lies on, by the polygons that have it.
double height_of_polygons(const mesh::PolygonMesh& mesh, const mesh::NodalMesh& nodes, int node) {
  double sum = 0.0;
  int count = 0;
  for (int p = 0; p < nodes.polygon_count(); ++p) {
    if (mesh.polygons[p].open) continue;
    for (const int n : nodes.polygon(p).nodes) {
      if (n != node) continue;
      sum += mesh.polygons[p].scaling_centre.y();
      ++count;
    }
  }
  return sum / count;
}

TEST(CrackFaces, LowerIsOnTheRightOfThePath) {
  mesh::PolygonMesh mesh = testing::grid(8, 1);
  insert_crack(mesh, {{{0, 4.5}, {5.5, 4.5}}}, 0);
  const mesh::NodalMesh nodes = nodes_of_order(mesh, 2);
  const CrackPairs pairs = crack_pairs(mesh, nodes, 0);
  for (int i = 0; i + 1 < pairs.count(); ++i) {
    EXPECT_LT(height_of_polygons(mesh, nodes, pairs.lower[i]), 4.5);
    EXPECT_GT(height_of_polygons(mesh, nodes, pairs.upper[i]), 4.5);
  }
}

TEST(CrackFaces, OpeningAndSlidingOfAnInclinedCrack) {
  mesh::PolygonMesh mesh = testing::brick_mesh(8, 8, 0.2, 9);
  const double angle = 0.6;
  const Point along(std::cos(angle), std::sin(angle)), normal(-along.y(), along.x());
  const Point mouth(0, 3.3);
  insert_crack(mesh, {{mouth, mouth + 4.0 * along}}, 0);
  const mesh::NodalMesh nodes = nodes_of_order(mesh, 3);
  const CrackPairs pairs = crack_pairs(mesh, nodes, 0);
  ASSERT_GT(pairs.count(), 3);
  // Upper face moved by 2 mm along its normal and 5 mm along the path, lower one by -1 mm along the normal.
  Eigen::VectorXd u = Eigen::VectorXd::Zero(2 * nodes.node_count());
  for (int i = 0; i < pairs.count(); ++i) {
    u.segment<2>(2 * pairs.upper[i]) = 2e-3 * normal + 5e-3 * along;
    u.segment<2>(2 * pairs.lower[i]) = -1e-3 * normal;
  }
  const CrackMotion motion = crack_motion(pairs, u);
  const CrackMotion closed = crack_motion(pairs, -u);
  for (int i = 0; i < pairs.count(); ++i) {
    // Normals come from differences of coordinates of size 8 over edges down to a few hundredths.
    EXPECT_NEAR(motion.opening[i], 3e-3, 1e-13);
    EXPECT_NEAR(motion.sliding[i], 5e-3, 1e-13);
    EXPECT_LT(closed.opening[i], 0.0);
  }
}

TEST(CrackFaces, NormalAtAKinkIsTheDirectionOfTheSummedForce) {
  mesh::PolygonMesh mesh = testing::grid(8, 1);
  insert_crack(mesh, {{{0, 4.5}, {2.5, 4.5}, {2.5, 6.5}}}, 0);
  const CrackPairs pairs = crack_pairs(mesh, nodes_of_order(mesh, 1), 0);
  int at_kink = 0;
  for (int i = 0; i < pairs.count(); ++i) {
    if (std::abs(pairs.position[i] - 2.5) > 1e-9) continue;
    ++at_kink;
    // The edges on both sides of the kink are half a cell long: the normal is the bisector.
    EXPECT_NEAR((pairs.normals.col(i) - Point(-std::sqrt(0.5), std::sqrt(0.5))).norm(), 0.0, 1e-14);
    EXPECT_NEAR(pairs.tributary_length[i], 0.5, 1e-14);
  }
  EXPECT_EQ(at_kink, 1);
}

TEST(CrackFaces, CrackThatHasReachedAFaceHasPairsToItsEnd) {
  mesh::PolygonMesh mesh = testing::grid(8, 1);
  insert_crack(mesh, {{{0, 4.5}, {2.5, 4.5}}}, 0);
  ASSERT_EQ(advance_tip(mesh, 0, {9, 4.5}).event, TipEvent::reached_boundary);
  const CrackPairs pairs = crack_pairs(mesh, nodes_of_order(mesh, 2), 0);
  EXPECT_NEAR(pairs.tributary_length.sum(), 8.0, 1e-13);
  EXPECT_NEAR(pairs.position[pairs.count() - 1], 8.0, 1e-13);
  EXPECT_EQ(pairs.tip_position, pairs.position[pairs.count() - 1]);
}

TEST(CrackFaces, RefusesWhatIsNoCrackOrHasUnequalOrders) {
  mesh::PolygonMesh mesh = testing::grid(8, 1);
  insert_crack(mesh, {{{0, 4.5}, {2.5, 4.5}}}, 0);
  EXPECT_THROW(static_cast<void>(crack_pairs(mesh, nodes_of_order(mesh, 1), 1)), std::invalid_argument);
  const mesh::NodalMesh nodes = mesh::place_nodes(
      mesh, [&](int polygon, int) { return mesh.polygons[polygon].scaling_centre.y() > 4.5 ? 2 : 1; });
  EXPECT_THROW(static_cast<void>(crack_pairs(mesh, nodes, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::crack
