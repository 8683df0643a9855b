#include "solver/crack/insert_crack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "solver/crack/tests/crack_meshes.hpp"

namespace sunder::crack {
namespace {

using testing::Point;

const mesh::Polygon& tip_polygon(const mesh::PolygonMesh& mesh, int crack = 0) {
  return mesh.polygons[mesh.cracks[crack].tip_polygon];
}

TEST(InsertCrack, TipAtAGridVertexTakesInTheFourCellsRoundIt) {
  const mesh::PolygonMesh body = testing::grid(1.0, 0.125);
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 0.5}, {0.5, 0.5}}}, 0, {.tip_edges = 1});
  EXPECT_TRUE(testing::is_sound(mesh, body));
  EXPECT_EQ(tip_polygon(mesh).edge_count(), 8);
  EXPECT_DOUBLE_EQ(mesh::moments(mesh::closed_line(mesh, mesh.cracks[0].tip_polygon)).area, 4 * 0.125 * 0.125);
  EXPECT_EQ(mesh.cracks[0].lower.size(), 4u);
}

struct TipCase {
  const char* description;
  Point tip;
  double tip_area;  // in cells
};

TEST(InsertCrack, TakesInThePolygonsThatTheTipIsNearTo) {
  const double h = 0.125;
  const TipCase cases[] = {
      {"at a vertex", {4 * h, 4 * h}, 4},
      {"1e-12 of a cell above the vertex", {4 * h, (4 + 1e-12) * h}, 4},
      {"1e-12 of a cell before the vertex", {(4 - 1e-12) * h, 4 * h}, 4},
      {"1e-12 of a cell behind the vertex", {(4 + 1e-12) * h, (4 - 1e-12) * h}, 4},
      {"on an edge along the crack", {4.5 * h, 4 * h}, 2},
      {"1e-12 of a cell beside that edge", {4.5 * h, (4 - 1e-12) * h}, 2},
      {"on an edge across the crack", {4 * h, 4.5 * h}, 2},
      {"1e-12 of a cell before that edge", {(4 - 1e-12) * h, 4.5 * h}, 2},
      {"1e-12 of a cell behind that edge", {(4 + 1e-12) * h, 4.5 * h}, 2},
      {"in the middle of a cell", {4.5 * h, 4.5 * h}, 1},
  };
  for (const TipCase& c : cases) {
    const mesh::PolygonMesh body = testing::grid(1.0, h);
    mesh::PolygonMesh mesh = body;
    insert_crack(mesh, {{{0, c.tip.y()}, c.tip}}, 0);
    EXPECT_TRUE(testing::is_sound(mesh, body)) << c.description;
    EXPECT_EQ(testing::tip_of(mesh, 0), c.tip) << c.description;
    const double area = mesh::moments(mesh::closed_line(mesh, mesh.cracks[0].tip_polygon)).area;
    // Vertices within the snapping distance are moved onto the path: 1e-12 of a cell here.
    EXPECT_NEAR(area / (h * h), c.tip_area, 1e-10) << c.description;
    EXPECT_GE(tip_polygon(mesh).edge_count(), 16) << c.description;
  }
}

TEST(InsertCrack, OnePolygonBecomesOneOpenPolygonFromTheLowerMouthToTheUpper) {
  const mesh::PolygonMesh body = mesh::one_polygon(testing::rectangle(1, 2));
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 1}, {0.5, 1}}}, 0, {.tip_edges = 1});
  EXPECT_TRUE(testing::is_sound(mesh, body));
  ASSERT_EQ(mesh.polygons.size(), 1u);
  const mesh::Polygon& p = mesh.polygons[0];
  EXPECT_TRUE(p.open);
  EXPECT_EQ(p.vertices.front(), mesh.cracks[0].lower.front());
  EXPECT_EQ(p.vertices.back(), mesh.cracks[0].upper.front());
  // Counter-clockwise from the lower mouth: the lower left corner comes first, the upper left one last.
  EXPECT_EQ(mesh.vertices[p.vertices[1]], Point(0, 0));
  EXPECT_EQ(mesh.vertices[p.vertices[p.vertices.size() - 2]], Point(0, 2));
}

TEST(InsertCrack, KeepsBothHalvesOfTheMouthsEdgeInItsBoundary) {
  mesh::PolygonMesh mesh = mesh::one_polygon(testing::rectangle(1, 2));
  insert_crack(mesh, {{{0, 1}, {0.5, 1}}}, 0, {.tip_edges = 1});
  const std::vector<mesh::Edge>& left = mesh.boundaries.at("left");
  const int lower = mesh.cracks[0].lower[0], upper = mesh.cracks[0].upper[0];
  EXPECT_EQ(std::count_if(left.begin(), left.end(), [&](const mesh::Edge& e) { return e[0] == lower; }), 1);
  EXPECT_EQ(std::count_if(left.begin(), left.end(), [&](const mesh::Edge& e) { return e[1] == upper; }), 1);
}

TEST(InsertCrack, InnerCrackInOnePolygonGivesTwoOpenPolygons) {
  for (const double angle : {0.0, 45.0, 80.0}) {
    const mesh::PolygonMesh body = mesh::one_polygon(testing::rectangle(1, 2));
    mesh::PolygonMesh mesh = body;
    const Point half = 0.25 * Point(std::cos(angle * std::numbers::pi / 180), std::sin(angle * std::numbers::pi / 180));
    const Point middle(0.5, 1);
    insert_crack(mesh, {{middle - half, middle + half}, true}, 0);
    EXPECT_TRUE(testing::is_sound(mesh, body)) << angle;
    EXPECT_EQ(mesh.polygons.size(), 2u) << angle;
    ASSERT_EQ(mesh.cracks.size(), 2u);
    EXPECT_EQ(testing::tip_of(mesh, 0), Point(middle - half));
    EXPECT_EQ(testing::tip_of(mesh, 1), Point(middle + half));
    // The pair in the middle belongs to both, with the sides exchanged: the tips look in opposite directions.
    EXPECT_EQ(mesh.cracks[0].lower[0], mesh.cracks[1].upper[0]);
    EXPECT_EQ(mesh.cracks[0].upper[0], mesh.cracks[1].lower[0]);
  }
}

TEST(InsertCrack, InnerCrackInAMeshOfAnyFineness) {
  for (const double length : {0.05, 0.5, 1.0, 3.0, 6.0}) {
    for (const double angle : {0.0, 0.3, 0.785398, 1.4}) {
      for (const Point& middle : {Point(5, 5), Point(5.5, 5.5), Point(4.9, 5.2), Point(5, 5.5)}) {
        for (const bool squares : {true, false}) {
          const mesh::PolygonMesh body = squares ? testing::grid(10, 1) : testing::brick_mesh(10, 10, 0.2, 3);
          mesh::PolygonMesh mesh = body;
          const Point half = 0.5 * length * Point(std::cos(angle), std::sin(angle));
          insert_crack(mesh, {{middle - half, middle + half}, true}, 0);
          ASSERT_TRUE(testing::is_sound(mesh, body)) << length << ' ' << angle << " at " << middle.transpose();
          EXPECT_EQ(testing::tip_of(mesh, 0), Point(middle - half));
        }
      }
    }
  }
}

TEST(InsertCrack, KinkedPaths) {
  struct Case {
    const char* description;
    std::vector<Point> path;
  };
  const Case cases[] = {
      {"kink inside a polygon", {{0, 5.5}, {2.5, 5.5}, {4.4, 6.6}}},
      {"two kinks inside one polygon", {{0, 5.5}, {2.3, 5.5}, {2.6, 5.7}, {4.4, 5.6}}},
      {"kink and tip in one polygon", {{0, 5.5}, {2.3, 5.5}, {2.6, 5.8}}},
      {"kink by 90 degrees", {{0, 5.5}, {2.5, 5.5}, {2.5, 7.6}}},
      {"kink by 120 degrees", {{0, 5.5}, {2.5, 5.5}, {2.0, 6.4}}},
      {"kink at a vertex", {{0, 5}, {3, 5}, {5.5, 7.5}}},
      {"through vertices", {{0, 2}, {6.5, 8.5}}},
      {"along edges and round a vertex", {{0, 5}, {3, 5}, {3, 8}}},
      {"1e-12 of a polygon from edges and vertices", {{0, 5 + 1e-12}, {3, 5 - 1e-12}, {3 + 1e-12, 8}}},
      {"back over its own start", {{0, 5.5}, {3.5, 5.5}, {3.5, 7.2}, {1.5, 7.2}}},
      {"first kink close to the mouth", {{0, 5.5}, {0.01, 5.5}, {1.5, 6.2}}},
      {"zigzag of 1e-2 steps", {{0, 5.5}, {2.4, 5.5}, {2.41, 5.505}, {2.42, 5.5}, {2.43, 5.505}}},
  };
  for (const Case& c : cases) {
    for (const bool squares : {true, false}) {
      const mesh::PolygonMesh body = squares ? testing::grid(10, 1) : testing::brick_mesh(10, 10, 0.25, 11);
      mesh::PolygonMesh mesh = body;
      ASSERT_NO_THROW(insert_crack(mesh, {c.path}, 0)) << c.description;
      EXPECT_TRUE(testing::is_sound(mesh, body)) << c.description;
      EXPECT_EQ(testing::tip_of(mesh, 0), c.path.back()) << c.description;
      // The path is kept: every kink is a pair of the faces, and the faces with the tip are as long as the path.
      double path = 0.0, faces = 0.0;
      for (std::size_t i = 0; i + 1 < c.path.size(); ++i) path += (c.path[i + 1] - c.path[i]).norm();
      const std::vector<int>& lower = mesh.cracks[0].lower;
      for (std::size_t i = 0; i + 1 < lower.size(); ++i)
        faces += (mesh.vertices[lower[i + 1]] - mesh.vertices[lower[i]]).norm();
      faces += (testing::tip_of(mesh, 0) - mesh.vertices[lower.back()]).norm();
      EXPECT_NEAR(faces, path, 1e-9 * path) << c.description;
    }
  }
}

TEST(InsertCrack, KinkInTheOnePolygon) {
  const mesh::PolygonMesh body = mesh::one_polygon(testing::rectangle(1, 2));
  mesh::PolygonMesh mesh = body;
  insert_crack(mesh, {{{0, 1}, {0.3, 1}, {0.5, 1.2}}}, 0);
  EXPECT_TRUE(testing::is_sound(mesh, body));
  EXPECT_EQ(mesh.cracks[0].lower.size(), 2u);
}

TEST(InsertCrack, LeavesUntouchedPolygonsBitForBit) {
  const mesh::PolygonMesh body = testing::brick_mesh(10, 10, 0.2, 5);
  mesh::PolygonMesh mesh = body;
  const CutReport report = insert_crack(mesh, {{{0, 5.4}, {2.3, 5.3}}}, 0);
  ASSERT_EQ(report.polygon_from.size(), mesh.polygons.size());
  ASSERT_EQ(report.vertex_from.size(), mesh.vertices.size());
  int kept = 0;
  for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
    const int from = report.polygon_from[p];
    EXPECT_EQ(from < 0, std::binary_search(report.changed.begin(), report.changed.end(), static_cast<int>(p)));
    if (from < 0) continue;
    ++kept;
    EXPECT_EQ(mesh.polygons[p].scaling_centre, body.polygons[from].scaling_centre);
    ASSERT_EQ(mesh.polygons[p].vertices.size(), body.polygons[from].vertices.size());
    for (std::size_t k = 0; k < mesh.polygons[p].vertices.size(); ++k) {
      EXPECT_EQ(mesh.vertices[mesh.polygons[p].vertices[k]], body.vertices[body.polygons[from].vertices[k]]);
    }
  }
  // The path runs through three polygons of a row; they and their neighbours are at most 12.
  EXPECT_GE(kept, static_cast<int>(body.polygons.size()) - 12);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (report.vertex_from[v] >= 0) {
      EXPECT_EQ(mesh.vertices[v], body.vertices[report.vertex_from[v]]);
    }
  }
}

/// The polygons as sorted lists of places: the same for meshes that differ in numbering only.
std::vector<std::vector<std::pair<double, double>>> places(const mesh::PolygonMesh& mesh) {
  std::vector<std::vector<std::pair<double, double>>> all;
  for (const mesh::Polygon& p : mesh.polygons) {
    std::vector<std::pair<double, double>> one;
    for (const int v : p.vertices) one.emplace_back(mesh.vertices[v].x(), mesh.vertices[v].y());
    std::sort(one.begin(), one.end());
    all.push_back(one);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(InsertCrack, OrderOfTwoSeparateCracksDoesNotMatter) {
  const mesh::PolygonMesh body = testing::brick_mesh(10, 10, 0.2, 5);
  const CrackPath left{{{0, 5.4}, {2.3, 5.3}}}, right{{{10, 3.3}, {7.2, 4.1}}};
  mesh::PolygonMesh a = body, b = body;
  insert_crack(a, left, 0);
  insert_crack(a, right, 1);
  insert_crack(b, right, 1);
  insert_crack(b, left, 0);
  EXPECT_TRUE(testing::is_sound(a, body));
  EXPECT_EQ(places(a), places(b));
}

mesh::PolygonMesh mapped(mesh::PolygonMesh mesh, const std::function<Point(const Point&)>& map) {
  for (Point& p : mesh.vertices) p = map(p);
  for (mesh::Polygon& p : mesh.polygons) p.scaling_centre = map(p.scaling_centre);
  return mesh;
}

TEST(InsertCrack, SameTopologyInAnyUnitPlaceAndDirection) {
  const mesh::PolygonMesh body = testing::brick_mesh(10, 10, 0.2, 5);
  const std::vector<Point> path{{0, 5.4}, {2.3, 5.3}, {4.6, 6.2}};
  mesh::PolygonMesh reference = body;
  insert_crack(reference, {path}, 0);
  const auto rotation = [](double angle) {
    return [angle](const Point& p) {
      return Point(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                   std::sin(angle) * p.x() + std::cos(angle) * p.y());
    };
  };
  struct Case {
    const char* description;
    std::function<Point(const Point&)> map;
  };
  const Case cases[] = {
      {"millimetres", [](const Point& p) { return Point(1e3 * p); }},
      {"kilometres", [](const Point& p) { return Point(1e-3 * p); }},
      {"a shift of 1e6 m", [](const Point& p) { return Point(p + Point(1e6, -1e6)); }},
      {"turned by 0.1", rotation(0.1)},
      {"turned by 1", rotation(1.0)},
      {"turned by 2.5", rotation(2.5)},
      {"turned by -1.9", rotation(-1.9)},
  };
  for (const Case& c : cases) {
    const mesh::PolygonMesh before = mapped(body, c.map);
    mesh::PolygonMesh mesh = before;
    std::vector<Point> there;
    for (const Point& p : path) there.push_back(c.map(p));
    ASSERT_NO_THROW(insert_crack(mesh, {there}, 0)) << c.description;
    EXPECT_NO_THROW(mesh::check_mesh(mesh)) << c.description;
    ASSERT_EQ(mesh.polygons.size(), reference.polygons.size()) << c.description;
    for (std::size_t p = 0; p < mesh.polygons.size(); ++p) {
      EXPECT_EQ(mesh.polygons[p].vertices, reference.polygons[p].vertices) << c.description;
    }
    EXPECT_EQ(mesh.cracks[0].lower, reference.cracks[0].lower) << c.description;
  }
}

TEST(InsertCrack, DoesNotJoinAcrossAMaterialInterface) {
  mesh::PolygonMesh body = testing::grid(8, 1);
  for (mesh::Polygon& p : body.polygons) p.material = p.scaling_centre.x() > 4.0;
  // Tip close to the interface on either side of it: the tip polygon stays in its material.
  for (const double x : {3.95, 4.05}) {
    mesh::PolygonMesh mesh = body;
    insert_crack(mesh, {{{0, 4.5}, {x, 4.5}}}, 0);
    EXPECT_TRUE(testing::is_sound(mesh, body));
    double soft = 0.0;
    for (int p = 0; p < static_cast<int>(mesh.polygons.size()); ++p) {
      if (mesh.polygons[p].material == 1) soft += mesh::moments(mesh::closed_line(mesh, p)).area;
    }
    EXPECT_NEAR(soft, 32.0, 1e-12) << x;
  }
}

}  // namespace
}  // namespace sunder::crack
