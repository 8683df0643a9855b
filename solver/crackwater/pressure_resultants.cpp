/// What is reported of a pressure profile once it is laid: fluxes through the mouths, front, forces.

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crackwater/lanes.hpp"
#include "solver/crackwater/pressure_profile.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

namespace {
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}  // namespace

void PressureSolver::finish() {
  guess_ = nan;
  PressureProfile& out = profile_;
  const int n = table_.count();
  const double round_off = 32.0 * epsilon * magnitude_;
  double wet = 0.0;
  out.downstream_flux = 0.0;
  for (const Region& region : regions_) {
    const double start = table_.position(region.start), end = table_.position(region.end);
    const double c = (1.0 - region.share) * region.constant + region.share * region.constant_beyond;
    if (region.start.segment == 0 && region.start.y == -1.0) {
      out.upstream_flux = c;
      out.front_position = planted_fault("crackwater/front-at-its-mouth") ? start : end;
    }
    if (region.to_mouth) {
      out.downstream_flux = c - table_.tip_change();
      double& last = out.pressure[static_cast<std::size_t>(n)];
      if (std::abs(last - downstream_) <= round_off) last = downstream_;
    }
    if (end > start) {
      wet += end - start;
      out.wet_regions.push_back({start, end, c});
    }
  }
  if (planted_fault("crackwater/peak-from-the-far-mouth")) out.peak_position = table_.position(n) - out.peak_position;
  out.cavitated = wet < table_.position(n) * (1.0 - 4.0 * epsilon);
  for (int node = 0; node <= n; ++node) {
    double& p = out.pressure[static_cast<std::size_t>(node)];
    if (p > 0.0) continue;
    if (p >= -round_off) p = std::max(p, 0.0);  // what rounding leaves next to a front or at a mouth without pressure
    if (p < 0.0 && !planted_fault("crackwater/clipped-cavitation")) out.status = ProfileStatus::not_converged;
  }
  if (table_.flat() || planted_fault("crackwater/nodal-trapezoid")) {
    for (int node = 0; node <= n; ++node) {
      const double before = node > 0 ? table_.length(node - 1) : 0.0, after = node < n ? table_.length(node) : 0.0;
      out.nodal_force[static_cast<std::size_t>(node)] =
          0.5 * (before + after) * out.pressure[static_cast<std::size_t>(node)];
    }
  }
  const double* force = out.nodal_force.data();
  out.uplift_force = blocked_sum(
      0, n + 1, [&](int j) { return force[j]; }, [&](int j) { return load(force + j); });
  const double* position = table_.positions().data();
  out.uplift_moment = blocked_sum(
      0, n + 1, [&](int j) { return force[j] * position[j]; },
      [&](int j) { return load(force + j) * load(position + j); });
}

const PressureProfile& PressureSolver::uniform(double upstream_pressure) noexcept {
  if (!reset({upstream_pressure, {}})) return profile_;
  PressureProfile& out = profile_;
  const int n = table_.count();
  const auto pressure = [&](int node) { return std::max(upstream_ - table_.weight(node), 0.0); };
  CompensatedSum force, moment;
  for (int node = 0; node <= n; ++node) {
    const double p = pressure(node);
    const std::size_t k = static_cast<std::size_t>(node);
    out.pressure[k] = p;
    // linear between nodes: ∫ N_j p ds of a linear p
    double nodal = 0.0;
    if (node > 0) nodal += table_.length(node - 1) * (2.0 * p + pressure(node - 1)) / 6.0;
    if (node < n) nodal += table_.length(node) * (2.0 * p + pressure(node + 1)) / 6.0;
    out.nodal_force[k] = nodal;
    force.add(nodal);
    moment.add(nodal * table_.position(node));
    if (p > out.peak_pressure) {
      out.peak_pressure = p;
      out.peak_position = table_.position(node);
    }
  }
  out.uplift_force = force.value();
  out.uplift_moment = moment.value();
  out.front_position = table_.position(n);
  out.wet_regions.push_back({0.0, table_.position(n), 0.0});
  return out;
}

}  // namespace sunder::crackwater
