#include "solver/mesh/divide.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::mesh {
namespace {

TEST(Divide, LongEdgesOfAllPolygonsAndBoundaries) {
  PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 8.0}});
  const std::size_t before = mesh.vertices.size();
  divide_long_edges(mesh, {.size = 1.0});
  check_mesh(mesh);
  EXPECT_GT(mesh.vertices.size(), before);
  for (const Polygon& p : mesh.polygons) {
    for (int e = 0; e < p.edge_count(); ++e) {
      EXPECT_LE((mesh.vertices[p.edge(e)[1]] - mesh.vertices[p.edge(e)[0]]).norm(), 1.0 + 1e-9);
    }
  }
  EXPECT_NEAR(boundary_length(mesh, "base"), 70.0, 1e-11);
  EXPECT_NEAR(total_area(mesh) / moments(koyna().vertices).area, 1.0, 1e-12);
}

TEST(Divide, RefusesMorePiecesThanAPolygonCanBear) {
  PolygonMesh mesh = square_grid(rectangle(3, 3), 1.0);
  for (const double size : {9e-5, 1e-12, 1e-300}) {
    const std::string words = mesh_error([&] { divide_long_edges(mesh, {.size = size}); });
    EXPECT_NE(words.find("pieces; accepted: at most 10000"), std::string::npos) << size << ": " << words;
  }
  EXPECT_EQ(mesh.vertices.size(), 16u);
}

TEST(Divide, OnePolygonGetsItsEdgesAndItsNeighboursList) {
  PolygonMesh mesh = square_grid(rectangle(3, 3), 1.0);
  divide_polygon(mesh, 4, 16);
  check_mesh(mesh);
  EXPECT_EQ(mesh.polygons[4].edge_count(), 16);
  for (const int side : {1, 3, 5, 7}) EXPECT_EQ(mesh.polygons[side].edge_count(), 7);
  EXPECT_EQ(mesh.polygons[0].edge_count(), 4);
  divide_polygon(mesh, 4, 10);  // it has them already
  EXPECT_EQ(mesh.polygons[4].edge_count(), 16);
  EXPECT_THROW(divide_polygon(mesh, 9, 10), std::invalid_argument);
}

/// Two squares above two others, a crack from the left between the first two, its tip in the middle of an open polygon.
PolygonMesh cracked() {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {3, 0}, {3, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 1}, {1, 1}, {1, 1}};
  // 6, 8 on the lower face, 7, 9 on the upper
  mesh.polygons = {{.vertices = {0, 1, 8, 6}, .scaling_centre = {0.5, 0.5}},
                   {.vertices = {7, 9, 4, 5}, .scaling_centre = {0.5, 1.5}},
                   {.vertices = {8, 1, 2, 3, 4, 9}, .scaling_centre = {2, 1}, .open = true}};
  mesh.cracks = {{.lower = {6, 8}, .upper = {7, 9}, .tip_polygon = 2}};
  mesh.boundaries = {{"left", {{5, 7}, {6, 0}}}};
  return mesh;
}

TEST(Divide, CrackFacesStayPairedWhicheverFaceAsks) {
  check_mesh(cracked());
  for (const int polygon : {0, 1}) {
    PolygonMesh mesh = cracked();
    divide_polygon(mesh, polygon, 12);
    check_mesh(mesh);
    ASSERT_EQ(mesh.cracks[0].lower.size(), mesh.cracks[0].upper.size());
    EXPECT_EQ(mesh.cracks[0].lower.size(), 4u);
    for (std::size_t i = 0; i < mesh.cracks[0].lower.size(); ++i) {
      EXPECT_EQ(mesh.vertices[mesh.cracks[0].lower[i]], mesh.vertices[mesh.cracks[0].upper[i]]);
    }
  }
}

TEST(Divide, AnOpenPolygonKeepsItsEnds) {
  PolygonMesh mesh = cracked();
  divide_polygon(mesh, 2, 20);
  check_mesh(mesh);
  EXPECT_EQ(mesh.polygons[2].edge_count(), 20);
  EXPECT_EQ(mesh.polygons[2].vertices.front(), 8);
  EXPECT_EQ(mesh.polygons[2].vertices.back(), 9);
}

TEST(Divide, RefusesFractionsOutOfOrder) {
  PolygonMesh mesh = cracked();
  EXPECT_THROW(divide_edges(mesh,
                            [](const Point&, const Point&) {
                              return std::vector<double>{0.5, 0.5};
                            }),
               std::invalid_argument);
  EXPECT_THROW(divide_edges(mesh, [](const Point&, const Point&) { return std::vector<double>{1.0}; }),
               std::invalid_argument);
}

}  // namespace
}  // namespace sunder::mesh
