// The one place that includes CLI11: it costs ten seconds of compilation.
#include "solver/app/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <thread>

#include "solver/results/environment.hpp"

namespace sunder::app {
namespace {

constexpr const char* exit_statuses =
    "Exit status: 0 completed, 1 the numbers did not come out (what was reached is written), 2 unusable input,\n"
    "130 on Ctrl-C (what was reached is written).";

std::string version_text() {
  const results::Environment built = results::environment();
  return "sunder " + built.version + "\n" + built.compiler + " " + built.flags;
}

void add_scene(CLI::App& command, Arguments& arguments, std::vector<std::string>& settings) {
  command.add_option("SCENE", arguments.scene, "The scene, a TOML file; `sunder keys` lists what it may hold")
      ->required();
  command
      .add_option("--set", settings,
                  "Replace or add a value: mesh.order=3, crack[0].path=[[0,60],[2,60]], material.plane='\"stress\"'")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_running(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--cache", arguments.cache,
                  "Folder that keeps responses of unbounded rock between runs [default: none is kept]")
      ->type_name("DIR");
  command.add_option("--threads", arguments.threads, "Threads; the results are the same bits for any number")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_flag("--quiet", arguments.quiet, "Print nothing but errors; ablate: and its table");
}

}  // namespace

CommandLine parse_command_line(std::span<const std::string> words) {
  Arguments arguments;
  arguments.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::string> settings;

  CLI::App app("Seismic crack growth in concrete gravity dams, by polygon scaled boundary finite elements.", "sunder");
  app.footer(exit_statuses);
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text(), "Print version, compiler and flags");

  CLI::App& run = *app.add_subcommand("run", "Run a scene and write its results");
  add_scene(run, arguments, settings);
  run.add_option("--output", arguments.output,
                 "Folder for the results [default: the scene's name with -results, in the current folder]")
      ->type_name("DIR");
  add_running(run, arguments);
  run.add_flag("--resume", arguments.resume,
               "Go on from the checkpoint of an interrupted run in the output folder (output.checkpoint_every)");
  run.add_option("--picture", arguments.picture,
                 "Draw the mesh as the run has left it, with the cracks as they have grown")
      ->type_name("FILE.svg");
  run.footer(exit_statuses);

  CLI::App& check = *app.add_subcommand("check", "Read and mesh a scene, say what would be built, run nothing");
  add_scene(check, arguments, settings);
  check.add_option("--picture", arguments.picture, "Draw the mesh")->type_name("FILE.svg");

  CLI::App& ablate = *app.add_subcommand(
      "ablate", "Run a scene whole and once without each of its parts: what each costs and what it changes");
  add_scene(ablate, arguments, settings);
  add_running(ablate, arguments);
  ablate.footer(exit_statuses);

  CLI::App& keys = *app.add_subcommand("keys", "Print every table and key of a scene: unit, range, default, meaning");
  keys.add_flag("--markdown", arguments.markdown, "As the documentation has them");

  try {
    // CLI11 takes the words from the back.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    for (const std::string& setting : settings) arguments.overrides.push_back(scene::parse_override(setting));
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool wrong = app.exit(error, out, err) != 0;
    return {std::nullopt, out.str() + err.str(), wrong ? 2 : 0};
  } catch (const std::invalid_argument& error) {
    return {std::nullopt, std::string("--set: ") + error.what() + "\n", 2};
  }
  arguments.command = run.parsed()      ? Command::run
                      : check.parsed()  ? Command::check
                      : ablate.parsed() ? Command::ablate
                                        : Command::keys;
  return {arguments, {}, 0};
}

}  // namespace sunder::app
