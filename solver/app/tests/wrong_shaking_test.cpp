// What cannot be used of ground motion, time, water and rock: a clear message, exit status 2, nothing written.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "solver/app/tests/started_program.hpp"

namespace sunder::app {
namespace {

const char* const wall = R"(name = "wall"
analysis = "dynamic"
[geometry]
outline = [[0, 0], [3, 0], [2, 10], [0, 10]]
boundaries = { base = [0], downstream = [1], crest = [2], upstream = [3] }
[mesh]
size = 2.0
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2450
[[support]]
boundary = "base"
fix = ["x", "y"]
[reservoir]
boundary = "upstream"
level = 9
[ground_motion]
horizontal = "good.csv"
[dynamics]
time_step = 0.01
duration = 0.1
damping_modes = 1
)";

struct Wrong {
  const char* description;
  std::vector<const char*> changes;  ///< of the scene, key=value
  std::vector<const char*> said;
};
void PrintTo(const Wrong& wrong, std::ostream* out) {
  *out << wrong.description;
}

class WrongShaking : public testing::TestWithParam<Wrong> {};

void write_all(const TestFolder& folder) {
  static_cast<void>(folder.write("wall.toml", wall));
  static_cast<void>(folder.write("good.csv", "time,acceleration\n0,0\n0.01,1\n0.02,2\n0.03,1\n0.04,0\n"));
  static_cast<void>(folder.write("nan.csv", "0,0\n0.01,1\n0.02,nan\n0.03,0\n"));
  static_cast<void>(folder.write("ragged.csv", "0,0\n0.01\n0.02,0\n"));
  static_cast<void>(folder.write("gap.csv", "0,0\n0.01,1\n0.03,0\n"));
  static_cast<void>(folder.write("columns.csv", "time,horizontal,vertical\n0,0,0\n0.01,1,1\n"));
  static_cast<void>(folder.write("three.csv", "0,0\n0.01,1\n0.02,0\n"));
}

TEST_P(WrongShaking, IsRefusedWithItsReasonAndNothingWritten) {
  const Wrong& wrong = GetParam();
  const TestFolder folder;
  write_all(folder);
  const std::size_t before = folder.names().size();
  std::vector<std::string> words{"run", "wall.toml"};
  for (const char* change : wrong.changes) {
    words.emplace_back("--set");
    words.emplace_back(change);
  }
  EXPECT_EQ(wait_for(start(words, folder)), 2);
  const std::string said = folder.read("err.txt");
  for (const char* part : wrong.said) EXPECT_NE(said.find(part), std::string::npos) << said;
  EXPECT_EQ(folder.names().size(), before + 2) << "beside what was said nothing is written";
}

const Wrong wrong_shakings[] = {
    {"reflection above 1", {"reservoir.reflection_coefficient=1.01"}, {"reservoir.reflection_coefficient", "0 … 1"}},
    {"reflection below 0", {"reservoir.reflection_coefficient=-0.1"}, {"reservoir.reflection_coefficient", "0 … 1"}},
    {"level above the crest", {"reservoir.level=10.5"}, {"level", "10.5", "must be above the bottom"}},
    {"level below the base", {"reservoir.level=-1"}, {"level", "must be above the bottom"}},
    {"no sound speed", {"reservoir.sound_speed=0"}, {"reservoir.sound_speed: 0", "> 0"}},
    {"negative sound speed", {"reservoir.sound_speed=-1440"}, {"reservoir.sound_speed: -1440", "> 0"}},
    {"memory tolerance above a tenth", {"reservoir.memory_tolerance=0.2"}, {"reservoir.memory_tolerance", "0.1"}},
    {"no time step", {"dynamics.time_step=0"}, {"dynamics.time_step: 0", "> 0"}},
    {"negative time step", {"dynamics.time_step=-0.01"}, {"dynamics.time_step: -0.01", "> 0"}},
    {"time step longer than the record",
     {"dynamics.time_step=1", "dynamics.duration=2"},
     {"horizontal: lasts 0.04", "less than dynamics.time_step"}},
    {"unreadable record", {"ground_motion.horizontal=\".\""}, {"[ground_motion]", "there is no file \".\""}},
    {"missing record", {"ground_motion.horizontal=\"nowhere.csv\""}, {"there is no file \"nowhere.csv\""}},
    {"ragged record", {"ground_motion.horizontal=\"ragged.csv\""}, {"ragged.csv:2: has 1 column(s)"}},
    {"record with a gap", {"ground_motion.horizontal=\"gap.csv\""}, {"gap.csv:3: the time step changes"}},
    {"unknown column", {"ground_motion.horizontal=\"columns.csv\""}, {"columns.csv:2: has 3 column(s)"}},
    {"NaN sample", {"ground_motion.vertical=\"nan.csv\""}, {"nan.csv:3: acceleration: \"nan\" is not finite"}},
    {"baseline of three samples",
     {"ground_motion.horizontal=\"three.csv\"", "ground_motion.baseline=\"parabola\""},
     {"baseline", "three.csv", "at least 4"}},
    {"unknown baseline",
     {"ground_motion.baseline=\"line\""},
     {"ground_motion.baseline: \"line\"", "\"none\"", "\"parabola\""}},
    {"damping modes that are not there", {"dynamics.damping_modes=[1, 9999]"}, {"damping_modes", "no mode 9999"}},
    {"rock below a base that is supported",
     {"foundation.boundary=\"base\"", "foundation.youngs_modulus=25e9", "foundation.poisson_ratio=0.2",
      "foundation.density=2450"},
     {"base", "foundation", "support"}},
};
INSTANTIATE_TEST_SUITE_P(EndToEnd, WrongShaking, testing::ValuesIn(wrong_shakings));

TEST(EndToEnd, AShakenWallComesThrough) {
  const TestFolder folder;
  write_all(folder);
  EXPECT_EQ(wait_for(start({"run", "wall.toml", "--set", "ground_motion.baseline=\"parabola\"", "--set",
                            "reservoir.memory_tolerance=1e-4"},
                           folder)),
            0)
      << folder.read("err.txt");
  EXPECT_NE(folder.read("wall-results/summary.json").find("\"reservoir_memory_error\""), std::string::npos);
}

}  // namespace
}  // namespace sunder::app
