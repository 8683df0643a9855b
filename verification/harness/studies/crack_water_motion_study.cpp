/// Water in a crack that moves as no scene can say: breathing, or to and fro from one step to the next.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/front_tracking.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

using namespace crackwater;

struct Plan {
  explicit Plan(const StudyInput& input)
      : motion(text_parameter(input, "motion")),
        aperture(number_parameter(input, "aperture")),
        length(number_parameter(input, "length")),
        pressure(number_parameter(input, "pressure")),
        start(number_parameter(input, "start", 0.0)),
        amplitude(number_parameter(input, "amplitude", 0.0)),
        rate(number_parameter(input, "rate", 0.0)),
        duration(number_parameter(input, "duration")),
        time_step(number_parameter(input, "time_step", 0.0)),
        tolerance(number_parameter(input, "tolerance", 1e-11)),
        segments(static_cast<int>(number_parameter(input, "segments"))),
        water{.dynamic_viscosity = number_parameter(input, "viscosity", 1e-3)} {
    if (motion != "breathing" && motion != "flipping")
      throw std::invalid_argument("motion = \"" + motion + "\"; accepted: \"breathing\", \"flipping\"");
  }

  double phase(double time) const { return 2.0 * std::numbers::pi * time; }
  /// After `step` steps.
  double aperture_at(double time, long step) const {
    if (motion == "flipping") return aperture + (step % 2 == 1 ? rate * time_step : 0.0);
    return aperture * (1.0 + amplitude * std::sin(phase(time)));
  }

  std::string motion;
  double aperture, length, pressure, start, amplitude, rate, duration, time_step, tolerance;
  int segments;
  Water water;
};

/// A crack that is full up to `start` and dry beyond: a full one of that length, grown.
FillingMarch partly_full(const Plan& plan) {
  const CrackLine line = straight_crack(plan.length, plan.segments);
  const int wet = static_cast<int>(std::lround(plan.start / plan.length * plan.segments));
  const auto apertures = [&](int segments) {
    return std::vector<double>(static_cast<std::size_t>(segments) + 1, plan.aperture);
  };
  if (wet == 0) return {line, plan.water, apertures(plan.segments), {.initially_full = false}};
  FillingMarch march({std::vector<double>(static_cast<std::size_t>(wet), line.lengths[0]), {}}, plan.water,
                     apertures(wet));
  march.grow(line, apertures(plan.segments));
  return march;
}

void march(const Plan& plan, StudyOutput& output, simulation::Ledger& ledger) {
  FillingMarch march = partly_full(plan);
  std::vector<double> apertures(static_cast<std::size_t>(plan.segments) + 1);
  const long steps = std::lround(plan.duration / plan.time_step);
  double least_pressure = 0.0, least_void = 0.0, product = 0.0, most_water = 0.0;
  for (long step = 1; step <= steps; ++step) {
    std::fill(apertures.begin(), apertures.end(), plan.aperture_at(plan.time_step * static_cast<double>(step), step));
    const MarchState& state = march.step(apertures, {plan.pressure, {}}, plan.time_step);
    if (state.status != ProfileStatus::converged) {
      output.summary.status = "stopped: the water was not found to round-off in step " + std::to_string(step);
      break;
    }
    const PressureProfile& p = march.profile();
    for (std::size_t node = 0; node < apertures.size(); ++node) {
      const double capacity = state.capacities[node];
      least_pressure = std::min(least_pressure, p.pressure[node]);
      least_void = std::min(least_void, state.voids[node] / capacity);
      product = std::max(product, p.pressure[node] * state.voids[node] / (plan.pressure * capacity));
      most_water = std::max(most_water, (capacity - state.voids[node]) / capacity);
    }
  }
  const MarchState& state = march.state();
  const double error = std::abs(state.balance_error);
  results::Quantity& quantities = output.summary.quantities;
  quantities["front_position"] = state.front_position;
  quantities["water_volume_error"] = error > 0.0 ? error / std::fmax(state.moved, error) : 0.0;
  quantities["water_error"] = error / (state.moved + state.content);
  quantities["least_pressure"] = least_pressure;
  quantities["least_void"] = least_void;
  quantities["pressure_times_void"] = product;
  quantities["most_water"] = most_water;
  ledger.count("steps", state.steps);
  ledger.count("gradient_evaluations", state.gradient_evaluations);
}

void track(const Plan& plan, StudyOutput& output, simulation::Ledger& ledger) {
  const CrackMotion motion = [&](double time, std::span<double> apertures, std::span<double> rates) {
    std::fill(apertures.begin(), apertures.end(), plan.aperture_at(time, 0));
    std::fill(rates.begin(), rates.end(),
              plan.aperture * plan.amplitude * 2.0 * std::numbers::pi * std::cos(plan.phase(time)));
    return plan.pressure;
  };
  FrontTracker tracker(straight_crack(plan.length, plan.segments), plan.water, motion, {.tolerance = plan.tolerance});
  const FrontTrack front = tracker.track(plan.start, 0.0, plan.duration);
  if (front.status != FrontStatus::reached_time) output.summary.status = "stopped: the front could not be followed";
  output.summary.quantities["front_position"] = front.position;
  ledger.count("steps", front.steps);
}

}  // namespace

StudyOutput run_crack_water_motion(const StudyInput& input) {
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "crackwater", "motion");
    const Plan plan(input);
    if (plan.time_step > 0.0) {
      march(plan, output, ledger);
    } else {
      track(plan, output, ledger);
    }
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
