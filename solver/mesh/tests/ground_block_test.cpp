#include "solver/mesh/ground_block.hpp"

#include <gtest/gtest.h>

#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::mesh {
namespace {

constexpr GroundBlock block{.width = 20, .depth = 25, .size = 9, .material = 1};

/// append_block() ends with check_mesh(): with it the polygons cover dam and block exactly once.
TEST(GroundBlock, JoinsTheDualMeshOfADamVertexByVertex) {
  PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 8}});
  const std::size_t base_edges = mesh.boundaries.at("base").size(), polygons = mesh.polygons.size();
  double edges = 0.0;
  for (const Polygon& polygon : mesh.polygons) edges += polygon.edge_count();
  append_block(mesh, "base", block);
  EXPECT_NEAR(total_area(mesh), 3588.975 + 110.0 * 25.0, 1e-8) << "Koyna's section and 110 m x 25 m";
  EXPECT_EQ(mesh.boundaries.count("base"), 0u);
  EXPECT_NEAR(boundary_length(mesh, block_interface), 25.0 + 110.0 + 25.0, 1e-9);
  double edges_after = 0.0;
  for (std::size_t i = 0; i < polygons; ++i) edges_after += mesh.polygons[i].edge_count();
  EXPECT_EQ(edges_after, edges) << "the dam's " << base_edges << " base edges were kept whole";
  const std::vector<Edge>& line = mesh.boundaries.at(block_interface);
  EXPECT_EQ(mesh.vertices[line.front()[0]], Point(-20, 0));
  EXPECT_EQ(mesh.vertices[line.back()[1]], Point(90, 0));
  for (std::size_t i = 1; i < line.size(); ++i) EXPECT_EQ(line[i][0], line[i - 1][1]) << i;
}

TEST(GroundBlock, AddsTheVerticesThatOnlyOneSideHas) {
  for (const double size : {3.0, 40.0}) {
    PolygonMesh mesh = square_grid(rectangle(60, 30), 10);
    append_block(mesh, "bottom", {.width = 20, .depth = 25, .size = size, .material = 1});
    EXPECT_NEAR(total_area(mesh), 60.0 * 30.0 + 100.0 * 25.0, 1e-9);
  }
}

TEST(GroundBlock, RefusesWhatIsNotALevelBaseUnderTheBody) {
  const PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 20}});
  expect_words(mesh_error([&] { level_base(mesh, "upstream"); }), "is not level");
  expect_words(mesh_error([&] { level_base(mesh, "crest"); }), "lies above a part of the body");
  expect_words(mesh_error([&] { level_base(mesh, "heel"); }), "no boundary \"heel\"");
  PolygonMesh other = mesh;
  EXPECT_THROW(append_block(other, "base", {.width = 0, .depth = 25, .size = 9}), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::mesh
