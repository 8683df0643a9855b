/// A run in one piece against the same run in several, interrupted or killed in between.

#include <stdlib.h>  // mkdtemp [POSIX.1-2008]

#include <atomic>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "solver/simulation/run.hpp"
#include "verification/harness/studies/scene_of_study.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

/// What a kill looks like from inside: nothing after it happens.
struct Killed {};

/// A folder of its own, gone at the end.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sunder-resumed-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::filesystem::filesystem_error(pattern, std::error_code());
    path_ = pattern;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code nothing;
    std::filesystem::remove_all(path_, nothing);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Numbers that differ, a missing or superfluous one among them.
int differences(const results::Quantity& a, const results::Quantity& b) {
  if (a.number() != nullptr) return b.number() != nullptr && same_bits(*a.number(), *b.number()) ? 0 : 1;
  if (a.text() != nullptr) return b.text() != nullptr && *a.text() == *b.text() ? 0 : 1;
  int count = 0;
  if (a.list() != nullptr) {
    if (b.list() == nullptr || a.list()->size() != b.list()->size()) return 1;
    for (std::size_t i = 0; i < a.list()->size(); ++i) count += differences((*a.list())[i], (*b.list())[i]);
    return count;
  }
  if (b.table() == nullptr || a.table()->size() != b.table()->size()) return 1;
  for (std::size_t i = 0; i < a.table()->size(); ++i)
    count += differences((*a.table())[i].second, (*b.table())[i].second);
  return count;
}

int differences(const results::History& a, const results::History& b) {
  if (a.rows() != b.rows()) return 1;
  int count = 0;
  for (std::size_t row = 0; row < a.rows(); ++row) {
    for (std::size_t column = 0; column < a.columns().size(); ++column)
      count += same_bits(a.at(row, column), b.at(row, column)) ? 0 : 1;
  }
  return count;
}

long long count_of(const results::RunSummary& summary, const std::string& name) {
  for (const auto& [what, count] : summary.counts) {
    if (what == name) return count;
  }
  return 0;
}

}  // namespace

StudyOutput run_resumed(const StudyInput& input) {
  const int pieces = static_cast<int>(number_parameter(input, "pieces", 3.0));
  const int every = static_cast<int>(number_parameter(input, "checkpoint_every", 10.0));
  return run_with_scene(input, [&](scene::Scene& scene) {
    const results::RunSummary whole = simulation::run(scene, {.threads = input.threads});
    if (!scene.output) scene.output.emplace();
    scene.output->checkpoint_every = every;
    const Folder folder;
    int killed = 0;
    for (int piece = 1; piece < pieces; ++piece) {
      std::atomic<bool> stop{false};
      const bool kills = piece % 2 == 1;
      simulation::RunOptions options;
      options.threads = input.threads;
      options.stop = &stop;
      options.output = folder.path();
      options.resume = piece > 1;
      options.progress = [&](std::string_view phase, double done) {
        if (phase != "steps" || done * pieces < piece) return;
        if (kills) throw Killed();
        stop = true;
      };
      try {
        (void)simulation::run(scene, options);
      } catch (const Killed&) {
        ++killed;
      }
    }
    simulation::RunOptions options;
    options.threads = input.threads;
    options.output = folder.path();
    options.resume = pieces > 1;
    results::RunSummary resumed = simulation::run(scene, options);
    const int of_history = whole.history && resumed.history ? differences(*whole.history, *resumed.history) : 1;
    const int of_quantities = differences(whole.quantities, resumed.quantities);
    resumed.quantities["different_values"] = of_history + of_quantities;
    resumed.quantities["killed"] = killed;
    resumed.quantities["growths"] = static_cast<double>(count_of(whole, "growths"));
    resumed.quantities["growths_after"] = static_cast<double>(count_of(resumed, "growths"));
    resumed.quantities["steps_after"] = static_cast<double>(count_of(resumed, "steps"));
    return resumed;
  });
}

}  // namespace sunder::verification
