#include "solver/crackwater/filling_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/crackwater/check.hpp"
#include "solver/crackwater/lanes.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

FillingMarch::FillingMarch(const CrackLine& line, const Water& water, std::span<const double> apertures,
                           const MarchOptions& options)
    : water_(water), options_(options), solver_(line, water, {.search = options.search}) {
  const std::size_t nodes = line.lengths.size() + 1;
  check(line, apertures, std::vector<double>(nodes, 0.0));
  allocate(nodes);
  capacities(apertures, state_.capacities);
  if (!options.initially_full) state_.voids = state_.capacities;
  state_.content = first_content_ = total_content();
  state_.front_position = front_position();
}

void FillingMarch::allocate(std::size_t nodes) {
  for (auto* values : {&state_.voids, &state_.capacities, &next_capacities_, &changes_, &rates_})
    values->assign(nodes, 0.0);
  flux_.assign(nodes - 1, 0.0);
  full_.assign(nodes, 0);
}

void FillingMarch::capacities(std::span<const double> apertures, std::vector<double>& values) const {
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double sixth = solver_.table().length(static_cast<int>(i)) / 6.0;
    values[i] += sixth * (2.0 * apertures[i] + apertures[i + 1]);
    values[i + 1] += sixth * (apertures[i] + 2.0 * apertures[i + 1]);
  }
}

double FillingMarch::total_content() const {
  CompensatedSum content;
  for (std::size_t node = 0; node < state_.voids.size(); ++node) {
    content.add(state_.capacities[node]);
    content.add(-state_.voids[node]);
  }
  return content.value();
}

/// Fluxes over the segments and the mouths, and which nodes are full, from the wet regions of the solve.
void FillingMarch::fluxes() {
  const SegmentTable& table = solver_.table();
  const MouthPressures& mouths = solver_.mouths();
  const int n = table.count();
  std::fill(flux_.begin(), flux_.end(), 0.0);
  std::fill(full_.begin(), full_.end(), static_cast<char>(0));
  // mouths that no wet region reaches: what does not fit into their node leaves by them
  upstream_flux_ = std::min(rates_.front(), 0.0);
  downstream_flux_ = mouths.downstream ? std::max(-rates_.back(), 0.0) : 0.0;
  full_.front() = upstream_flux_ < 0.0;
  full_.back() = downstream_flux_ > 0.0;
  for (const PressureSolver::Region& region : solver_.regions()) {
    const int first = region.start.segment;
    const int last = region.end.y == 1.0 ? region.end.segment + 1 : region.end.segment;  // nodes
    // The flux changes by R from one full node to the next: summed from the region's start, not from differences of V,
    // which hold the voids of all the crack before.
    double q = first == 0 ? region.constant - rates_[0] : region.constant - table.middle_change(first);
    if (first == 0) {
      // a mouth without water above it gives none
      upstream_flux_ = mouths.upstream > 0.0 ? region.constant : std::min(region.constant, 0.0);
      full_[0] = upstream_flux_ == region.constant;
    }
    for (int i = first; i < last; ++i) {
      flux_[static_cast<std::size_t>(i)] = q;
      if (i + 1 < last) {
        q -= rates_[static_cast<std::size_t>(i) + 1];
        full_[static_cast<std::size_t>(i) + 1] = 1;
      }
    }
    if (last == n && (region.closed || region.to_mouth)) {
      const double through = q - rates_[static_cast<std::size_t>(n)];
      const bool wet_mouth = mouths.downstream.value_or(0.0) > 0.0;
      downstream_flux_ = region.closed ? 0.0 : (wet_mouth ? through : std::max(through, 0.0));
      full_[static_cast<std::size_t>(n)] = region.closed || downstream_flux_ == through;
    }
  }
}

const PressureProfile& FillingMarch::trial(std::span<const double> apertures, const MouthPressures& mouths,
                                           double time_step) noexcept {
  const std::size_t nodes = state_.voids.size();
  tried_ = false;
  if (apertures.size() != nodes || !(time_step > 0.0) || !std::isfinite(time_step)) return solver_.give_nothing();
  capacities(apertures, next_capacities_);
  CompensatedSum change;
  for (std::size_t node = 0; node < nodes; ++node) {
    const double space = planted_fault("crackwater/void-forgotten") ? 0.0 : state_.voids[node];
    rates_[node] = (space + (next_capacities_[node] - state_.capacities[node])) / time_step;
    change.add(rates_[node]);
    changes_[node] = change.value();
  }
  if (!solver_.table_for_march().fill_steps(apertures, changes_)) return solver_.give_nothing();
  if (state_.steps > 0) solver_.suggest(upstream_flux_);
  const PressureProfile& profile = solver_.solve_filled(mouths);
  tried_ = profile.status != ProfileStatus::unusable_input;
  if (tried_) time_step_ = time_step;
  return profile;
}

const MarchState& FillingMarch::accept() noexcept {
  if (!tried_) return state_;
  tried_ = false;
  const PressureProfile& profile = solver_.profile();
  const std::size_t nodes = state_.voids.size();
  state_.status = profile.status;
  fluxes();
  for (std::size_t node = 0; node < nodes; ++node) {
    const double in = node == 0 ? upstream_flux_ : flux_[node - 1];
    const double out = node + 1 == nodes ? downstream_flux_ : flux_[node];
    const double next =
        state_.voids[node] + (next_capacities_[node] - state_.capacities[node]) - time_step_ * (in - out);
    state_.voids[node] = full_[node] ? 0.0 : std::clamp(next, 0.0, next_capacities_[node]);
  }
  std::swap(state_.capacities, next_capacities_);
  state_.time += time_step_;
  inflow_.add(time_step_ * upstream_flux_);
  outflow_.add(time_step_ * downstream_flux_);
  state_.inflow = inflow_.value();
  state_.outflow = outflow_.value();
  state_.moved += time_step_ * (std::abs(upstream_flux_) + std::abs(downstream_flux_));
  state_.content = total_content();
  state_.balance_error = (state_.content - first_content_) - (state_.inflow - state_.outflow);
  state_.residual_evaluations += profile.residual_evaluations;
  state_.gradient_evaluations += profile.gradient_evaluations;
  ++state_.steps;
  state_.front_position = front_position();
  return state_;
}

const MarchState& FillingMarch::step(std::span<const double> apertures, const MouthPressures& mouths,
                                     double time_step) noexcept {
  state_.status = trial(apertures, mouths, time_step).status;
  return accept();
}

double FillingMarch::front_position() const {
  const SegmentTable& table = solver_.table();
  const auto first_void = std::find_if(state_.voids.begin(), state_.voids.end(), [](double v) { return v > 0.0; });
  const int node = static_cast<int>(first_void - state_.voids.begin()), n = table.count();
  if (node > n) return table.position(n);
  const double before = node > 0 ? 0.5 * table.length(node - 1) : 0.0,
               after = node < n ? 0.5 * table.length(node) : 0.0;
  const double filled = 1.0 - *first_void / state_.capacities[static_cast<std::size_t>(node)];
  return table.position(node) - before + filled * (before + after);
}

void FillingMarch::grow(const CrackLine& line, std::span<const double> apertures) {
  const std::size_t nodes = line.lengths.size() + 1;
  PressureSolver longer(line, water_, {.search = options_.search});
  check(line, apertures, std::vector<double>(nodes, 0.0));
  const SegmentTable &before = solver_.table(), &after = longer.table();
  const double reach = before.position(before.count()), length = after.position(after.count());
  // lengths that were added up in another order may differ by their round-off
  if (length < reach * (1.0 - 1e-12)) refuse("length of the grown crack", length, "at least that before");
  const auto border = [](const SegmentTable& table, int node) {  // where the volume of `node` ends
    return table.position(node) + (node < table.count() ? 0.5 * table.length(node) : 0.0);
  };
  std::vector<double> water(nodes, 0.0);
  int owner = 0;
  double from = 0.0;
  for (int node = 0; node <= before.count(); ++node) {
    const std::size_t k = static_cast<std::size_t>(node);
    const double start = from, end = border(before, node), held = state_.capacities[k] - state_.voids[k];
    double given = 0.0;
    for (; owner < after.count() && border(after, owner) < end; ++owner) {
      const double share = held * (border(after, owner) - from) / (end - start);
      water[static_cast<std::size_t>(owner)] += share;
      given += share;
      from = border(after, owner);
    }
    water[static_cast<std::size_t>(owner)] += held - given;
    from = end;
  }
  solver_ = std::move(longer);
  allocate(nodes);
  capacities(apertures, state_.capacities);
  for (std::size_t node = 0; node < nodes; ++node) state_.voids[node] = state_.capacities[node] - water[node];
  if (planted_fault("crackwater/new-part-wet")) std::fill(state_.voids.begin(), state_.voids.end(), 0.0);
  carry_excess();
  state_.content = total_content();
  state_.front_position = front_position();
  upstream_flux_ = downstream_flux_ = std::numeric_limits<double>::quiet_NaN();  // no guess for the next search
  tried_ = false;
}

MarchMemory FillingMarch::memory() const {
  return {.state = state_,
          .inflow = inflow_,
          .outflow = outflow_,
          .first_content = first_content_,
          .upstream_flux = upstream_flux_,
          .downstream_flux = downstream_flux_};
}

void FillingMarch::go_on(const MarchMemory& memory) {
  if (memory.state.voids.size() != state_.voids.size() || memory.state.capacities.size() != state_.voids.size()) {
    refuse("nodes of the march to go on with", static_cast<double>(memory.state.voids.size()), "those of the crack");
  }
  state_ = memory.state;
  if (planted_fault("crackwater/memory-without-water")) std::fill(state_.voids.begin(), state_.voids.end(), 0.0);
  inflow_ = memory.inflow;
  outflow_ = memory.outflow;
  first_content_ = memory.first_content;
  upstream_flux_ = memory.upstream_flux;
  downstream_flux_ = memory.downstream_flux;
  tried_ = false;
}

/// Voids below zero are water that a node cannot hold: towards the tip, then back to the mouth and out.
void FillingMarch::carry_excess() {
  double excess = 0.0;
  const auto pass = [&](double& free) {
    free -= excess;
    excess = std::max(-free, 0.0);
    free = std::max(free, 0.0);
  };
  std::for_each(state_.voids.begin(), state_.voids.end(), pass);
  std::for_each(state_.voids.rbegin(), state_.voids.rend(), pass);
  inflow_.add(-excess);
  state_.inflow = inflow_.value();
  state_.moved += excess;
}

}  // namespace sunder::crackwater
