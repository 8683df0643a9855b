/// A scene, and the same scene again and again with every number of it moved by one unit in the last place.

#include "solver/scene/reader.hpp"
#include "solver/simulation/run.hpp"
#include "verification/harness/digits_trusted.hpp"
#include "verification/harness/studies/scene_of_study.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

StudyOutput run_scene_jitter(const StudyInput& input) {
  const int runs = static_cast<int>(number_parameter(input, "runs", 30));
  const auto run = [&](const scene::NumberFilter& filter) {
    const auto of_scene = [&](const scene::Scene& scene) {
      simulation::RunOptions options;
      options.threads = input.threads;
      return simulation::run(scene, options);
    };
    return run_with_scene(input, of_scene, filter);
  };
  StudyOutput output = run({});
  if (!output.refusal.empty() || !output.summary.completed()) return output;
  DigitsTrusted trusted(output.summary.quantities);
  std::mt19937_64 generator(1);
  for (int number = 1; number <= runs; ++number) {
    const StudyOutput other = run([&](double value) { return jittered(value, generator); });
    const std::string which = "stopped: jittered run " + std::to_string(number) + ": ";
    if (!other.refusal.empty())
      output.summary.status = which + "refused: " + other.refusal;
    else if (!other.summary.completed())
      output.summary.status = which + other.summary.status;
    else if (!trusted.add(other.summary.quantities))
      output.summary.status = which + "other quantities than the plain run, or lists of another length";
    if (!output.summary.completed()) return output;
  }
  output.summary.quantities["spread"] = trusted.spread();
  output.summary.quantities["digits"] = trusted.digits();
  return output;
}

}  // namespace sunder::verification
