#pragma once
/// What each part of a scene costs and changes: the scene is run whole, and once without each part that it has.
///
/// A part is cut in the scene, before anything is built: nothing of it is formed, stored or visited. What hangs on it
/// goes with it: without cracks there is no contact, without a reservoir no water in the cracks.

#include <optional>
#include <string>
#include <vector>

#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"

namespace sunder::app {

struct Cut {
  std::string part;    ///< "contact", "reservoir: water's inertia", …
  scene::Scene scene;  ///< without it
};

/// One for every part that the scene could do without, in the order of the scene's own documentation.
[[nodiscard]] std::vector<Cut> cuts_of(const scene::Scene& scene);

/// The scene as it is, without output to files.
[[nodiscard]] scene::Scene without_output(scene::Scene scene);

/// What a dam engineer looks at; absent where the analysis has no such number.
struct Findings {
  std::optional<double> displacement;  ///< largest of the crest (dynamic) or of the body (static) [m]
  std::optional<double> crack_length;  ///< of the longest crack at the end, where cracks grow [m]
  std::optional<double> K_I;           ///< largest of all tips and times [Pa √m]
  std::optional<double> uplift;        ///< largest uplift force of a crack's water [N/m]
  std::optional<double> frequency;     ///< lowest natural frequency [Hz]
};

[[nodiscard]] Findings findings_of(const results::RunSummary& summary);

/// One run of an ablation.
struct AblationRun {
  std::string part;          ///< that was left out; empty: the whole scene
  double seconds = 0.0;      ///< CPU
  std::string trouble = {};  ///< why there are no numbers, or not all; empty where the run completed
  Findings findings = {};
};

/// The table for people; `runs.front()` is the whole scene. Times are of one run each: see the README of the
/// benchmarks.
[[nodiscard]] std::string ablation_table(const std::string& name, const std::vector<AblationRun>& runs);

}  // namespace sunder::app
