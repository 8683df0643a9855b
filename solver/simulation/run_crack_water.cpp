#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "solver/crackwater/aperture.hpp"
#include "solver/crackwater/filling_march.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/built_parts.hpp"

namespace sunder::simulation {

const bool built::crackwater = true;

namespace {

constexpr double gravity = 9.81;  // m/s², of heads in metres of water
constexpr double most_steps = 1e9, most_rows = 1e7;

crackwater::Water water_of(const scene::CrackWater& water) {
  return {.density = water.density,
          .dynamic_viscosity = water.dynamic_viscosity,
          .relative_roughness = water.relative_roughness,
          .gravity = gravity};
}

crackwater::Search search_of(scene::WaterSearch search) {
  switch (search) {
    case scene::WaterSearch::bisection:
      return crackwater::Search::bisection;
    case scene::WaterSearch::itp:
      return crackwater::Search::itp;
    case scene::WaterSearch::toms748:
      return crackwater::Search::toms748;
    case scene::WaterSearch::newton:
      return crackwater::Search::newton;
    case scene::WaterSearch::prefix:
      return crackwater::Search::prefix_moments;
  }
  return crackwater::Search::prefix_moments;
}

crackwater::ApertureRule rule_of(scene::ApertureRule rule) {
  switch (rule) {
    case scene::ApertureRule::larger:
      return crackwater::ApertureRule::larger;
    case scene::ApertureRule::sum:
      return crackwater::ApertureRule::sum;
  }
  return crackwater::ApertureRule::larger;
}

crackwater::CrackLine line_of(const scene::CrackLine& line) {
  crackwater::CrackLine crack = crackwater::straight_crack(line.length, line.segments);
  if (line.rise != 0.0) crack.rises.assign(crack.lengths.size(), line.rise / line.segments);
  return crack;
}

crackwater::ProfileOptions options_of(const scene::CrackLine& line) {
  const bool midpoint = line.quadrature == scene::WaterQuadrature::midpoint;
  return {.quadrature = midpoint ? crackwater::Quadrature::midpoint : crackwater::Quadrature::exact,
          .search = search_of(line.search),
          .relative_tolerance = line.tolerance};
}

crackwater::MouthPressures mouths_of(const scene::CrackLine& line, double weight) {
  crackwater::MouthPressures mouths{.upstream = weight * line.upstream_head, .downstream = {}};
  if (line.downstream_head) mouths.downstream = weight * *line.downstream_head;
  return mouths;
}

/// One value everywhere, two linear between the mouths, or one a node.
std::vector<double> nodal(const std::vector<double>& given, int segments) {
  const std::size_t nodes = static_cast<std::size_t>(segments) + 1;
  if (given.size() == nodes) return given;
  std::vector<double> values(nodes);
  for (std::size_t node = 0; node < nodes; ++node) {
    // exact where both ends are equal: faces that just touch their roughness must do so everywhere
    values[node] = std::lerp(given.front(), given.back(), static_cast<double>(node) / segments);
  }
  return values;
}

/// The water's apertures while the faces move as the scene says.
class Motion {
 public:
  Motion(const scene::CrackLine& line, const scene::CrackWater& water)
      : start_(nodal(line.aperture, line.segments)),
        rate_(nodal(line.opening_rate, line.segments)),
        opening_(start_),
        factors_(start_.size()),
        minimum_(water.minimum_aperture),
        rule_(rule_of(water.aperture)),
        apertures(start_.size()),
        rates(start_.size()) {
    move_to(0.0);
  }

  void move_to(double time) {
    for (std::size_t node = 0; node < start_.size(); ++node) opening_[node] = start_[node] + rate_[node] * time;
    crackwater::apertures(opening_, rate_, minimum_, rule_, apertures, rates, factors_);
  }

 private:
  std::vector<double> start_, rate_, opening_, factors_;
  double minimum_;
  crackwater::ApertureRule rule_;

 public:
  std::vector<double> apertures, rates;  ///< (segments + 1) [m], [m/s], of the water
};

/// Calls `work` and turns what module crackwater refuses into a SceneError at its table.
template <class Work>
void at_table(const scene::Scene& scene, const char* table, Work work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    throw scene::SceneError(place_of(scene, table) + error.what());
  }
}

std::string word_of(const crackwater::PressureProfile& profile) {
  if (profile.status != crackwater::ProfileStatus::converged) return "not converged";
  return profile.at_regime_jump ? "converged at the jump of Re = 2300" : "converged";
}

void write_pressures(const crackwater::PressureProfile& profile, results::Quantity& quantities) {
  quantities["uplift_force"] = profile.uplift_force;
  quantities["uplift_moment"] = profile.uplift_moment;
  quantities["upstream_flux"] = profile.upstream_flux;
  quantities["downstream_flux"] = profile.downstream_flux;
  quantities["front_position"] = profile.front_position;
  quantities["peak_pressure"] = profile.peak_pressure;
  quantities["peak_position"] = profile.peak_position;
  quantities["pressure"] = results::Quantity(profile.pressure);
  quantities["turbulent_share"] = profile.turbulent_share;
  quantities["gradient_evaluations"] = static_cast<double>(profile.gradient_evaluations);
  quantities["status"] = word_of(profile);
}

void run_instant(const scene::Scene& scene, Ledger& ledger, results::RunSummary& summary) {
  const scene::CrackLine& line = *scene.crack_line;
  const scene::CrackWater& water = *scene.crack_water;
  Ledger::Visit visit(ledger, "crackwater", "pressures");
  const Motion motion(line, water);
  crackwater::PressureSolver solver(line_of(line), water_of(water), options_of(line));
  const crackwater::MouthPressures mouths = mouths_of(line, gravity * water.density);
  const crackwater::PressureProfile& profile = water.model == scene::CrackWaterModel::uniform
                                                   ? solver.uniform(mouths.upstream)
                                                   : solver.solve(motion.apertures, motion.rates, mouths);
  ledger.count("water_solves");
  ledger.count("residual_evaluations", profile.residual_evaluations);
  ledger.count("gradient_evaluations", profile.gradient_evaluations);
  if (profile.status == crackwater::ProfileStatus::unusable_input) {
    summary.status = "stopped: the pressures are not finite";
    return;
  }
  if (profile.status != crackwater::ProfileStatus::converged)
    summary.status = "stopped: the flux was not found to its tolerance; the best answer is listed";
  write_pressures(profile, summary.quantities);
}

results::History march_history() {
  return results::History({{"time", "s"},
                           {"front_position", "m"},
                           {"water_content", "m2"},
                           {"inflow", "m2"},
                           {"outflow", "m2"},
                           {"upstream_flux", "m2/s"},
                           {"downstream_flux", "m2/s"},
                           {"uplift_force", "N/m"},
                           {"uplift_moment", "N"},
                           {"peak_pressure", "Pa"},
                           {"peak_position", "m"},
                           {"water_volume_error", "m2"}});
}

void note(const crackwater::FillingMarch& march, results::History& history) {
  const crackwater::MarchState& state = march.state();
  const crackwater::PressureProfile& profile = march.profile();
  history.add_row(std::array{state.time, state.front_position, state.content, state.inflow, state.outflow,
                             profile.upstream_flux, profile.downstream_flux, profile.uplift_force,
                             profile.uplift_moment, profile.peak_pressure, profile.peak_position, state.balance_error});
}

void run_march(const scene::Scene& scene, const RunOptions& options, Ledger& ledger, results::RunSummary& summary) {
  const scene::CrackLine& line = *scene.crack_line;
  const scene::CrackWater& water = *scene.crack_water;
  const scene::March& plan = *line.march;
  Ledger::Visit visit(ledger, "crackwater", "march");
  Motion motion(line, water);
  crackwater::FillingMarch march(
      line_of(line), water_of(water), motion.apertures,
      {.search = search_of(line.search), .initially_full = plan.initially == scene::Filling::full});
  const crackwater::MouthPressures mouths = mouths_of(line, gravity * water.density);
  // a duration that is a whole number of steps but for round-off gets no step more
  const auto steps = static_cast<long long>(std::fmax(std::ceil(plan.duration / plan.time_step - 1e-9), 1.0));
  summary.history = march_history();
  summary.history->reserve(static_cast<std::size_t>(steps / plan.history_every) + 1);
  double time = 0.0;
  for (long long i = 1; i <= steps && summary.completed(); ++i) {
    if (options.stop != nullptr && options.stop->load()) {
      summary.status = "stopped: interrupted at " + std::to_string(time) + " s";
      break;
    }
    const double end = i == steps ? plan.duration : plan.time_step * static_cast<double>(i);
    motion.move_to(end);
    if (march.step(motion.apertures, mouths, end - time).status != crackwater::ProfileStatus::converged)
      summary.status = "stopped: the water was not found to round-off at " + std::to_string(end) + " s";
    time = end;
    if (i % plan.history_every == 0 || i == steps || !summary.completed()) note(march, *summary.history);
    if (options.progress && i % 256 == 0)
      options.progress("march", static_cast<double>(i) / static_cast<double>(steps));
  }
  const crackwater::MarchState& state = march.state();
  ledger.count("steps", state.steps);
  ledger.count("water_solves", state.steps);
  ledger.count("residual_evaluations", state.residual_evaluations);
  ledger.count("gradient_evaluations", state.gradient_evaluations);
  if (state.steps == 0) return;
  write_pressures(march.profile(), summary.quantities);
  summary.quantities["front_position"] = state.front_position;
  summary.quantities["gradient_evaluations"] = static_cast<double>(state.gradient_evaluations);
  const double error = std::abs(state.balance_error);
  summary.quantities["water_volume_error"] = error > 0.0 ? error / std::fmax(state.moved, error) : 0.0;
}

}  // namespace

void check_crack_water(const scene::Scene& scene) {
  const scene::CrackLine& line = *scene.crack_line;
  at_table(scene, "crack_water", [&] { crackwater::check(water_of(*scene.crack_water)); });
  at_table(scene, "crack_line", [&] {
    const Motion motion(line, *scene.crack_water);
    crackwater::check(line_of(line), motion.apertures, motion.rates);
  });
  if (!line.march) return;
  const auto refuse = [&](const char* table, const std::string& what) {
    throw scene::SceneError(place_of(scene, table) + what);
  };
  if (scene.crack_water->model == scene::CrackWaterModel::uniform)
    refuse("crack_water", "model = \"uniform\" has no history; accepted: model = \"moving\", or no crack_line.march");
  if (line.quadrature == scene::WaterQuadrature::midpoint)
    refuse("crack_line", "quadrature = \"midpoint\" is of an instant; accepted: \"exact\", or no crack_line.march");
  if (line.tolerance != 0.0)
    refuse("crack_line", "tolerance has no effect in a march, whose water is found to round-off; accepted: 0");
  if (!(line.march->duration / line.march->time_step <= most_steps))
    refuse("crack_line", "march.duration holds more than 1e9 steps of march.time_step; accepted: at most 1e9");
  if (!(line.march->duration / line.march->time_step <= most_rows * line.march->history_every))
    refuse("crack_line", "march.history_every asks for more than 1e7 rows of history; accepted: a larger one");
}

void run_crack_water(const scene::Scene& scene, const RunOptions& options, Ledger& ledger,
                     results::RunSummary& summary) {
  check_crack_water(scene);
  if (scene.crack_line->march) {
    run_march(scene, options, ledger, summary);
  } else {
    run_instant(scene, ledger, summary);
  }
}

}  // namespace sunder::simulation
