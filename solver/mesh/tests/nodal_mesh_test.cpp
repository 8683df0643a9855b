#include "solver/mesh/nodal_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

PolygonMesh two_squares() {
  return square_grid(rectangle(2, 1), 1.0);
}

TEST(NodalMesh, KeepsVerticesAsFirstNodesAndOrderOneAddsNone) {
  const PolygonMesh mesh = two_squares();
  const NodalMesh nodal = place_nodes(mesh, [](int, int) { return 1; });
  ASSERT_EQ(nodal.node_count(), 6);
  for (int v = 0; v < 6; ++v) EXPECT_EQ(Point(nodal.coordinates().col(v)), mesh.vertices[v]);
  EXPECT_EQ(nodal.polygon(1).nodes.size(), 4u);
  EXPECT_FALSE(nodal.polygon(1).open);
}

TEST(NodalMesh, SharesInnerNodesOfACommonEdgeInOppositeSense) {
  const NodalMesh nodal = place_nodes(two_squares(), [](int, int) { return 4; });
  EXPECT_EQ(nodal.node_count(), 6 + 7 * 3);
  std::vector<int> left = nodal.edge_nodes(0, 1), right = nodal.edge_nodes(1, 3);
  std::reverse(right.begin(), right.end());
  EXPECT_EQ(left, right);
}

TEST(NodalMesh, SharedEdgeTakesTheLargerOrderWhicheverPolygonAsksForIt) {
  for (const int asking : {0, 1}) {
    const NodalMesh nodal = place_nodes(two_squares(), [&](int polygon, int) { return polygon == asking ? 5 : 2; });
    EXPECT_EQ(nodal.polygon(0).orders[1], 5);
    EXPECT_EQ(nodal.polygon(1).orders[3], 5);
    EXPECT_EQ(nodal.polygon(1 - asking).orders[0], 2);
    EXPECT_EQ(nodal.node_count(), 6 + 4 * 4 + 3 * 1);
  }
}

TEST(NodalMesh, NodesWithinAnEdgeAreGaussLobattoPoints) {
  const NodalMesh nodal = place_nodes(square_grid(rectangle(2, 2), 2.0), [](int, int) { return 3; });
  const std::vector<int> bottom = nodal.edge_nodes(0, 0);
  // The four-point rule on [-1, 1] has ±1, ±1/√5; two roundings are allowed.
  EXPECT_NEAR(nodal.coordinates()(0, bottom[1]), 1.0 - 1.0 / std::sqrt(5.0), 5e-16);
  EXPECT_NEAR(nodal.coordinates()(0, bottom[2]), 1.0 + 1.0 / std::sqrt(5.0), 5e-16);
  EXPECT_EQ(nodal.coordinates()(1, bottom[1]), 0.0);
}

TEST(NodalMesh, EdgesStartWhereTheOrdersBeforeThemEnd) {
  const NodalMesh nodal = place_nodes(two_squares(), [](int, int edge) { return edge + 1; });
  for (int i = 0; i < nodal.polygon_count(); ++i) {
    const NodalPolygon p = nodal.polygon(i);
    int sum = 0;
    for (int e = 0; e < 4; ++e) {
      EXPECT_EQ(nodal.edge_nodes(i, e).front(), p.nodes[sum]);
      sum += p.orders[e];
      EXPECT_EQ(nodal.edge_nodes(i, e).back(), p.nodes[sum % p.nodes.size()]);
    }
    EXPECT_EQ(sum, static_cast<int>(p.nodes.size()));
  }
}

TEST(NodalMesh, OpenPolygonHasOneNodeMoreThanItsOrdersAdd) {
  const NodalMesh nodal = place_nodes(cracked_square(), [](int, int) { return 3; });
  const NodalPolygon p = nodal.polygon(0);
  EXPECT_TRUE(p.open);
  EXPECT_EQ(p.orders.size(), 5u);
  EXPECT_EQ(p.nodes.size(), 16u);
  EXPECT_EQ(p.nodes.front(), 4);
  EXPECT_EQ(p.nodes.back(), 5);
}

TEST(NodalMesh, RefusesAnOrderBelowOne) {
  EXPECT_THROW(place_nodes(two_squares(), [](int, int edge) { return edge; }), std::invalid_argument);
}

TEST(NodalMesh, IsTheSameFromRunToRun) {
  const PolygonMesh mesh = square_grid(rectangle(7, 5), 1.0);
  const auto order = [](int polygon, int edge) { return 1 + (polygon * 7 + edge * 3) % 5; };
  const NodalMesh a = place_nodes(mesh, order), b = place_nodes(mesh, order);
  EXPECT_EQ(a.coordinates(), b.coordinates());
}

}  // namespace
}  // namespace sunder::mesh
