/// The price list of a shaken dam: Koyna's section, ten seconds in steps of 10 ms, with one part more in each line,
/// from the bare dam to all of model 3 on rock. What a part adds to a step and what a growth event costs, in CPU time
/// of one thread.
///
/// A run's answer is checked before its time is reported: the energy account closes, faces overlap by no more than the
/// gate where contact holds them, the crack grows where it may, and the crest of the bare dam moves as modal
/// superposition of other elements says.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "benchmarks/scene_runs.hpp"
#include "solver/scene/reader.hpp"
#include "solver/simulation/run.hpp"

namespace {

using namespace sunder;
using benchmarks::number;
using benchmarks::put_on_rock;

/// What stands in a line of the list.
struct Parts {
  bool water = false, crack = false, contact = false, water_in_crack = false, moves = false, growth = false,
       rock = false;
};

scene::Scene dam_with(const Parts& parts) {
  scene::Scene scene = scene::read_scene(std::string(SUNDER_CASES) + "/koyna/model-3.scene.toml", {});
  scene.output.reset();
  if (!parts.water) scene.reservoir.reset();
  if (!parts.crack) scene.cracks.clear();
  if (!parts.contact) scene.contact.reset();
  if (!parts.water_in_crack) scene.crack_water.reset();
  if (parts.water_in_crack && !parts.moves) scene.crack_water->model = scene::CrackWaterModel::uniform;
  if (!parts.growth) scene.propagation.reset();
  if (!parts.rock) return scene;
  put_on_rock(scene);
  return scene;
}

double count(const results::RunSummary& summary, const char* name) {
  for (const auto& [what, times] : summary.counts) {
    if (what == name) return static_cast<double>(times);
  }
  return 0.0;
}

/// Empty where the answer is right.
std::string wrong(const Parts& parts, const results::RunSummary& summary) {
  if (!summary.completed()) return summary.status;
  if (!(number(summary, "energy_balance_error") < 1e-9)) return "the energy account does not close";
  if (parts.contact && !(number(summary, "max_penetration") <= 1e-4)) return "faces overlap by more than 0.1 mm";
  if (parts.growth && !parts.rock && !(number(summary, "final_crack_length") > 5.0)) return "the crack has not grown";
  // 35.4 mm in case dynamics/koyna-linear, with the other sense of the horizontal record against the vertical one
  if (!parts.water && !parts.crack && !(std::abs(number(summary, "peak_crest_displacement") / 0.0354 - 1.0) < 0.2))
    return "the crest moves otherwise";
  return {};
}

void line(benchmark::State& state, const Parts& parts) {
  const scene::Scene scene = dam_with(parts);
  const std::filesystem::path cache = std::filesystem::temp_directory_path() / "sunder-coupled-benchmark";
  const results::RunSummary first = simulation::run(scene, {.cache = cache});  // also fills the cache of the rock
  const std::string words = wrong(parts, first);
  if (!words.empty()) return state.SkipWithError(words.c_str());
  std::map<std::string, double> least;  // CPU seconds a part
  for (auto _ : state) {
    for (const results::PartCost& part : simulation::run(scene, {.cache = cache}).parts) {
      const auto [place, is_new] = least.try_emplace(part.part, part.seconds);
      if (!is_new) place->second = std::fmin(place->second, part.seconds);
    }
  }
  const auto seconds = [&least](const char* part) { return least.contains(part) ? least.at(part) : 0.0; };
  for (const auto& [part, time] : least) state.counters[part + "_ms"] = 1e3 * time;
  // without what the media remember: their parts hold it together with their set-up
  state.counters["step_us"] = 1e6 *
                              (seconds("dynamics") + seconds("contact") + seconds("faces") + seconds("crackwater")) /
                              count(first, "steps");
  const double growths = count(first, "growths");
  if (growths == 0.0) return;
  state.counters["events"] = growths;
  // each event makes one of the factorisations; all take about as long
  state.counters["event_ms"] =
      1e3 * (seconds("crack") / growths + seconds("numerics") / count(first, "factorisations"));
}

void list(const char* name, const Parts& parts) {
  benchmark::RegisterBenchmark(name, [parts](benchmark::State& state) { line(state, parts); })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->Iterations(3);
}

}  // namespace

int main(int argc, char** argv) {
  list("dam", {});
  list("dam+water", {.water = true});
  list("dam+water+crack", {.water = true, .crack = true});
  list("dam+water+crack+contact", {.water = true, .crack = true, .contact = true});
  list("dam+water+crack+contact+uniform_water",
       {.water = true, .crack = true, .contact = true, .water_in_crack = true});
  list("dam+water+crack+contact+moving_water",
       {.water = true, .crack = true, .contact = true, .water_in_crack = true, .moves = true});
  list("dam+water+crack+contact+uniform_water+growth",
       {.water = true, .crack = true, .contact = true, .water_in_crack = true, .growth = true});
  list("dam+water+crack+contact+moving_water+growth",
       {.water = true, .crack = true, .contact = true, .water_in_crack = true, .moves = true, .growth = true});
  list("dam+water+crack+contact+moving_water+growth+rock", {.water = true,
                                                            .crack = true,
                                                            .contact = true,
                                                            .water_in_crack = true,
                                                            .moves = true,
                                                            .growth = true,
                                                            .rock = true});
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
