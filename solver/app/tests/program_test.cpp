// The commands with a solver put in its place: what is printed, written and returned.
#include "solver/app/program.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "solver/app/tests/folder.hpp"
#include "solver/crack/crack_path.hpp"
#include "solver/mesh/mesh_error.hpp"
#include "solver/scene/reference.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::app {
namespace {

results::RunSummary small_summary(const scene::Scene& scene, const simulation::RunOptions& options) {
  results::RunSummary summary;
  summary.name = scene.name;
  summary.analysis = "static";
  summary.mesh = {24, 70, 140};
  summary.quantities["strain_energy"] = 1234.5;
  summary.threads = options.threads;
  return summary;
}

Plan one_triangle(const scene::Scene&) {
  Plan plan;
  plan.polygons.vertices = {{0, 0}, {2, 0}, {0, 1}};
  plan.polygons.polygons = {{.vertices = {0, 1, 2}, .scaling_centre = {0.5, 0.3}}};
  plan.polygons.boundaries["base"] = {{0, 1}};
  plan.nodes = mesh::place_nodes(plan.polygons, [](int, int) { return 1; });
  return plan;
}

struct Outcome {
  int status;
  std::string out, err;
};

Outcome run(const std::vector<std::string>& words, const Solver& solver = {small_summary, one_triangle},
            bool terminal = false) {
  std::ostringstream out, err;
  const int status = program(words, {out, err, terminal}, solver);
  return {status, out.str(), err.str()};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Program, RunsASceneAndWritesItsSummary) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), results = (folder.path() / "a" / "b").string();
  const Outcome outcome = run({"run", scene, "--output", results, "--threads", "2"});
  EXPECT_EQ(outcome.status, completed) << outcome.err;
  const std::string summary = folder.read("a/b/summary.json");
  EXPECT_TRUE(holds(summary, "\"strain_energy\": 1234.5")) << summary;
  EXPECT_TRUE(holds(summary, "\"threads\": 2")) << summary;
  EXPECT_TRUE(holds(summary, "\"status\": \"completed\"")) << summary;
  EXPECT_TRUE(holds(outcome.out, "strain_energy  1234.5")) << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "24 polygons, 140 unknowns")) << outcome.out;
  EXPECT_EQ(folder.names().size(), 4u) << "the scene, two folders and the summary, nothing else";
}

/// `small_summary` with a course of time; where `sound` is false it holds a number that is none.
Solver with_history(bool sound) {
  const auto run = [sound](const scene::Scene& scene, const simulation::RunOptions& options) {
    results::RunSummary summary = small_summary(scene, options);
    summary.history = results::History({{"time", "s"}, {"front_position", "m"}});
    summary.history->add_row(std::vector{0.0, 0.5});
    summary.history->add_row(std::vector{0.25, sound ? 1.5 : std::nan("")});
    return summary;
  };
  return {run, one_triangle};
}

TEST(Program, WritesTheHistoryOfARunThatHasOne) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), results = (folder.path() / "a").string();
  ASSERT_EQ(run({"run", scene, "--output", results}, with_history(true)).status, completed);
  EXPECT_EQ(folder.read("a/history.csv"), "time [s],front_position [m]\n0,0.5\n0.25,1.5\n");
  EXPECT_FALSE(holds(folder.read("a/summary.json"), "history")) << "it stands in its own file";
  ASSERT_EQ(run({"run", scene, "--output", results}).status, completed);
  EXPECT_EQ(folder.names().size(), 3u) << "a later run without one leaves no history that is not its own";
}

TEST(Program, SaysWhereTheHistoryHoldsNoNumber) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), results = (folder.path() / "a").string();
  const Outcome outcome = run({"run", scene, "--output", results}, with_history(false));
  EXPECT_EQ(outcome.status, numbers_did_not_come_out);
  EXPECT_TRUE(holds(outcome.err, "history: front_position (row 2) is not a finite number")) << outcome.err;
  EXPECT_EQ(folder.read("a/history.csv"), "time [s],front_position [m]\n0,0.5\n0.25,\n") << "what was reached";
}

TEST(Program, WritesBesideTheCallerWhereNoFolderIsGiven) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Outcome outcome = run({"run", "block.toml", "--quiet"});
  std::filesystem::current_path(before);
  EXPECT_EQ(outcome.status, completed) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "") << "--quiet";
  EXPECT_TRUE(holds(folder.read("block-results/summary.json"), "\"name\": \"block\""));
}

TEST(Program, HandsOverridesToTheScene) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene);
  int order = 0;
  const Solver solver{[&](const scene::Scene& read, const simulation::RunOptions& options) {
                        order = read.mesh.order;
                        return small_summary(read, options);
                      },
                      one_triangle};
  const std::string results = (folder.path() / "out").string();
  EXPECT_EQ(run({"run", scene, "--output", results, "--set", "mesh.order=4", "--set", "name=\"other\""}, solver).status,
            completed);
  EXPECT_EQ(order, 4);
  EXPECT_TRUE(holds(folder.read("out/summary.json"), "\"name\": \"other\""));
  const Outcome wrong = run({"run", scene, "--output", results, "--set", "mesh.order"}, solver);
  EXPECT_EQ(wrong.status, unusable_input);
  EXPECT_TRUE(holds(wrong.err, "KEY=VALUE")) << wrong.err;
}

TEST(Program, SaysProgressInLinesElsewhereAndInABarOnATerminal) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), results = (folder.path() / "out").string();
  const Solver solver{[&](const scene::Scene& read, const simulation::RunOptions& options) {
                        options.progress("mesh", 0.0);
                        options.progress("factorising", 0.5);
                        options.progress("factorising", 0.501);
                        options.progress("factorising", 0.75);
                        return small_summary(read, options);
                      },
                      one_triangle};
  EXPECT_EQ(run({"run", scene, "--output", results}, solver).err, "mesh\nfactorising\n");
  const std::string bar = run({"run", scene, "--output", results}, solver, true).err;
  EXPECT_TRUE(holds(bar, "[###############...............] 50 % factorising\r")) << bar;
  EXPECT_TRUE(holds(bar, "[######################........] 75 % factorising\r")) << bar;
  EXPECT_EQ(bar.substr(bar.size() - 4), "\r\033[K") << "the bar is cleared at the end";
}

TEST(Program, ReturnsOneAndWritesWhatWasReachedWhereTheNumbersDoNotComeOut) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), results = (folder.path() / "out").string();
  const Solver stopped{[](const scene::Scene& read, const simulation::RunOptions& options) {
                         results::RunSummary summary = small_summary(read, options);
                         summary.status = "stopped: factorisation failed at row 7";
                         return summary;
                       },
                       one_triangle};
  const Outcome outcome = run({"run", scene, "--output", results}, stopped);
  EXPECT_EQ(outcome.status, numbers_did_not_come_out);
  EXPECT_TRUE(holds(outcome.err, "stopped: factorisation failed at row 7")) << outcome.err;
  EXPECT_TRUE(holds(folder.read("out/summary.json"), "\"status\": \"stopped: factorisation failed at row 7\""));

  const Solver not_a_number{[](const scene::Scene& read, const simulation::RunOptions& options) {
                              results::RunSummary summary = small_summary(read, options);
                              summary.quantities["K_I"] = std::nan("");
                              return summary;
                            },
                            one_triangle};
  const Outcome nan = run({"run", scene, "--output", results}, not_a_number);
  EXPECT_EQ(nan.status, numbers_did_not_come_out);
  EXPECT_TRUE(holds(nan.err, "warning: K_I is not a finite number")) << nan.err;
  EXPECT_TRUE(holds(folder.read("out/summary.json"), "\"status\": \"stopped: K_I is not a finite number\""));
}

struct Thrown {
  const char* description;
  std::function<void()> raise;
  int status;
  std::string message;
};

TEST(Program, TellsWhatTheSolverThrowsAtItsTable) {
  const TestFolder folder;
  const std::string text =
      std::string(block_scene) + "[[crack]]\npath = [[2, 1], [1, 1]]\n[[crack]]\npath = [[2, 2], [1, 2]]\n";
  const std::string scene = folder.write("block.toml", text), results = (folder.path() / "out").string();
  const Thrown cases[] = {
      {"outline", [] { throw mesh::MeshError("edges 0 and 2 cross at (1, 1)"); }, unusable_input,
       scene + ":3: [geometry] edges 0 and 2 cross at (1, 1)\n"},
      {"second crack", [] { throw crack::CrackError("crack 2: the tip (1, 2) is outside"); }, unusable_input,
       scene + ":19: [[crack]] crack 2: the tip (1, 2) is outside\n"},
      {"path of the second crack", [] { throw mesh::MeshError("path 1 from (2, 2) to (1, 2) meets edge 0"); },
       unusable_input, scene + ":19: [[crack]] crack 2 from (2, 2) to (1, 2) meets edge 0\n"},
      {"sizes", [] { throw mesh::MeshError("more than max_polygons = 5"); }, unusable_input,
       scene + ":6: [mesh] more than max_polygons = 5\n"},
      {"scene", [] { throw scene::SceneError("x:1:1: y"); }, unusable_input, "x:1:1: y\n"},
      {"argument", [] { throw std::invalid_argument("order: 0"); }, unusable_input, "sunder: order: 0\n"},
      {"memory", [] { throw std::bad_alloc(); }, numbers_did_not_come_out, "sunder: not enough memory\n"},
      {"other", [] { throw std::runtime_error("?"); }, numbers_did_not_come_out, "sunder: ?\n"},
  };
  for (const Thrown& one : cases) {
    const Solver solver{[&](const scene::Scene&, const simulation::RunOptions&) -> results::RunSummary {
                          one.raise();
                          return {};
                        },
                        one_triangle};
    const Outcome outcome = run({"run", scene, "--output", results}, solver);
    EXPECT_EQ(outcome.status, one.status) << one.description;
    EXPECT_EQ(outcome.err, one.message) << one.description;
    EXPECT_EQ(outcome.out, "") << one.description;
    EXPECT_FALSE(std::filesystem::exists(results)) << one.description << ": nothing is written on refusal";
  }
}

TEST(Program, RefusesAFolderThatCannotBeWrittenBeforeTheRun) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), taken = folder.write("taken", "a file");
  bool ran = false;
  const Solver solver{[&](const scene::Scene& read, const simulation::RunOptions& options) {
                        ran = true;
                        return small_summary(read, options);
                      },
                      one_triangle};
  const Outcome outcome = run({"run", scene, "--output", taken + "/results"}, solver);
  EXPECT_EQ(outcome.status, unusable_input);
  EXPECT_TRUE(holds(outcome.err, "cannot write results")) << outcome.err;
  EXPECT_FALSE(ran);
}

TEST(Program, ChecksASceneWithoutRunningIt) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene), picture = (folder.path() / "mesh.svg").string();
  const Solver solver{nullptr, one_triangle};
  const Outcome outcome = run({"check", scene, "--picture", picture}, solver);
  EXPECT_EQ(outcome.status, completed) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "1 polygons, 3 nodes, 6 unknowns")) << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "1 support, 1 load")) << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "21 entries in the lower triangle")) << "6 unknowns, all coupled: " << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "base: 1 edges")) << outcome.out;
  const std::string svg = folder.read("mesh.svg");
  EXPECT_TRUE(holds(svg, "<svg ")) << svg;
  EXPECT_TRUE(holds(svg, "block")) << "the scene's name: " << svg;
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(Program, ChecksTheRecordsThatASceneNames) {
  const TestFolder folder;
  const std::string shaken = R"(name = "shaken"
analysis = "dynamic"
[geometry]
outline = [[0, 0], [2, 0], [2, 3], [0, 3]]
boundaries = { base = [0] }
[mesh]
size = 0.5
[material]
youngs_modulus = 25e9
poisson_ratio = 0.2
density = 2400
[[support]]
boundary = "base"
fix = ["x", "y"]
[ground_motion]
horizontal = "shaking.csv"
horizontal_scale = -2.0
[dynamics]
time_step = 0.01
duration = 1.0
)";
  const std::string scene = folder.write("shaken.toml", shaken);
  const Solver solver{nullptr, one_triangle};
  folder.write("shaking.csv", "0,0\n0.01,1.5\n0.02,-0.5\n");
  const Outcome good = run({"check", scene}, solver);
  EXPECT_EQ(good.status, completed) << good.err;
  EXPECT_TRUE(holds(good.out, "horizontal  3 samples, 0 ... 0.02 s, peak 3 m/s2")) << good.out;
  folder.write("shaking.csv", "0,0\n0.01,nan\n");
  const Outcome bad = run({"check", scene}, solver);
  EXPECT_EQ(bad.status, unusable_input);
  EXPECT_TRUE(holds(bad.err, "shaking.csv:2: acceleration: \"nan\" is not finite")) << bad.err;
}

TEST(Program, PrintsEveryKey) {
  const Outcome text = run({"keys"}), markdown = run({"keys", "--markdown"});
  EXPECT_EQ(text.status, completed);
  EXPECT_EQ(markdown.out, scene::reference_markdown());
  for (const scene::TableReference& table : scene::reference()) {
    EXPECT_TRUE(holds(text.out, table.heading)) << table.heading;
    for (const scene::KeyReference& key : table.keys) EXPECT_TRUE(holds(text.out, "  " + key.name + " = ")) << key.name;
  }
}

TEST(Program, AnswersHelpVersionAndWrongLines) {
  EXPECT_EQ(run({"--version"}).status, completed);
  EXPECT_EQ(run({"--version"}).out.substr(0, 7), "sunder ");
  EXPECT_EQ(run({"--help"}).status, completed);
  EXPECT_TRUE(holds(run({"--help"}).out, "Exit status: 0 completed"));
  EXPECT_TRUE(holds(run({"run", "--help"}).out, "--output DIR"));
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"walk"},
                                                       {"run"},
                                                       {"run", "a.toml", "b.toml"},
                                                       {"run", "a.toml", "--threads", "0"},
                                                       {"run", "a.toml", "--fast"}};
  for (const std::vector<std::string>& words : wrong) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, unusable_input) << (words.empty() ? "nothing" : words.back());
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
  const Outcome missing = run({"run", "no such scene.toml"});
  EXPECT_EQ(missing.status, unusable_input);
  EXPECT_TRUE(holds(missing.err, "no such scene.toml: cannot be opened")) << missing.err;
}

/// Runs a solver that waits to be stopped in a process of its own, sends it `signal`, and returns its exit status.
int status_after(int signal, const TestFolder& folder, const std::string& scene) {
  int ready[2];
  if (::pipe(ready) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    const Solver patient{[&](const scene::Scene& read, const simulation::RunOptions& options) {
                           results::RunSummary summary = small_summary(read, options);
                           const char byte = 'r';
                           if (::write(ready[1], &byte, 1) != 1) ::_exit(99);
                           for (int i = 0; i < 10000 && !options.stop->load(); ++i) ::usleep(1000);
                           if (options.stop->load()) summary.status = "stopped: interrupted after step 3";
                           return summary;
                         },
                         one_triangle};
    std::ostringstream out, err;
    const std::vector<std::string> words = {"run", scene, "--output", (folder.path() / "out").string()};
    ::_exit(program(words, {out, err, false}, patient));
  }
  char byte = 0;
  const bool started = ::read(ready[0], &byte, 1) == 1;
  ::close(ready[0]);
  ::close(ready[1]);
  if (!started || ::kill(child, signal) != 0) return -1;
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Program, WritesWhatWasReachedOnCtrlC) {
  const TestFolder folder;
  const std::string scene = folder.write("block.toml", block_scene);
  EXPECT_EQ(status_after(SIGINT, folder, scene), 130);
  EXPECT_TRUE(holds(folder.read("out/summary.json"), "\"status\": \"stopped: interrupted after step 3\""));
  EXPECT_TRUE(holds(folder.read("out/summary.json"), "\"strain_energy\": 1234.5"));
  EXPECT_EQ(status_after(SIGTERM, folder, scene), 143);
}

}  // namespace
}  // namespace sunder::app
