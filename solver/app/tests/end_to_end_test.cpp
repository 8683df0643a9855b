// The program itself, started as a person starts it: every wrong scene is refused with its reason, status 2 and nothing
// written; sound ones come through.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "solver/app/tests/started_program.hpp"

namespace sunder::app {
namespace {

/// `block_scene` with its first `from` replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = block_scene;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

struct Wrong {
  const char* description;
  const char *from, *to;  ///< what is changed in a sound scene
  std::vector<const char*> said;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.description;
}

class WrongScene : public testing::TestWithParam<Wrong> {};

TEST_P(WrongScene, IsRefusedWithItsReasonAndNothingWritten) {
  const Wrong& wrong = GetParam();
  const TestFolder folder;
  static_cast<void>(folder.write("block.toml", changed(wrong.from, wrong.to)));
  static_cast<void>(folder.write("empty.msh",
                                 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n0\n"
                                 "$EndElements\n"));
  const std::size_t before = folder.names().size();
  for (const char* command : {"run", "check"}) {
    EXPECT_EQ(wait_for(start({command, "block.toml"}, folder)), 2) << command;
    const std::string said = folder.read("err.txt");
    EXPECT_NE(("\n" + said).find("\nblock.toml:"), std::string::npos) << command << " said: " << said;
    for (const char* part : wrong.said) EXPECT_NE(said.find(part), std::string::npos) << command << " said: " << said;
    EXPECT_EQ(folder.read("out.txt"), "");
  }
  EXPECT_EQ(folder.names().size(), before + 2) << "beside what was said nothing is written";
}

const char* const square = "[[0, 0], [2, 0], [2, 3], [0, 3]]";
const Wrong wrong_scenes[] = {
    {"bad TOML", "size = 0.5", "size = 0.5.1", {"block.toml:7:11: not TOML"}},
    {"misspelt key", "size = 0.5", "siez = 0.5", {"block.toml:7:1: mesh.siez", "did you mean `size`?"}},
    {"negative size", "size = 0.5", "size = -0.5", {"block.toml:7:8: mesh.size: -0.5", "accepted: a number > 0 [m]"}},
    {"NaN", "size = 0.5", "size = nan", {"block.toml:7:8: mesh.size: nan is not a finite number"}},
    {"crack outside the body",
     "[material]",
     "[[crack]]\npath = [[5, 1], [4, 1]]\n[material]",
     {"block.toml:8: [[crack]] crack 1", "(5, 1)"}},
    {"crack that leaves the body",
     "[material]",
     "[[crack]]\npath = [[2, 1], [-1, 1]]\n[material]",
     {"block.toml:8: [[crack]] crack 1"}},
    {"self-crossing outline",
     square,
     "[[0, 0], [2, 0], [0, 3], [2, 3], [1, 5]]",
     {"block.toml:3: [geometry] edge", "meets edge", "may not touch or cross"}},
    {"boundary without support", "fix = [\"x\", \"y\"]", "fix = [\"y\"]", {"a translation in x free"}},
    {"no support", "[[support]]\nboundary = \"base\"\nfix = [\"x\", \"y\"]\n", "", {"[[support]]: is missing"}},
    {"nu = 0.5",
     "poisson_ratio = 0.2",
     "poisson_ratio = 0.5",
     {"block.toml:10:17", "0.5 is not accepted", ">= 0, < 0.5"}},
    {"missing mesh file",
     "[geometry]\noutline = [[0, 0], [2, 0], [2, 3], [0, 3]]\nboundaries = { base = [0], crest = [2] }\n[mesh]\nsize = "
     "0.5",
     "[mesh]\nfile = \"dam.msh\"",
     {"block.toml:4:8: mesh.file", "dam.msh"}},
    {"empty mesh",
     "[geometry]\noutline = [[0, 0], [2, 0], [2, 3], [0, 3]]\nboundaries = { base = [0], crest = [2] }\n[mesh]\nsize = "
     "0.5",
     "[mesh]\nfile = \"empty.msh\"",
     {"block.toml:3: [mesh] empty.msh:", "no triangles or quadrilaterals"}},
    {"empty outline", square, "[]", {"geometry.outline: has 0 points"}},
    {"too many polygons",
     "size = 0.5",
     "size = 0.5\nmax_polygons = 5",
     {"block.toml:6: [mesh]", "more than max_polygons = 5"}},
};
INSTANTIATE_TEST_SUITE_P(EndToEnd, WrongScene, testing::ValuesIn(wrong_scenes));

TEST(EndToEnd, ASoundSceneComesThrough) {
  const TestFolder folder;
  static_cast<void>(folder.write("block.toml", block_scene));
  EXPECT_EQ(wait_for(start({"run", "block.toml"}, folder)), 0) << folder.read("err.txt");
  const std::string summary = folder.read("block-results/summary.json");
  EXPECT_NE(summary.find("\"status\": \"completed\""), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"strain_energy\""), std::string::npos) << summary;
  EXPECT_EQ(wait_for(start({"check", "block.toml", "--picture", "block.svg"}, folder)), 0) << folder.read("err.txt");
  EXPECT_NE(folder.read("block.svg").find("<svg "), std::string::npos);
}

TEST(EndToEnd, ABodyThatIsOnePolygonComesThrough) {
  const TestFolder folder;
  static_cast<void>(folder.write("block.toml", block_scene));
  EXPECT_EQ(wait_for(start({"run", "block.toml", "--set", "mesh.cells=\"one\"", "--set", "mesh.order=4"}, folder)), 0)
      << folder.read("err.txt");
  EXPECT_NE(folder.read("block-results/summary.json").find("\"polygons\": 1"), std::string::npos);
}

TEST(EndToEnd, FieldsAreTheSameBytesForOneAndTwoThreads) {
  const TestFolder folder;
  static_cast<void>(folder.write("block.toml", block_scene));
  for (const char* threads : {"1", "2"}) {
    EXPECT_EQ(wait_for(start({"run", "block.toml", "--set", "output.fields_every=1", "--threads", threads, "--output",
                              std::string("with-") + threads},
                             folder)),
              0)
        << folder.read("err.txt");
  }
  const std::string one = folder.read("with-1/results.h5");
  EXPECT_FALSE(one.empty());
  EXPECT_TRUE(one == folder.read("with-2/results.h5"));
  ASSERT_EQ(wait_for(start({"run", "block.toml", "--output", "with-1"}, folder)), 0) << folder.read("err.txt");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "with-1/results.h5"))
      << "fields of an earlier run are not its own";
}

TEST(EndToEnd, CtrlCLeavesAWholeSummaryOrNone) {
  const TestFolder folder;
  static_cast<void>(folder.write("block.toml", block_scene));
  const pid_t child = start({"run", "block.toml", "--set", "mesh.size=0.03"}, folder);
  // The first word of progress says that the run has begun and listens.
  for (int i = 0; i < 10000 && folder.read("err.txt").empty(); ++i) ::usleep(1000);
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const int status = wait_for(child);
  const std::string summary = folder.read("block-results/summary.json");
  if (status == 0) {  // it had finished before it could notice
    EXPECT_NE(summary.find("\"status\": \"completed\""), std::string::npos) << summary;
  } else {
    EXPECT_EQ(status, 130) << folder.read("err.txt");
    EXPECT_NE(summary.find("\"status\": \"stopped: "), std::string::npos) << summary;
  }
  ASSERT_FALSE(summary.empty());
  EXPECT_EQ(summary.substr(summary.size() - 3), "\n}\n") << "whole";
}

}  // namespace
}  // namespace sunder::app
