#include "solver/mesh/msh_file.hpp"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "solver/mesh/tests/helpers.hpp"

namespace sunder::mesh {
namespace {

/// A file in a folder of its own, gone at the end of the test.
class MshFile : public ::testing::Test {
 protected:
  MshFile() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("sunder-mesh-") + test->name());
    std::filesystem::create_directories(folder_);
  }
  ~MshFile() override {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  std::filesystem::path write(const std::string& text) const {
    std::ofstream(file("body.msh"), std::ios::binary) << text;
    return file("body.msh");
  }
  std::string error(const std::string& text) const {
    const std::filesystem::path path = write(text);
    return mesh_error([&] { read_msh(path); });
  }

 private:
  std::filesystem::path folder_;
};

/// Two quadrilaterals, the second clockwise, and a triangle; physical curves "bottom" and, without a name, 7. The
/// nodes' numbers have gaps, one belongs to no cell.
const char* const version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 3 \"the bottom\"\n2 1 \"body\"\n$EndPhysicalNames\n"
    "$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 2 0 0\n10 0 1 0\n11 1 1 0\n12 2 1 0\n20 3 0 0\n99 50 50 0\n$EndNodes\n"
    "$Elements\n7\n1 15 2 0 1 1\n2 1 2 3 1 1 2\n3 1 2 3 1 2 3\n4 1 2 7 2 10 1\n5 3 2 1 1 1 2 11 10\n6 3 2 1 1 2 11 12 "
    "3\n"
    "7 2 2 1 1 3 20 12\n$EndElements\n";

TEST_F(MshFile, ReadsVersion2) {
  const PolygonMesh mesh = read_msh(write(version_2));
  EXPECT_EQ(mesh.vertices.size(), 7u);
  EXPECT_EQ(mesh.polygons.size(), 3u);
  EXPECT_DOUBLE_EQ(total_area(mesh), 2.5);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, "the bottom"), 2.0);
  EXPECT_EQ(mesh.boundaries.at("7").size(), 1u);
}

TEST_F(MshFile, FormsTheDual) {
  const PolygonMesh mesh = read_msh(write(version_2), {.dual = true});
  EXPECT_EQ(mesh.polygons.size(), 7u);
  EXPECT_DOUBLE_EQ(total_area(mesh), 2.5);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, "the bottom"), 2.0);
}

TEST_F(MshFile, ReadsWhatGmshWritesInBothVersionsAsTextAndBinary) {
  for (const bool recombined : {false, true}) {
    for (const double version : {2.2, 4.1}) {
      for (const int binary : {0, 1}) {
        const std::filesystem::path path = file("plate.msh");
        {
          gmsh::initialize(0, nullptr, false);
          gmsh::option::setNumber("General.Terminal", 0);
          namespace geo = gmsh::model::geo;
          const double xy[4][2] = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
          for (int i = 0; i < 4; ++i) geo::addPoint(xy[i][0], xy[i][1], 0, 0.4, i + 1);
          for (int i = 0; i < 4; ++i) geo::addLine(i + 1, (i + 1) % 4 + 1, i + 1);
          geo::addPlaneSurface({geo::addCurveLoop({1, 2, 3, 4})}, 1);
          geo::synchronize();
          gmsh::model::setPhysicalName(1, gmsh::model::addPhysicalGroup(1, {1}), "base");
          gmsh::model::addPhysicalGroup(1, {2, 3}, 40);
          gmsh::model::addPhysicalGroup(2, {1});
          gmsh::option::setNumber("Mesh.MshFileVersion", version);
          gmsh::option::setNumber("Mesh.Binary", binary);
          gmsh::option::setNumber("Mesh.RecombineAll", recombined ? 1 : 0);
          gmsh::model::mesh::generate(2);
          gmsh::write(path.string());
          gmsh::finalize();
        }
        SCOPED_TRACE(std::to_string(version) + (binary != 0 ? " binary" : " text") + (recombined ? " recombined" : ""));
        const PolygonMesh mesh = read_msh(path), dual = read_msh(path, {.dual = true});
        EXPECT_NEAR(total_area(mesh), 6.0, 1e-12);
        EXPECT_NEAR(total_area(dual), 6.0, 1e-12);
        EXPECT_EQ(dual.polygons.size(), mesh.vertices.size());
        EXPECT_NEAR(boundary_length(mesh, "base"), 3.0, 1e-12);
        EXPECT_NEAR(boundary_length(dual, "40"), 5.0, 1e-12);
        EXPECT_EQ(mesh.boundaries.size(), 2u);
      }
    }
  }
}

/// version_2 with one part replaced.
std::string with(const std::string& part, const std::string& other) {
  std::string text = version_2;
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

TEST_F(MshFile, RefusesWithFileLineAndReason) {
  const struct {
    const char* description;
    std::string text, words;
  } cases[] = {
      {"empty", "", "body.msh:1: the file is empty; a gmsh file of version 2.2 or 4.1 is accepted"},
      {"blank", "\n\n \n", "body.msh:4: the file is empty"},
      {"another format", "solid dam\n", "body.msh:1: the file starts with \"solid\", not with $MeshFormat"},
      {"version", with("2.2 0 8", "4 0 8"), "body.msh:2: version \"4\"; a gmsh file of version 2.2 or 4.1"},
      {"no number", with("10 0 1 0", "10 0 x 0"), "body.msh:14: \"x\" stands where a coordinate should"},
      {"NaN", with("10 0 1 0", "10 nan 1 0"), "body.msh:14: node 10 has a coordinate that is not finite"},
      {"cut off", std::string(version_2).substr(0, 150), "the file ends"},
      {"too few nodes", with("$Nodes\n8", "$Nodes\n9"),
       "body.msh:19: \"$EndNodes\" stands where a node's number should"},
      {"too many nodes", with("$Nodes\n8", "$Nodes\n7"), "body.msh:18: \"99\" stands where $EndNodes should"},
      {"absurd count", with("$Nodes\n8", "$Nodes\n99999999999"),
       "body.msh:10: 99999999999 is no possible number of nodes"},
      {"missing node", with("3 20 12\n", "3 21 12\n"), "body.msh:28: node 21 is not in $Nodes"},
      {"second order", with("7 2 2 1 1 3 20 12", "7 9 2 1 1 3 20 12 1 2 10"),
       "body.msh:28: element type 9; lines (1), triangles (2)"},
      {"node twice", with("99 50 50 0", "20 50 50 0"), "node 20 stands twice"},
      {"a tag without opposite", with("4 1 2 7 2 10 1", "4 1 2 -2147483648 2 10 1"), "is no physical number"},
      {"out of plane", with("20 3 0 0", "20 3 0 1"), "lie at z = 0 and 1; the mesh must lie in a plane"},
      {"line off the cells", with("4 1 2 7 2 10 1", "4 1 2 7 2 10 2"),
       "body.msh:25: the line from node 10 to 2 of the physical curve \"7\" is no edge"},
      {"flat cell", with("20 3 0 0", "20 2 0.5 0"), "polygon 2"},
      {"open name", with("\"the bottom\"", "\"the bottom"), "body.msh:6: a name without its closing quote"},
      {"no cells", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n",
       "no triangles or quadrilaterals"},
      {"no nodes", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "ends without $Nodes"},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(c.description);
    expect_words(error(c.text), c.words);
  }
}

TEST_F(MshFile, RefusesMissingFilesFoldersAndTooManyPolygons) {
  expect_words(mesh_error([&] { read_msh(file("none.msh")); }), "none.msh: there is no such file");
  expect_words(mesh_error([&] { read_msh(file("")); }), "not a file");
  const std::filesystem::path path = write(version_2);
  expect_words(mesh_error([&] { read_msh(path, {.max_polygons = 2}); }), "3 polygons exceed max_polygons = 2");
}

TEST_F(MshFile, RefusesABrokenBinaryFile) {
  std::string text = "$MeshFormat\n4.1 1 8\n";
  text += std::string("\1\0\0\0", 4) + "\n$EndMeshFormat\n$Nodes\n" + std::string(20, '\x7f');
  expect_words(error(text), "body.msh");
}

}  // namespace
}  // namespace sunder::mesh
