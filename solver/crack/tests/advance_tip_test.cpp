#include "solver/crack/advance_tip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/crack/insert_crack.hpp"
#include "solver/crack/tests/crack_meshes.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::crack {
namespace {

using testing::Point;

mesh::PolygonMesh cracked_grid(double x) {
  mesh::PolygonMesh mesh = testing::grid(10, 1);
  insert_crack(mesh, {{{0, 5.5}, {x, 5.5}}}, 0);
  return mesh;
}

TEST(AdvanceTip, LadderOfLengthsAndTurns) {
  for (const bool squares : {true, false}) {
    const mesh::PolygonMesh body = squares ? testing::grid(24, 1) : testing::brick_mesh(24, 24, 0.25, 2);
    mesh::PolygonMesh start = body;
    insert_crack(start, {{{0, 12.4}, {2.3, 12.5}}}, 0);
    const Point tip = testing::tip_of(start, 0);
    for (const double length : {1e-3, 1e-2, 0.1, 0.3, 1.0, 3.0, 10.0}) {
      for (const double degrees : {0.0, 1e-6, 0.1, 5.0, -20.0, 45.0, -70.0, 90.0}) {
        mesh::PolygonMesh mesh = start;
        const double angle = degrees * std::numbers::pi / 180 + std::atan2(0.1, 2.3);
        const Point to = tip + length * Point(std::cos(angle), std::sin(angle));
        const Advance a = advance_tip(mesh, 0, to);
        ASSERT_EQ(a.event, TipEvent::advanced) << length << " m, " << degrees << " degrees: " << a.reason;
        EXPECT_EQ(testing::tip_of(mesh, 0), to);
        EXPECT_EQ(a.tip, to);
        ASSERT_TRUE(testing::is_sound(mesh, body)) << length << " m, " << degrees << " degrees";
      }
    }
  }
}

TEST(AdvanceTip, LandsOnVerticesAndEdges) {
  const double e = 1e-12;
  for (const Point& to : {Point(4, 6), Point(4, 6 + e), Point(4 - e, 6 - e), Point(4, 5.5), Point(4 + e, 5.5),
                          Point(4 - e, 5.5), Point(3.5, 6), Point(3.5, 6 - e), Point(5, 5), Point(2.5 + 1, 5.5)}) {
    mesh::PolygonMesh mesh = cracked_grid(2.5);
    const Advance a = advance_tip(mesh, 0, to);
    ASSERT_EQ(a.event, TipEvent::advanced) << to.transpose() << ' ' << a.reason;
    EXPECT_TRUE(testing::is_sound(mesh, testing::grid(10, 1))) << to.transpose();
    EXPECT_EQ(testing::tip_of(mesh, 0), to);
  }
}

TEST(AdvanceTip, StraightGrowthInSmallStepsKeepsTheMeshAsIfCutAtOnce) {
  mesh::PolygonMesh mesh = cracked_grid(2.5);
  for (int i = 1; i <= 64; ++i) ASSERT_EQ(advance_tip(mesh, 0, {2.5 + i / 64.0 * 3.0, 5.5}).event, TipEvent::advanced);
  mesh::PolygonMesh at_once = testing::grid(10, 1);
  insert_crack(at_once, {{{0, 5.5}, {5.5, 5.5}}}, 0);
  // A straight crack has a pair where it crosses an edge and nowhere else. Behind a tip polygon of several cells there
  // are fewer edges to cross.
  EXPECT_LE(mesh.cracks[0].lower.size(), at_once.cracks[0].lower.size());
  EXPECT_TRUE(testing::is_sound(mesh, testing::grid(10, 1)));
}

TEST(AdvanceTip, ReachesTheFaceOfTheBody) {
  mesh::PolygonMesh mesh = cracked_grid(2.5);
  const Advance a = advance_tip(mesh, 0, {20, 5.5});
  EXPECT_EQ(a.event, TipEvent::reached_boundary);
  EXPECT_NEAR((a.tip - Point(10, 5.5)).norm(), 0.0, 1e-12);
  EXPECT_EQ(mesh.cracks[0].tip_polygon, -1);
  EXPECT_TRUE(testing::is_sound(mesh, testing::grid(10, 1)));
  EXPECT_EQ(advance_tip(mesh, 0, {20, 5.5}).event, TipEvent::refused);
  // The body is in two parts: the right boundary has a vertex for each of them at the end.
  EXPECT_NE(mesh.cracks[0].lower.back(), mesh.cracks[0].upper.back());
}

TEST(AdvanceTip, GoesOnToAFaceThatItEndsCloseTo) {
  mesh::PolygonMesh mesh = cracked_grid(8.5);
  EXPECT_EQ(advance_tip(mesh, 0, {9.95, 5.5}).event, TipEvent::reached_boundary);
  mesh = cracked_grid(8.5);
  EXPECT_EQ(advance_tip(mesh, 0, {9.5, 5.5}).event, TipEvent::advanced);
}

TEST(AdvanceTip, ReachesAnotherCrack) {
  for (const Point& to : {Point(2.5, 1.0), Point(4.3, 1.0), Point(4.45, 1.0)}) {
    mesh::PolygonMesh mesh = testing::grid(10, 1);
    insert_crack(mesh, {{{0, 5.5}, {4.5, 5.5}}}, 0);
    insert_crack(mesh, {{{to.x(), 10}, {to.x(), 7.5}}}, 1);
    const Advance a = advance_tip(mesh, 1, to);
    ASSERT_EQ(a.event, TipEvent::reached_crack) << to.transpose() << ' ' << a.reason;
    EXPECT_NEAR((a.tip - Point(to.x(), 5.5)).norm(), 0.0, 1e-12);
    EXPECT_TRUE(testing::is_sound(mesh, testing::grid(10, 1))) << to.transpose();
    EXPECT_GE(mesh.cracks[0].tip_polygon, 0);
    EXPECT_EQ(mesh.cracks[1].tip_polygon, -1);
    // The crack that was met can still grow.
    EXPECT_EQ(advance_tip(mesh, 0, {6.5, 5.5}).event, TipEvent::advanced);
    EXPECT_TRUE(testing::is_sound(mesh, testing::grid(10, 1)));
  }
}

TEST(AdvanceTip, PassesThroughThePolygonOfAnotherTip) {
  const mesh::PolygonMesh body = testing::grid(10, 1);
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 5.0}, {4.0, 5.0}}}, 0);
  insert_crack(mesh, {{{4.7, 10}, {4.7, 7.5}}}, 1);
  ASSERT_EQ(advance_tip(mesh, 1, {4.7, 2.5}).event, TipEvent::advanced);
  EXPECT_TRUE(testing::is_sound(mesh, body));
  EXPECT_EQ(testing::tip_of(mesh, 0), Point(4, 5));
}

TEST(AdvanceTip, RefusesWithAReasonAndLeavesTheMesh) {
  mesh::PolygonMesh mesh = cracked_grid(2.5);
  const mesh::PolygonMesh before = mesh;
  const double nan = std::nan("");
  for (const Point& to : {Point(1.0, 5.6), Point(2.5, 5.5), Point(nan, 5.5)}) {
    const Advance a = advance_tip(mesh, 0, to);
    EXPECT_EQ(a.event, TipEvent::refused);
    EXPECT_FALSE(a.reason.empty());
    EXPECT_EQ(a.tip, Point(2.5, 5.5));
    EXPECT_EQ(mesh.polygons.size(), before.polygons.size());
    EXPECT_EQ(mesh.vertices.size(), before.vertices.size());
  }
  EXPECT_THROW(static_cast<void>(advance_tip(mesh, 1, {3, 5.5})), std::invalid_argument);
}

TEST(AdvanceTip, BothTipsOfAnInnerCrack) {
  const mesh::PolygonMesh body = testing::brick_mesh(10, 10, 0.2, 4);
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{4.6, 5.3}, {5.3, 5.4}}, true}, 0);
  for (int i = 1; i <= 5; ++i) {
    ASSERT_EQ(advance_tip(mesh, 0, {4.6 - 0.5 * i, 5.3 - 0.1 * i}).event, TipEvent::advanced);
    ASSERT_EQ(advance_tip(mesh, 1, {5.3 + 0.5 * i, 5.4 + 0.2 * i}).event, TipEvent::advanced);
    ASSERT_TRUE(testing::is_sound(mesh, body)) << i;
  }
}

TEST(AdvanceTip, OrderOfTwoSeparateTipsDoesNotMatter) {
  const mesh::PolygonMesh body = testing::brick_mesh(12, 12, 0.2, 4);
  mesh::PolygonMesh a = body;
  insert_crack(a, {{{0, 5.4}, {2.3, 5.3}}}, 0);
  insert_crack(a, {{{12, 5.4}, {9.7, 5.3}}}, 1);
  mesh::PolygonMesh b = a;
  const Point left(3.1, 5.9), right(8.8, 4.6);
  ASSERT_EQ(advance_tip(a, 0, left).event, TipEvent::advanced);
  ASSERT_EQ(advance_tip(a, 1, right).event, TipEvent::advanced);
  ASSERT_EQ(advance_tip(b, 1, right).event, TipEvent::advanced);
  ASSERT_EQ(advance_tip(b, 0, left).event, TipEvent::advanced);
  const auto places = [](const mesh::PolygonMesh& mesh) {
    std::vector<std::vector<std::pair<double, double>>> all;
    for (const mesh::Polygon& p : mesh.polygons) {
      all.emplace_back();
      for (const int v : p.vertices) all.back().emplace_back(mesh.vertices[v].x(), mesh.vertices[v].y());
      std::sort(all.back().begin(), all.back().end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(places(a), places(b));
}

TEST(AdvanceTip, GrowsThroughTheKoynaSection) {
  // The dual mesh of the real section, a crack from the upstream face that turns down as it grows, in steps of a fifth
  // of a polygon; by the same steps from the break of the downstream face.
  const mesh::Outline outline{.vertices = {{0, 0}, {70, 0}, {19.25, 66.5}, {14.8, 103}, {0, 103}},
                              .boundaries = {{"base", {0}}, {"upstream", {4}}}};
  const mesh::PolygonMesh body = mesh::dual_mesh(outline, {.size = {.size = 2.4}, .paths = {{{0, 60}, {1, 60}}}});
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 60}, {1, 60}}}, 0);
  const Point downstream = Point(19.25, 66.5) + 0.003 * Point(50.75, -66.5);
  insert_crack(mesh, {{downstream, downstream - Point(1.2, 0.3)}}, 1);
  ASSERT_TRUE(testing::is_sound(mesh, body));
  for (int i = 0; i < 25; ++i) {
    const double angle = -0.025 * i;
    ASSERT_EQ(advance_tip(mesh, 0, testing::tip_of(mesh, 0) + 0.5 * Point(std::cos(angle), std::sin(angle))).event,
              TipEvent::advanced);
    ASSERT_EQ(advance_tip(mesh, 1, testing::tip_of(mesh, 1) + 0.4 * Point(-1, -0.1 + 0.01 * i)).event,
              TipEvent::advanced);
    ASSERT_TRUE(testing::is_sound(mesh, body)) << "step " << i;
  }
  EXPECT_GT(testing::tip_of(mesh, 0).x(), 12.0);
}

}  // namespace
}  // namespace sunder::crack
