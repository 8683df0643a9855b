#include "solver/mesh/sources.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

TEST(SquareGrid, CoversTheRectangleAndNamesItsSides) {
  const PolygonMesh mesh = square_grid(rectangle(3, 2), 0.5);
  EXPECT_EQ(mesh.polygons.size(), 24u);
  EXPECT_EQ(mesh.vertices.size(), 35u);
  EXPECT_NEAR(total_area(mesh), 6.0, 6e-15);  // round-off of 24 sums
  EXPECT_EQ(mesh.boundaries.at("bottom").size(), 6u);
  EXPECT_EQ(mesh.boundaries.at("left").size(), 4u);
  for (const Edge& e : mesh.boundaries.at("right")) EXPECT_EQ(mesh.vertices[e[0]].x(), 3.0);
}

TEST(SquareGrid, TakesATurnedRectangleThatStartsAnywhereWithExtraVertices) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto turned = [&](double x, double y) { return Point(5 + c * x - s * y, -7 + s * x + c * y); };
  const Outline outline{.vertices = {turned(2, 0), turned(4, 0), turned(4, 3), turned(0, 3), turned(0, 0)},

                        .boundaries = {{"half", {0}}, {"other half", {4}}, {"top", {2}}}};
  const PolygonMesh mesh = square_grid(outline, 1.0);
  EXPECT_EQ(mesh.polygons.size(), 12u);
  EXPECT_NEAR(boundary_length(mesh, "half"), 2.0, 1e-13);  // coordinates of size 10
  EXPECT_NEAR(boundary_length(mesh, "other half"), 2.0, 1e-13);
  EXPECT_NEAR(boundary_length(mesh, "top"), 4.0, 1e-13);
}

TEST(SquareGrid, RefusesOtherShapesAndTooManySquares) {
  expect_words(mesh_error([] { square_grid(koyna(), 5.0); }), "right angle");
  expect_words(mesh_error([] { square_grid(rectangle(1, 1), 1e-3, 1000); }), "max_polygons = 1000");
  Outline odd = rectangle(1, 1);
  odd.vertices.insert(odd.vertices.begin() + 1, Point(0.3, 0));
  expect_words(mesh_error([&] { square_grid(odd, 0.5); }), "(0.3, 0)");
  EXPECT_THROW(square_grid(rectangle(1, 1), 0.0), std::invalid_argument);
}

TEST(OnePolygon, DividesEdgesNoLongerThanTheSize) {
  const PolygonMesh mesh = one_polygon(rectangle(3, 1), {.size = 0.4});
  ASSERT_EQ(mesh.polygons.size(), 1u);
  EXPECT_EQ(mesh.boundaries.at("bottom").size(), 8u);  // ⌈3 / 0.4⌉
  EXPECT_EQ(mesh.boundaries.at("left").size(), 3u);
  EXPECT_NEAR((mesh.polygons[0].scaling_centre - Point(1.5, 0.5)).norm(), 0.0, 1e-15);
  EXPECT_EQ(one_polygon(rectangle(3, 1)).polygons[0].edge_count(), 4);
}

TEST(OnePolygon, GradesTowardsARefinementLikeAGeometricSeries) {
  const SizeField field{.size = 1.0, .refinements = {{.centre = {0, 0}, .radius = 1e-6, .size = 1e-6}}, .growth = 1.0};
  const PolygonMesh mesh = one_polygon(rectangle(1, 1), field);
  const auto& bottom = mesh.boundaries.at("bottom");
  // ∫ ds / size = 1 + ln(1 / 1e-6) = 14.8
  EXPECT_EQ(bottom.size(), 15u);
  const auto length = [&](std::size_t i) { return (mesh.vertices[bottom[i][1]] - mesh.vertices[bottom[i][0]]).norm(); };
  EXPECT_LE(length(0), 1.01e-6);
  for (std::size_t i = 3; i < bottom.size(); ++i) {
    // size = distance there, so every piece is e^(14.8 / 15) times the one before
    EXPECT_NEAR(length(i) / length(i - 1), std::exp((1.0 + std::log(1e6)) / 15.0), 0.05);
  }
  EXPECT_EQ(mesh.boundaries.at("top").size(), 1u);
}

TEST(OnePolygon, LayersTowardsACorner) {
  const PolygonMesh mesh = one_polygon(rectangle(2, 1), {.size = 1.0}, {{.corner = {0, 0}, .layers = 3, .ratio = 0.1}});
  const auto& bottom = mesh.boundaries.at("bottom");
  ASSERT_EQ(bottom.size(), 5u);
  EXPECT_NEAR(mesh.vertices[bottom[0][1]].x(), 1e-3, 1e-18);
  EXPECT_NEAR(mesh.vertices[bottom[1][1]].x(), 1e-2, 1e-17);
  EXPECT_EQ(mesh.boundaries.at("right").size(), 1u);
  EXPECT_EQ(mesh.boundaries.at("left").size(), 4u);
  expect_words(mesh_error([] {
                 one_polygon(rectangle(2, 1), {}, {{.corner = {1, 0}, .layers = 1}});
               }),
               "not a vertex of the outline");
}

TEST(OnePolygon, RefusesWhatIsNotStarShaped) {
  const Outline comb{.vertices = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}};
  const std::string message = mesh_error([&] { one_polygon(comb); });
  expect_words(message, "polygon 0");
  expect_words(message, "not star-shaped");
}

TEST(ListedPolygons, KeepsNumbersAndTurnsNamedEdges) {
  const PolygonMesh mesh = listed_polygons({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}},
                                           {{0, 1, 2, 3}, {1, 4, 5, 2}}, {{"left", {{0, 3}}}, {"right", {{4, 5}}}});
  EXPECT_EQ(mesh.polygons.size(), 2u);
  EXPECT_EQ(mesh.boundaries.at("left")[0], (Edge{3, 0}));
  EXPECT_EQ(mesh.boundaries.at("right")[0], (Edge{4, 5}));
}

TEST(ListedPolygons, AllowsAVertexInTheMiddleOfASideThatListsIt) {
  const PolygonMesh mesh = listed_polygons({{0, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}, {2, 0}, {2, 0.5}, {2, 1}},
                                           {{0, 1, 2, 3, 4}, {1, 5, 6, 2}, {2, 6, 7, 3}}, {});
  EXPECT_NEAR(total_area(mesh), 2.0, 1e-15);
}

}  // namespace
}  // namespace sunder::mesh
