/// sunder-verify: the verification catalogue on the command line.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>

#include "verification/harness/case.hpp"
#include "verification/harness/catalogue.hpp"
#include "verification/harness/doctor.hpp"
#include "verification/harness/fault_coverage.hpp"
#include "verification/harness/fault_names.hpp"
#include "verification/harness/faults.hpp"
#include "verification/harness/isolation.hpp"
#include "verification/harness/jitter.hpp"
#include "verification/harness/junit.hpp"
#include "verification/harness/kill_matrix.hpp"
#include "verification/harness/negatives.hpp"
#include "verification/harness/record.hpp"
#include "verification/harness/report_text.hpp"
#include "verification/harness/runner.hpp"
#include "verification/harness/study.hpp"

namespace {

using namespace sunder::verification;
namespace fs = std::filesystem;

constexpr int all_right = 0, something_failed = 1, unusable_input = 2;

struct Arguments {
  std::string root, id, label, family, output, junit, commit, records;
  std::vector<std::string> faults;
  bool repeat = false, update_pins = false, in_process = false, write = false, trap = false;
  int threads = 1, other_threads = 0;
  double timeout = 0.0;
};

/// The folder of the project: given, or the nearest above here or above this program that has cases.
fs::path project_root(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code ignored;
  for (const fs::path& start : {fs::current_path(), fs::read_symlink("/proc/self/exe", ignored).parent_path()})
    for (fs::path folder = start; !folder.empty(); folder = folder.parent_path()) {
      if (fs::is_directory(folder / "verification" / "cases")) return folder;
      if (folder == folder.parent_path()) break;
    }
  throw std::runtime_error("no folder verification/cases was found here or above; --root names the project");
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

struct Selection {
  std::vector<Case> cases;
  std::vector<CaseResult> unreadable;  ///< cases that do not follow the schema
};

Selection select_cases(const Arguments& arguments, const CaseFolders& folders) {
  Selection selection;
  for (const fs::path& file : case_files(folders)) {
    const std::string id = case_id(file, folders);
    if (!arguments.id.empty() && arguments.id != id) continue;
    if (!arguments.family.empty() && arguments.family != id.substr(0, id.find('/'))) continue;
    try {
      Case entry = read_case(file, folders);
      if (!arguments.label.empty() && arguments.label != entry.family && arguments.label != word(entry.tier)) continue;
      selection.cases.push_back(std::move(entry));
    } catch (const CaseError& error) {
      CaseResult result;
      result.id = id;
      result.family = id.substr(0, id.find('/'));
      result.status = Status::checked_nothing;
      result.message = error.what();
      selection.unreadable.push_back(std::move(result));
    }
  }
  return selection;
}

CaseResult run_here_or_isolated(const Case& entry, const Arguments& arguments, const std::function<CaseResult()>& run) {
  if (arguments.in_process) return run();
  IsolationLimits limits = limits_of(entry);
  if (arguments.timeout > 0.0) limits.seconds = arguments.timeout;
  return run_isolated(entry, limits, run);
}

const Study& study_of(const Case& entry) {
  const auto found = studies().find(entry.study);
  if (found != studies().end()) return found->second;
  std::string known;
  for (const auto& [name, study] : studies()) known += (known.empty() ? "" : ", ") + name;
  throw CaseError(entry.id + ".case.toml: study: there is no study \"" + entry.study + "\" among " + known);
}

/// Only a figure of error against run time needs times that have settled.
bool shows_run_time(const Case& entry) {
  return entry.sweep && !entry.sweep->error.empty() && !entry.ladder;
}

enum class Command { run, negatives, jitter };

RunnerOptions options_of(const Case& entry, const Arguments& arguments) {
  return {.threads = arguments.threads,
          .pins = read_pins(entry),
          .today = today(),
          .repeat = arguments.repeat && shows_run_time(entry),
          .other_threads = arguments.other_threads,
          .trap = arguments.trap};
}

/// Runs the case as often as it is asked to, each time with what is planted before and read after.
RunCase with_faults_of(const Case& entry, const Arguments& arguments) {
  return [&entry, &arguments, &study = study_of(entry), options = options_of(entry, arguments)](const auto& before,
                                                                                                const auto& after) {
    return run_here_or_isolated(entry, arguments, [&] {
      before();
      CaseResult result = run_case(entry, study, options);
      after(result);
      return result;
    });
  };
}

CaseResult run_entry(const Case& entry, const Arguments& arguments, Command command) {
  if (command == Command::negatives) return run_negatives(entry, *fault_control(), with_faults_of(entry, arguments));
  const RunnerOptions options = options_of(entry, arguments);
  if (command == Command::jitter)
    return run_here_or_isolated(jitter_case(entry), arguments, [&] { return run_jitter_case(entry, options); });
  const Study& study = study_of(entry);
  return run_here_or_isolated(entry, arguments, [&] { return run_case(entry, study, options); });
}

/// Measures which check notices which fault; fails where a case fails without any.
int matrix(const Arguments& arguments, const CaseFolders& folders) {
  const Selection selection = select_cases(arguments, folders);
  for (const CaseResult& result : selection.unreadable) std::cerr << result.message << "\n";
  int status = selection.unreadable.empty() ? all_right : unusable_input;
  for (const Case& entry : selection.cases) {
    const KillMatrix measured =
        kill_matrix(entry, *fault_control(), with_faults_of(entry, arguments), arguments.faults);
    if (fails(measured.baseline)) status = std::max(status, something_failed);
    std::cout << report_text(measured) << std::flush;
    if (!arguments.output.empty())
      append(arguments.output, to_json(measured, environment(arguments.threads, arguments.commit)));
  }
  return status;
}

int run(const Arguments& arguments, const CaseFolders& folders, Command command) {
  Selection selection = select_cases(arguments, folders);
  if (selection.cases.empty() && selection.unreadable.empty()) throw std::runtime_error("no case matches");
  Environment from = environment(arguments.threads, arguments.commit);
  from.faulted = fault_control() != nullptr;
  std::vector<CaseResult> results;
  int status = selection.unreadable.empty() ? all_right : unusable_input;
  const auto finish = [&](CaseResult result) {
    if (fails(result.status)) status = std::max(status, something_failed);
    std::cout << report_text(result) << std::flush;
    if (!arguments.output.empty()) append(arguments.output, to_json(result, from));
    results.push_back(std::move(result));
  };
  for (CaseResult& result : selection.unreadable) finish(std::move(result));
  for (const Case& entry : selection.cases) {
    if (command == Command::negatives && entry.negatives.empty()) continue;
    if (command == Command::jitter && entry.study != "scene" && arguments.id.empty()) continue;
    try {
      CaseResult result = run_entry(entry, arguments, command);
      if (arguments.update_pins) {
        write_pins(entry, result);
        std::cout << "pins of " << entry.id << " stored\n";
      }
      finish(std::move(result));
    } catch (const CaseError& error) {
      finish(unfinished(entry, Status::checked_nothing, error.what()));
      status = unusable_input;
    }
  }
  if (!arguments.junit.empty()) write_junit(arguments.junit, results);
  const auto failing =
      std::count_if(results.begin(), results.end(), [](const CaseResult& r) { return fails(r.status); });
  if (results.size() != 1) std::cout << results.size() << " cases, " << failing << " fail\n";
  return status;
}

int list(const Arguments& arguments, const CaseFolders& folders) {
  const Selection selection = select_cases(arguments, folders);
  for (const Case& entry : selection.cases)
    std::cout << entry.id << "  [" << word(entry.tier) << ", " << entry.checks.size() << " checks, "
              << entry.negatives.size() << " faults]  " << entry.title << "\n";
  for (const CaseResult& result : selection.unreadable) std::cerr << result.message << "\n";
  return selection.unreadable.empty() ? all_right : unusable_input;
}

/// Every fault must have a case, and every gating check that is not on the list a fault.
int faults(const Arguments& arguments, const CaseFolders& folders, const fs::path& solver) {
  const Selection selection = select_cases({}, folders);
  for (const CaseResult& result : selection.unreadable) std::cerr << result.message << "\n";
  if (!selection.unreadable.empty()) return unusable_input;
  const fs::path list = folders.cases / "idle-checks.txt";
  const FaultCoverage coverage = fault_coverage(selection.cases, fault_names(solver), read_idle_checks(list));
  if (arguments.write) write_idle_checks(list, coverage.idle_checks);
  std::cout << coverage.text << coverage.unnamed_faults.size() << " faults without a case, "
            << coverage.idle_checks.size() << " gating checks without a fault\n";
  return coverage.sound() || arguments.write ? all_right : something_failed;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Writes the page, or says whether the one that is there still agrees with the cases.
int catalogue(const Arguments& arguments, const CaseFolders& folders, const fs::path& page) {
  const Selection selection = select_cases({}, folders);
  for (const CaseResult& result : selection.unreadable) std::cerr << result.message << "\n";
  if (!selection.unreadable.empty()) return unusable_input;
  std::vector<CaseResult> results;
  if (!arguments.records.empty()) {
    std::ifstream records(arguments.records);
    for (std::string line; std::getline(records, line);) results.push_back(from_json(line));
  }
  if (const Evidence evidence = evidence_of(selection.cases); evidence.share() < least_independent_share) {
    std::cerr << evidence.independent << " of " << evidence.with_reference
              << " references are exact, high-precision or another code's: fewer than 80 %\n";
    return something_failed;
  }
  const std::string made = catalogue_page(selection.cases, results);
  if (arguments.write) {
    std::ofstream(page) << made;
    return all_right;
  }
  if (claims_of(text_of(page)) == claims_of(made)) return all_right;
  std::cerr
      << "verification/README.md does not agree with the cases; `sunder-verify catalogue --write` makes it anew\n";
  return something_failed;
}

/// Ten numbers that should appear, each case in a process of its own.
int doctor(const Arguments& arguments, const CaseFolders& folders, const fs::path& numbers) {
  const auto begin = std::chrono::steady_clock::now();
  const auto readings = read_numbers(read_doctor_numbers(numbers), [&](const std::string& id) {
    return run_entry(read_case(folders.cases / (id + ".case.toml"), folders), arguments, Command::run);
  });
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  std::cout << doctor_text(readings, passed.count());
  const bool sound = std::all_of(readings.begin(), readings.end(), [](const auto& reading) { return reading.right(); });
  return sound ? all_right : something_failed;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"The verification catalogue of Sunder"};
  app.footer("Exit status: 0 nothing fails, 1 a case fails, 2 the arguments or a case file cannot be used.");
  app.require_subcommand(1);
  app.add_option("--root", arguments.root, "Folder of the project; otherwise searched upwards");
  const auto selects = [&](CLI::App* command) {
    command->add_option("ID", arguments.id, "One case, e.g. sif/edge-crack-one-polygon");
    command->add_option("--label", arguments.label, "Cases of this family or tier");
    command->add_option("--family", arguments.family, "Cases of this family");
  };
  const auto runs = [&](CLI::App* command) {
    selects(command);
    command->add_option("--output", arguments.output, "File of records to append to (JSON lines)");
    command->add_option("--junit", arguments.junit, "File of results to write as JUnit XML");
    command->add_option("--commit", arguments.commit, "Commit to name in the records");
    command->add_option("--threads", arguments.threads, "Threads of a run")->check(CLI::Range(1, 1024));
    command
        ->add_option("--other-threads", arguments.other_threads,
                     "Run each setting once more with so many threads; the bits must be the same")
        ->check(CLI::Range(1, 1024));
    command->add_flag("--trap", arguments.trap,
                      "Invalid operations, divisions by zero and overflows end the case where they happen");
    command->add_option("--timeout", arguments.timeout, "Wall seconds for a case, instead of those of its tier");
    command->add_flag("--in-process", arguments.in_process, "Run in this process, for debuggers");
  };
  CLI::App* list_command = app.add_subcommand("list", "List the cases");
  selects(list_command);
  CLI::App* run_command = app.add_subcommand("run", "Run cases, each in a process of its own");
  runs(run_command);
  run_command->add_flag("--repeat", arguments.repeat,
                        "Repeat what shows error against run time until its CPU time is settled");
  run_command->add_flag("--update-pins", arguments.update_pins, "Store what was measured as the new pins");
  CLI::App* negatives_command =
      app.add_subcommand("negatives", "Plant the faults that the cases name; their checks must fail");
  runs(negatives_command);
  CLI::App* jitter_command = app.add_subcommand(
      "jitter", "Run scenes thirty times with every number moved by its last bit: the digits that may be trusted");
  runs(jitter_command);
  CLI::App* doctor_command =
      app.add_subcommand("doctor", "Ten numbers that should appear: is this installation sound?");
  doctor_command->footer("Exit status: 0 the installation is sound, 1 a number is wrong, 2 the cases cannot be read.");
  CLI::App* matrix_command =
      app.add_subcommand("matrix", "Plant every fault that a case comes by; which checks turn red?");
  runs(matrix_command);
  matrix_command->add_option("--faults", arguments.faults, "Only these, of those that a case comes by");
  CLI::App* faults_command =
      app.add_subcommand("faults", "Every fault that the solver can plant needs a case, every check a fault");
  faults_command->add_flag("--write", arguments.write, "Write cases/idle-checks.txt, the checks still without one");
  CLI::App* catalogue_command =
      app.add_subcommand("catalogue", "Check verification/README.md against the cases, or write it");
  catalogue_command->add_flag("--write", arguments.write, "Write it");
  catalogue_command->add_option("--records", arguments.records, "Records for the last column")
      ->check(CLI::ExistingFile);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? all_right : unusable_input;
  }
  try {
    const fs::path root = project_root(arguments.root);
    const CaseFolders folders{root / "verification" / "cases", root / "reference-data"};
    if (*list_command) return list(arguments, folders);
    if (*doctor_command) return doctor(arguments, folders, root / "verification" / "doctor.toml");
    if (*faults_command) return faults(arguments, folders, root / "solver");
    if (*catalogue_command) return catalogue(arguments, folders, root / "verification" / "README.md");
    if ((*negatives_command || *matrix_command) && !fault_control())
      throw std::runtime_error("this program holds no faults; sunder-verify-faulted does");
    if (*matrix_command) return matrix(arguments, folders);
    return run(arguments, folders,
               *negatives_command ? Command::negatives : (*jitter_command ? Command::jitter : Command::run));
  } catch (const std::exception& error) {
    std::cerr << "sunder-verify: " << error.what() << "\n";
    return unusable_input;
  }
}
