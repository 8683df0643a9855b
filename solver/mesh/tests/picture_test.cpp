#include "solver/mesh/picture.hpp"

#include <gtest/gtest.h>

#include "solver/mesh/sources.hpp"
#include "solver/mesh/tests/helpers.hpp"
#include "solver/mesh/triangulation.hpp"

namespace sunder::mesh {
namespace {

long count(const std::string& text, const std::string& part) {
  long n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Picture, ShowsEveryPolygonBoundaryNameAndCentre) {
  const std::string text = picture(square_grid(rectangle(3, 2), 1.0), {.title = "A <plate> & \"more\""});
  EXPECT_EQ(count(text, "Z"), 6);
  for (const char* name : {">bottom<", ">right<", ">top<", ">left<", ">6 polygons, 12 vertices<"})
    expect_words(text, name);
  EXPECT_EQ(count(text, "<circle"), 7);  // six centres and one in the legend
  expect_words(text, "A &lt;plate&gt; &amp; &quot;more&quot;");
  EXPECT_EQ(count(text, "<svg"), count(text, "</svg>"));
  EXPECT_EQ(count(text, "nan"), 0);
}

TEST(Picture, DrawsCrackFacesOfOpenPolygonsToTheTip) {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {0, 1}};
  mesh.polygons = {{.vertices = {4, 0, 1, 2, 3, 5}, .scaling_centre = {1, 1}, .open = true}};
  mesh.cracks = {{.lower = {4}, .upper = {5}, .tip_polygon = 0}};
  const NodalMesh nodes = place_nodes(mesh, [](int, int) { return 2; });
  const std::string text = picture(mesh, {.nodes = &nodes});
  expect_words(text, "crack faces");
  expect_words(text, "11 nodes");
  EXPECT_GE(count(text, "L200.00 200.00"), 3);  // the outline and both faces run to the tip, in the middle of the sheet
}

TEST(Picture, LeavesDotsOutWhereThereAreTooMany) {
  const PolygonMesh mesh = square_grid(rectangle(3, 2), 1.0);
  EXPECT_EQ(count(picture(mesh, {.most_dots = 5}), "<circle"), 0);
}

TEST(Picture, IsTheSameBytesForTheSameMesh) {
  const PolygonMesh mesh = dual_mesh(koyna(), {.size = {.size = 6.0}});
  EXPECT_EQ(picture(mesh), picture(mesh));
}

}  // namespace
}  // namespace sunder::mesh
