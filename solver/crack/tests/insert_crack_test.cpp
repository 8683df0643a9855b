#include "solver/crack/insert_crack.hpp"

#include <gtest/gtest.h>

#include "solver/crack/tests/crack_meshes.hpp"

namespace sunder::crack {
namespace {

TEST(InsertCrack, TipAtAGridVertexTakesInTheFourCellsRoundIt) {
  const mesh::PolygonMesh body = testing::grid(1.0, 0.125);
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 0.5}, {0.5, 0.5}}}, 0, {.tip_edges = 1});
  EXPECT_TRUE(testing::is_sound(mesh, body));
  const mesh::Polygon& tip = mesh.polygons[mesh.cracks[0].tip_polygon];
  EXPECT_EQ(tip.edge_count(), 8);
  EXPECT_DOUBLE_EQ(mesh::moments(mesh::closed_line(mesh, mesh.cracks[0].tip_polygon)).area, 4 * 0.125 * 0.125);
  EXPECT_EQ(mesh.cracks[0].lower.size(), 4u);
}

TEST(InsertCrack, OnePolygonBecomesOneOpenPolygon) {
  const mesh::PolygonMesh body = mesh::one_polygon(testing::rectangle(1, 2));
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 1}, {0.5, 1}}}, 0, {.tip_edges = 1});
  EXPECT_TRUE(testing::is_sound(mesh, body));
  ASSERT_EQ(mesh.polygons.size(), 1u);
  EXPECT_TRUE(mesh.polygons[0].open);
  EXPECT_EQ(mesh.polygons[0].vertices.front(), mesh.cracks[0].lower.front());
  EXPECT_EQ(mesh.polygons[0].vertices.back(), mesh.cracks[0].upper.front());
}

TEST(InsertCrack, InnerCrackInOnePolygonGivesTwoOpenPolygons) {
  const mesh::PolygonMesh body = mesh::one_polygon(testing::rectangle(1, 2));
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0.3, 1}, {0.7, 1}}, true}, 0);
  EXPECT_TRUE(testing::is_sound(mesh, body));
  EXPECT_EQ(mesh.polygons.size(), 2u);
  ASSERT_EQ(mesh.cracks.size(), 2u);
  EXPECT_EQ(testing::tip_of(mesh, 0), testing::Point(0.3, 1));
  EXPECT_EQ(testing::tip_of(mesh, 1), testing::Point(0.7, 1));
}

}  // namespace
}  // namespace sunder::crack
