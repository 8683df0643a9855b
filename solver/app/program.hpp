#pragma once
/// The command line: `sunder run | check | ablate | keys`, from words to an exit status.

#include <functional>
#include <iosfwd>
#include <span>
#include <string>

#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/polygon_mesh.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/run.hpp"

namespace sunder::app {

/// The body of a scene, meshed.
struct Plan {
  mesh::PolygonMesh polygons;
  mesh::NodalMesh nodes;
};

/// What the commands ask of the solver; tests put others in its place.
struct Solver {
  std::function<results::RunSummary(const scene::Scene&, const simulation::RunOptions&)> run;
  std::function<Plan(const scene::Scene&)> plan;
};

struct Console {
  std::ostream& out;  ///< results
  std::ostream& err;  ///< progress, warnings, errors
  bool err_is_terminal = false;
};

/// Exit statuses.
inline constexpr int completed = 0;
inline constexpr int numbers_did_not_come_out = 1;
inline constexpr int unusable_input = 2;

/// Runs one command and returns the exit status. `words` without the program's name. Throws nothing.
[[nodiscard]] int program(std::span<const std::string> words, const Console& console, const Solver& solver) noexcept;

}  // namespace sunder::app
