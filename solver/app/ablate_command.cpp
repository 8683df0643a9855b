#include <ostream>
#include <stdexcept>

#include "solver/app/ablation.hpp"
#include "solver/app/commands.hpp"
#include "solver/app/interrupt.hpp"
#include "solver/app/progress.hpp"
#include "solver/app/scene_place.hpp"
#include "solver/numerics/stopwatch.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::app {
namespace {

AblationRun run_one(const std::string& part, const scene::Scene& scene, const Arguments& arguments,
                    const Console& console, const Solver& solver, const InterruptWatch& watch) {
  AblationRun run{.part = part};
  const bool spoken = !arguments.quiet && console.err_is_terminal;
  Progress progress(console.err, spoken ? Progress::Style::bar : Progress::Style::none);
  const simulation::RunOptions options{
      .threads = arguments.threads,
      .progress = [&](std::string_view phase, double fraction) { progress.show(phase, fraction); },
      .stop = &watch.stop(),
      .cache = arguments.cache.value_or(std::filesystem::path())};
  const numerics::Stopwatch stopwatch;
  results::RunSummary summary;
  at_its_place(scene, [&] { summary = solver.run(scene, options); });
  run.seconds = stopwatch.cpu();
  run.findings = findings_of(summary);
  if (!summary.completed()) run.trouble = summary.status;
  return run;
}

}  // namespace

int ablate_command(const Arguments& arguments, const Console& console, const Solver& solver) {
  const scene::Scene whole = scene::read_scene(arguments.scene, arguments.overrides);
  const std::vector<Cut> cuts = cuts_of(whole);
  if (cuts.empty()) {
    throw scene::SceneError(whole.file.string() +
                            ": this scene has no part that it could do without; accepted: a static, modal or dynamic "
                            "scene with at least one of cracks, growth, contact, crack water, reservoir, foundation, "
                            "gravity, loads, regions, ground motion, or a crack with moving water at one instant");
  }
  const InterruptWatch watch;
  std::vector<AblationRun> runs = {run_one("", without_output(whole), arguments, console, solver, watch)};
  for (const Cut& cut : cuts) {
    if (watch.exit_status() != 0) break;
    try {
      runs.push_back(run_one(cut.part, cut.scene, arguments, console, solver, watch));
    } catch (const std::invalid_argument& error) {  // what is left makes no sense without the part
      runs.push_back({.part = cut.part, .trouble = std::string("refused: ") + error.what()});
    } catch (const scene::SceneError& error) {  // likewise
      runs.push_back({.part = cut.part, .trouble = std::string("refused: ") + error.what()});
    }
  }
  console.out << ablation_table(whole.name, runs) << std::flush;
  if (watch.exit_status() != 0) return watch.exit_status();
  if (runs.front().trouble.empty()) return completed;
  console.err << "sunder: " << runs.front().trouble << std::endl;
  return numbers_did_not_come_out;
}

}  // namespace sunder::app
