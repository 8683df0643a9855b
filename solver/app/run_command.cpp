#include <unistd.h>

#include <iostream>

#include "solver/app/commands.hpp"
#include "solver/app/interrupt.hpp"
#include "solver/app/progress.hpp"
#include "solver/app/quantity_table.hpp"
#include "solver/app/scene_place.hpp"
#include "solver/mesh/picture.hpp"
#include "solver/results/atomic_file.hpp"
#include "solver/results/summary_json.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/field_snapshot.hpp"

namespace sunder::app {
namespace {

namespace fs = std::filesystem;

/// A long run must not find out at its end that it cannot write; a refused scene must not leave a folder. So the folder
/// is looked at before the run and made after it.
void check_output(const fs::path& folder) {
  fs::path existing = fs::absolute(folder);
  while (!fs::exists(existing) && existing.has_relative_path()) existing = existing.parent_path();
  const auto refuse = [&](std::errc reason) {
    throw fs::filesystem_error("cannot write results", existing, std::make_error_code(reason));
  };
  if (!fs::is_directory(existing)) refuse(std::errc::not_a_directory);
  if (::access(existing.c_str(), W_OK | X_OK) != 0) refuse(std::errc::permission_denied);
}

/// The summary last: a folder with a summary is whole. What an earlier run left there, and this scene does not ask for,
/// would belong to nothing.
void write_results(const results::RunSummary& summary, bool with_fields, const fs::path& folder, const fs::path& file) {
  if (!with_fields) fs::remove(folder / simulation::field_file_name);
  const fs::path history = folder / "history.csv";
  if (summary.history) {
    results::write_atomically(history, results::to_csv(*summary.history));
  } else {
    fs::remove(history);
  }
  results::write_atomically(file, results::to_json(summary));
}

void report(const results::RunSummary& summary, const fs::path& file, const Console& console) {
  console.out << summary.name << ": " << summary.analysis << ", " << summary.mesh.polygons << " polygons, "
              << summary.mesh.dofs << " unknowns\n"
              << quantity_table(summary.quantities) << summary.status << ", written to " << file.string() << std::endl;
}

}  // namespace

int run_command(const Arguments& arguments, const Console& console, const Solver& solver) {
  const scene::Scene scene = scene::read_scene(arguments.scene, arguments.overrides);
  const fs::path folder = arguments.output.value_or(arguments.scene.stem().string() + "-results");
  check_output(folder);

  const InterruptWatch watch;
  results::RunSummary summary;
  std::string picture;
  {
    using Style = Progress::Style;
    const Style spoken = console.err_is_terminal ? Style::bar : Style::lines;
    Progress progress(console.err, arguments.quiet ? Style::none : spoken);
    const simulation::RunOptions options{
        .threads = arguments.threads,
        .progress = [&progress](std::string_view phase, double fraction) { progress.show(phase, fraction); },
        .final_body =
            [&](const simulation::Body& body) {
              if (arguments.picture) {
                picture = mesh::picture(body.polygons, {.title = scene.name, .nodes = &body.nodes});
              }
            },
        .stop = &watch.stop(),
        .cache = arguments.cache.value_or(fs::path()),
        .output = folder,
        .resume = arguments.resume};
    at_its_place(scene, [&] { summary = solver.run(scene, options); });
  }
  results::stop_if_not_finite(summary);
  const fs::path file = folder / "summary.json";
  write_results(summary, simulation::wants_fields(scene), folder, file);

  if (!picture.empty()) results::write_atomically(*arguments.picture, picture);

  if (!arguments.quiet) report(summary, file, console);
  for (const std::string& warning : summary.warnings) console.err << "warning: " << warning << '\n';
  if (summary.completed()) return completed;
  console.err << "sunder: " << summary.status << std::endl;
  return watch.exit_status() != 0 ? watch.exit_status() : numbers_did_not_come_out;
}

}  // namespace sunder::app
