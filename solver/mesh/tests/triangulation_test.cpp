#include "solver/mesh/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/dual.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

int vertex_at(const PolygonMesh& mesh, const Point& x) {
  const auto at = std::find(mesh.vertices.begin(), mesh.vertices.end(), x);
  return at == mesh.vertices.end() ? -1 : static_cast<int>(at - mesh.vertices.begin());
}

double perimeter(const PolygonMesh& mesh) {
  double length = 0.0;
  for (const auto& [name, edges] : mesh.boundaries) length += boundary_length(mesh, name);
  return length;
}

TEST(DualMesh, OfTheKoynaSectionHasThePolygonsAndNodesOfTheSeedPaper) {
  const PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 2.4}});
  // The paper has 718 polygons and 1668 nodes, crack included; 10 % either way.
  EXPECT_NEAR(static_cast<double>(mesh.polygons.size()), 718.0, 71.8);
  EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 1668.0, 166.8);
}

struct BodyCase {
  const char* description;
  Outline outline;
  TriangulationOptions options;
  double estimate = 0.2;  ///< how far the estimated number of vertices may be off
};

std::vector<BodyCase> bodies() {
  Outline plate = rectangle(10, 6);
  plate.holes = {{{2, 2}, {3, 2}, {3, 3}, {2, 3}}, {{7, 4}, {6, 3}, {7, 2}, {8, 3}}};  // one of each sense
  plate.boundaries["hole"] = {4, 5, 6, 7};
  plate.boundaries["diamond"] = {8, 9, 10, 11};
  return {{"Koyna", koyna(), {.size = {.size = 4.0}}},
          {"plate with two holes", plate, {.size = {.size = 0.5}}},
          {"refined hundredfold", rectangle(1, 1), {.size = {.size = 0.2, .refinements = {{{0.3, 0.4}, 0.01, 0.002}}}}},
          {"one element thick", rectangle(100, 1), {.size = {.size = 1.5}}, 0.4},
          {"crack path",
           koyna(),
           {.size = {.size = 5.0, .lines = {{{{0, 60}, {4, 58}}, 1.0, 0.5}}}, .paths = {{{0, 60}, {3, 60}, {4, 58}}}}}};
}

TEST(DualMesh, CoversBodyAndBoundariesExactly) {
  for (const BodyCase& body : bodies()) {
    const PolygonMesh mesh = dual_mesh(body.outline, body.options);
    double area = moments(body.outline.vertices).area, length = 0.0;
    for (const auto& hole : body.outline.holes) area -= std::abs(moments(hole).area);
    EXPECT_NEAR(total_area(mesh) / area, 1.0, 1e-12) << body.description;
    for (const auto& [name, edges] : body.outline.boundaries) {
      double expected = 0.0;
      for (const int e : edges) expected += (body.outline.edge(e)[1] - body.outline.edge(e)[0]).norm();
      EXPECT_NEAR(boundary_length(mesh, name) / expected, 1.0, 1e-12) << body.description << ", " << name;
      length += expected;
    }
    EXPECT_NEAR(perimeter(mesh) / length, 1.0, 1e-12) << body.description;
    for (const Point& corner : body.outline.vertices) EXPECT_GE(vertex_at(mesh, corner), 0) << body.description;
  }
}

TEST(DualMesh, SeesEveryPolygonWellFromItsCentre) {
  for (const BodyCase& body : bodies()) {
    const PolygonMesh mesh = dual_mesh(body.outline, body.options);
    for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
      // A hexagon has 0.95, a square 0.87; less than 0.2 would be a poor polygon, though a sound one.
      EXPECT_GT(clearance(closed_line(mesh, i), mesh.polygons[i].scaling_centre), 0.2) << body.description << ", " << i;
    }
  }
}

TEST(DualMesh, HasAboutTwoNodesAPolygonAndHexagonsInside) {
  const PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 1.5}});
  const double ratio = static_cast<double>(mesh.vertices.size()) / static_cast<double>(mesh.polygons.size());
  EXPECT_GT(ratio, 2.0);  // Euler: two triangles a vertex
  EXPECT_LT(ratio, 2.3);
  long hexagons = 0;
  for (const Polygon& p : mesh.polygons) hexagons += p.vertices.size() == 6 ? 1 : 0;
  EXPECT_GT(static_cast<double>(hexagons), 0.6 * static_cast<double>(mesh.polygons.size()));
}

TEST(DualMesh, OfTwoTrianglesIsFourPolygonsOfEqualArea) {
  PolygonMesh square;
  square.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.polygons = {{.vertices = {0, 1, 2}}, {.vertices = {0, 2, 3}}};
  square.boundaries = {{"bottom", {{0, 1}}}};
  const PolygonMesh mesh = dual(square);
  ASSERT_EQ(mesh.polygons.size(), 4u);
  // Each triangle gives a third of its area to each of its vertices.
  const double area[] = {1.0 / 3.0, 1.0 / 6.0, 1.0 / 3.0, 1.0 / 6.0};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(moments(closed_line(mesh, i)).area, area[i], 1e-15);
  EXPECT_EQ(mesh.boundaries.at("bottom").size(), 2u);
  check_mesh(mesh);
}

TEST(DualMesh, OfQuadrilateralsIsTheShiftedGrid) {
  const PolygonMesh grid = square_grid(rectangle(4, 3), 1.0), mesh = dual(grid);
  check_mesh(mesh);
  ASSERT_EQ(mesh.polygons.size(), grid.vertices.size());
  EXPECT_NEAR(moments(closed_line(mesh, 6)).area, 1.0, 1e-15);   // an inner vertex
  EXPECT_NEAR(moments(closed_line(mesh, 0)).area, 0.25, 1e-15);  // a corner
}

TEST(DualMesh, CutsPolygonsAtSharpReEntrantCorners) {
  // A notch of half a degree, seen from its tip over 359.5 degrees.
  const Outline notched{.vertices = {{0, 0}, {4, 0}, {4, 4}, {2.01, 4}, {2, 1.7}, {1.99, 4}, {0, 4}}};
  const PolygonMesh triangles = triangulate(notched, {.size = {.size = 0.8}}), mesh = dual(triangles);
  check_mesh(mesh);
  EXPECT_GT(mesh.polygons.size(), triangles.vertices.size());
  EXPECT_LT(mesh.polygons.size(), triangles.vertices.size() + 4);
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    EXPECT_GT(clearance(closed_line(mesh, i), mesh.polygons[i].scaling_centre), 0.05) << i;
  }
  EXPECT_NEAR(total_area(mesh) / moments(notched.vertices).area, 1.0, 1e-12);
}

TEST(DualMesh, SaysWhatHelpsWhereCellsAreTooFlat) {
  // Round vertex 0, a corner of 340°, two triangles of 170° with a short edge between: their centroids lie more than
  // half a turn apart.
  const double angle = 170.0 * std::numbers::pi / 180.0;
  PolygonMesh flat;
  flat.vertices = {{0, 0}, {std::cos(angle), -std::sin(angle)}, {0.1, 0}, {std::cos(angle), std::sin(angle)}};
  flat.polygons = {{.vertices = {0, 1, 2}}, {.vertices = {0, 2, 3}}};
  const std::string message = mesh_error([&] { dual(flat); });
  expect_words(message, "at (0, 0)");
  expect_words(message, "too flat, smaller ones help");
}

TEST(DualMesh, RefusesABodyThatHangsTogetherInOnePoint) {
  PolygonMesh bow;
  bow.vertices = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}};
  bow.polygons = {{.vertices = {0, 1, 2}}, {.vertices = {2, 3, 4}}};
  expect_words(mesh_error([&] { dual(bow); }), "vertex 2 at (1, 1) joins parts of the body that touch only there");
}

TEST(Triangulation, FollowsAPathWithMouthKinkAndTip) {
  const std::vector<Point> path{{0, 60}, {3, 60}, {4, 58}};
  const PolygonMesh mesh = triangulate(koyna(), {.size = {.size = 5.0, .lines = {{path, 1.0, 0.5}}}, .paths = {path}});
  for (const Point& p : path) EXPECT_GE(vertex_at(mesh, p), 0) << p.transpose();
  long along = 0;
  for (const Point& v : mesh.vertices) along += std::abs(v.y() - 60.0) < 1e-13 && v.x() > 0 && v.x() < 3 ? 1 : 0;
  EXPECT_EQ(along, 5);  // six edges of half a metre on the first three metres
}

TEST(Triangulation, MeetsTwoPathsInAPointAndKeepsSinglePoints) {
  const PolygonMesh mesh =
      triangulate(rectangle(4, 4), {.size = {.size = 0.7},
                                    .paths = {{{0, 2}, {2, 2}}, {{2, 2}, {3, 3}}, {{2, 2}, {3, 1}}},
                                    .points = {{1, 1}, {4, 0.3}, {2, 2}}});
  for (const Point& p : {Point(2, 2), Point(3, 3), Point(3, 1), Point(1, 1), Point(4, 0.3)}) {
    EXPECT_EQ(std::count(mesh.vertices.begin(), mesh.vertices.end(), p), 1) << p.transpose();
  }
  check_mesh(mesh);
}

TEST(Triangulation, IsTheSameFromRunToRun) {
  const PolygonMesh a = triangulate(koyna(), {.size = {.size = 3.0}}),
                    b = triangulate(koyna(), {.size = {.size = 3.0}});
  EXPECT_EQ(a.vertices, b.vertices);
  ASSERT_EQ(a.polygons.size(), b.polygons.size());
  for (std::size_t i = 0; i < a.polygons.size(); ++i) EXPECT_EQ(a.polygons[i].vertices, b.polygons[i].vertices);
}

TEST(Triangulation, IsTheSameInEveryUnitAndPlace) {
  const auto count = [](double unit, const Point& shift) {
    Outline outline = koyna();
    for (Point& p : outline.vertices) p = unit * p + shift;
    const PolygonMesh mesh = dual_mesh(outline, {.size = {.size = 2.4 * unit}});
    EXPECT_NEAR(total_area(mesh) / moments(outline.vertices).area, 1.0, 1e-12 + 1e-15 * shift.norm() / unit);
    return static_cast<double>(mesh.polygons.size());
  };
  const double here = count(1.0, {0, 0});
  // Powers of two give the same bits, other units and shifts round the corners: a few vertices may fall otherwise.
  EXPECT_EQ(count(0.0009765625, {0, 0}), here);
  for (const double unit : {1e-3, 1e3}) EXPECT_NEAR(count(unit, {0, 0}), here, 0.02 * here) << unit;
  EXPECT_NEAR(count(1.0, {1e6, -1e6}), here, 0.02 * here);
}

TEST(Triangulation, EstimatesItsVertices) {
  for (const BodyCase& body : bodies()) {
    const double vertices = static_cast<double>(triangulate(body.outline, body.options).vertices.size());
    EXPECT_NEAR(estimated_vertices(body.outline, body.options.size) / vertices, 1.0, body.estimate) << body.description;
  }
}

TEST(Triangulation, EstimatesAPointRefinedTenBillionfold) {
  // Sizes growing at rate g from a point: ∫ 2 / (√3 h²) dA ≈ 2π · 2/√3 / g² · ln(r g / h0) = 1.5e3 for r = 1/2, h0 =
  // 1e-10, up to the size's offset at the point and the square's corners.
  const SizeField size{.size = 1.0, .refinements = {{{0.5, 0.5}, 0.0, 1e-10}}};
  const double expected = 4.0 * std::numbers::pi / std::numbers::sqrt3 / (0.3 * 0.3) * std::log(0.5 * 0.3 / 1e-10);
  EXPECT_NEAR(estimated_vertices(rectangle(1, 1), size) / expected, 1.0, 0.2);
}

TEST(Triangulation, RefusesTooManyPolygonsBeforeMeshing) {
  const std::string message = mesh_error([] { dual_mesh(koyna(), {.size = {.size = 1e-6}}); });
  expect_words(message, "polygons are to be expected");
  expect_words(message, "max_polygons = 2000000");
  expect_words(mesh_error([] {
                 dual_mesh(koyna(), {.size = {.size = 50.0, .refinements = {{{10, 10}, 5.0, 1e-5}}}});
               }),
               "max_polygons");
}

TEST(Triangulation, RefusesPathsThatDoNotFitTheBody) {
  const auto message = [](std::vector<std::vector<Point>> paths) {
    return mesh_error([&] { triangulate(rectangle(4, 4), {.size = {.size = 1.0}, .paths = std::move(paths)}); });
  };
  expect_words(message({{{5, 1}, {6, 1}}}), "path 0: point 0 at (5, 1) lies outside the body");
  expect_words(message({{{3, 1}, {5, 1}}}), "point 1 at (5, 1) lies outside");
  expect_words(message({{{0, 1}}}), "at least 2 are needed");
  expect_words(message({{{1, 1}, {3, 1}}, {{2, 0}, {2, 2}}}), "paths may share end points only");
  expect_words(message({{{1, 0}, {3, 0}}}), "only its ends may lie on the outline");
  expect_words(message({{{1, 1}, {1, 1}, {2, 1}}}), "repeats its point at (1, 1)");
  expect_words(message({{{1, 1}, {std::nan(""), 1}}}), "nan");
  EXPECT_THROW(triangulate(rectangle(4, 4), {.size = {.size = -1.0}}), std::invalid_argument);
}

TEST(TriangleMesh, TakesTheTrianglesThemselves) {
  const PolygonMesh mesh = triangle_mesh(koyna(), {.size = {.size = 5.0}});
  EXPECT_NEAR(total_area(mesh) / moments(koyna().vertices).area, 1.0, 1e-12);
  for (const Polygon& p : mesh.polygons) EXPECT_EQ(p.vertices.size(), 3u);
}

}  // namespace
}  // namespace sunder::mesh
