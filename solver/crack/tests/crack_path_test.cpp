#include "solver/crack/crack_path.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "solver/crack/insert_crack.hpp"
#include "solver/crack/tests/crack_meshes.hpp"

namespace sunder::crack {
namespace {

struct BadPath {
  const char* description;
  CrackPath path;
  const char* says;
};

TEST(CheckPath, NamesWhatIsWrongWithThePath) {
  mesh::PolygonMesh mesh = testing::grid(8, 1);
  insert_crack(mesh, {{{0, 6.5}, {3.5, 6.5}}}, 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BadPath cases[] = {
      {"one point", {{{0, 4}}}, "has 1 points; at least 2"},
      {"not a number", {{{0, 4}, {nan, 4}}}, "no finite number"},
      {"a segment without length", {{{0, 4}, {1, 4}, {1, 4}}}, "must be longer than"},
      {"mouth outside", {{{-1, 4}, {2, 4}}}, "mouth (-1, 4) lies outside the body"},
      {"mouth below the base", {{{4, -0.5}, {4, 2}}}, "mouth (4, -0.5) lies outside the body"},
      {"mouth inside", {{{1, 4}, {2, 4}}}, "lies inside the body, 1 m from its boundary"},
      {"mouth on a corner", {{{8, 8}, {6, 5}}}, "lies on a corner"},
      {"mouth on another crack", {{{2, 6.5}, {2, 4}}}, "on a face of another crack"},
      {"leaves the body", {{{0, 4}, {9, 4}}}, "meets the boundary of the body at (8, 4)"},
      {"leaves and comes back", {{{0, 1}, {2, -1}, {4, 1}}}, "meets the boundary of the body at (1, 0)"},
      {"starts outwards", {{{0, 4}, {-1, 4}}}, "runs outside the body"},
      {"runs along the boundary", {{{0, 4}, {0, 2}}}, "meets the boundary of the body"},
      {"crosses itself", {{{0, 4}, {4, 4}, {4, 5}, {3, 3}}}, "must not cross itself"},
      {"turns back on itself", {{{0, 4}, {4, 4}, {2, 4}}}, "turns back on itself at (4, 4)"},
      {"crosses another crack", {{{2, 8}, {2, 4}}}, "meets crack 1 of the mesh at (2, 6.5)"},
      {"crosses another crack in its tip polygon", {{{3.4, 8}, {3.4, 4}}}, "meets crack 1 of the mesh"},
      {"tip on the boundary", {{{0, 4}, {8, 4}}}, "meets the boundary of the body at (8, 4)"},
      {"tip too near to a face", {{{0, 4}, {7.9999, 4}}}, "is 0.0001 m from a face; it must be more than 0.001 m"},
      {"inner crack with an end on the boundary", {{{0, 4}, {2, 4}}, true}, "meets the boundary"},
      {"inner crack outside", {{{9, 4}, {10, 4}}, true}, "runs outside the body"},
  };
  const mesh::PolygonMesh before = mesh;
  for (const BadPath& c : cases) {
    try {
      insert_crack(mesh, c.path, 1);
      ADD_FAILURE() << c.description << " was accepted";
    } catch (const CrackError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind("crack 2: ", 0), 0u) << what;
      EXPECT_NE(what.find(c.says), std::string::npos) << c.description << ": " << what;
    }
    EXPECT_EQ(mesh.vertices.size(), before.vertices.size()) << c.description;
    EXPECT_EQ(mesh.cracks.size(), before.cracks.size()) << c.description;
  }
}

TEST(CheckPath, AcceptsAMouthWithinRoundingOfASlantedFace) {
  const mesh::Outline wedge{.vertices = {{0, 0}, {70, 0}, {19.25, 66.5}, {14.8, 103}, {0, 103}}};
  mesh::PolygonMesh mesh = mesh::one_polygon(wedge);
  // On the downstream face to five decimals.
  EXPECT_NO_THROW(insert_crack(mesh, {{{44.62500, 33.25002}, {40, 33.25}}}, 0));
  EXPECT_NO_THROW(mesh::check_mesh(mesh));
}

}  // namespace
}  // namespace sunder::crack
