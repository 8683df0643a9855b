#include "solver/crackwater/pressure_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/crackwater/check.hpp"
#include "solver/crackwater/segment_pieces.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;
using numerics::Residual;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void check(const CrackLine& line, std::span<const double> apertures, std::span<const double> rates) {
  const std::size_t nodes = line.lengths.size() + 1;
  const auto require_nodes = [&](const char* name, std::size_t count) {
    if (count != nodes) refuse(name, static_cast<double>(count), "the number of segments + 1");
  };
  require_nodes("number of apertures", apertures.size());
  require_nodes("number of rates", rates.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    require_positive("apertures[" + std::to_string(node) + "]", apertures[node]);
    require_finite("rates[" + std::to_string(node) + "]", rates[node]);
  }
}

PressureSolver::PressureSolver(const CrackLine& line, const Water& water, const ProfileOptions& options)
    : options_(options), table_(line, flow_law(water), options.quadrature) {
  require_not_negative("relative_tolerance", options.relative_tolerance);
  if (options.relative_tolerance >= 1.0) refuse("relative_tolerance", options.relative_tolerance, "< 1");
  if (options.max_evaluations < 3) refuse("max_evaluations", options.max_evaluations, ">= 3");
  const std::size_t segments = line.lengths.size();
  profile_.pressure.assign(segments + 1, 0.0);
  profile_.nodal_force.assign(segments + 1, 0.0);
  // a wet region ends and another begins at least half a segment on: V is quadratic in a segment
  profile_.wet_regions.reserve(2 * segments + 2);
  regions_.reserve(2 * segments + 2);
  const std::size_t padded = static_cast<std::size_t>(table_.padded_count());
  for (auto* values : {&loss_, &to_first_, &to_last_}) values->assign(padded, 0.0);
}

const PressureProfile& PressureSolver::solve(std::span<const double> apertures, std::span<const double> rates,
                                             const MouthPressures& mouths) noexcept {
  return table_.fill(apertures, rates) ? solve_filled(mouths) : give_nothing();
}

const PressureProfile& PressureSolver::give_nothing() noexcept {
  (void)reset({nan, {}});
  return profile_;
}

bool PressureSolver::reset(const MouthPressures& mouths) {
  PressureProfile& p = profile_;
  std::fill(p.pressure.begin(), p.pressure.end(), 0.0);
  std::fill(p.nodal_force.begin(), p.nodal_force.end(), 0.0);
  p.wet_regions.clear();
  regions_.clear();
  p.uplift_force = p.uplift_moment = p.upstream_flux = p.downstream_flux = p.front_position = 0.0;
  p.peak_pressure = p.peak_position = p.turbulent_share = p.residual = 0.0;
  p.cavitated = p.at_regime_jump = false;
  p.residual_evaluations = 0;
  p.gradient_evaluations = 0;
  mouths_ = mouths;
  open_ = mouths.downstream.has_value();
  upstream_ = std::max(mouths.upstream, 0.0);
  if (planted_fault("crackwater/mouth-pressure-halved")) upstream_ *= 0.5;
  downstream_ = open_ ? std::max(*mouths.downstream, 0.0) : 0.0;
  if (open_ && planted_fault("crackwater/far-mouth-as-the-near-one")) downstream_ = upstream_;
  p.mouth_below_zero = mouths.upstream < 0.0 || (open_ && *mouths.downstream < 0.0);
  use_prefix_ = false;
  lowest_pressure_ = magnitude_ = 0.0;
  const bool usable = std::isfinite(mouths.upstream) && (!open_ || std::isfinite(*mouths.downstream));
  p.status = usable ? ProfileStatus::converged : ProfileStatus::unusable_input;
  return usable;
}

const PressureProfile& PressureSolver::solve_filled(const MouthPressures& mouths) noexcept {
  if (!reset(mouths)) return profile_;
  const bool level = !table_.inclined();
  if (open_ && level && options_.search == Search::prefix_moments && solve_pure()) {
    finish();
    return profile_;
  }
  if (level && table_.never_closing() && !table_.never_opening()) {
    solve_never_closing();
  } else {
    solve_through();
    const bool sound = level && table_.never_opening();  // p falls towards the mouths only: no minimum inside
    if (!sound && lowest_pressure_ < -round_off(magnitude_) && !planted_fault("crackwater/clipped-cavitation")) {
      const int evaluations = profile_.residual_evaluations;
      const long long gradients = profile_.gradient_evaluations;
      reset(mouths);
      profile_.residual_evaluations = evaluations;
      profile_.gradient_evaluations = gradients;
      solve_general();
    }
  }
  finish();
  return profile_;
}

// ---- the searches ---------------------------------------------------------------------------------------------------

Loss PressureSolver::range_loss(double c, int first, int last, bool wants_slope) {
  if (use_prefix_) {
    profile_.gradient_evaluations += std::min(2, last - first);  // the two in which the regime changes
    return table_.prefix_loss(c, first, last);
  }
  profile_.gradient_evaluations += last - first;
  return table_.loss(c, first, last, wants_slope);
}

/// p(L) - p_down where the whole crack is wet.
Residual PressureSolver::through_residual(double c, bool wants_slope) {
  ++profile_.residual_evaluations;
  const int n = table_.count();
  const Loss loss = range_loss(c, 0, n, wants_slope);
  const double weight = table_.weight(n);
  return {(upstream_ - downstream_ - weight) - loss.value, -loss.slope,
          round_off(loss.magnitude + upstream_ + downstream_ + table_.climb())};
}

std::pair<double, double> PressureSolver::flux_bracket() const {
  const int n = table_.count();
  const double cubes = table_.inverse_cubes(0, n);
  const double head_in = std::max(upstream_ - downstream_, 0.0) + table_.climb();
  const double head_back = std::max(downstream_ - upstream_, 0.0) + table_.climb();
  double run_back = 0.0;
  if (table_.inclined()) {
    for (int i = 0; i < n; ++i) {
      const double rise = table_.weight(i + 1) - table_.weight(i);
      const double w = std::max(table_.aperture(i), table_.aperture(i + 1));
      run_back = std::max(run_back, flux_of_resistance(table_.law(), rise / table_.length(i) * w * w * w));
    }
  }
  // more than the round-off of the sums: the flux may be just that of a resting crack
  const double widening = 1.0 + 1e-12;
  return {table_.least_change() - widening * (flux_of_resistance(table_.law(), head_back / cubes) + run_back),
          table_.greatest_change() + widening * flux_of_resistance(table_.law(), head_in / cubes)};
}

/// One regime and one direction over the whole crack: the flux is the root of a quadratic or linear equation.
bool PressureSolver::solve_pure() {
  const auto [s0, s1, s2] = table_.totals();
  const FlowLaw& law = table_.law();
  const double head = upstream_ - downstream_;
  const double least = table_.least_change(), greatest = table_.greatest_change();
  double c = nan;
  const double forwards = s1 * s1 - s0 * (s2 - head / law.turbulent);
  const double backwards = s1 * s1 - s0 * (s2 + head / law.turbulent);
  const double slow = (s1 + head / law.laminar) / s0;
  if (forwards > 0.0 && (s1 + std::sqrt(forwards)) / s0 - greatest > law.critical_flux) {
    c = (s1 + std::sqrt(forwards)) / s0;
  } else if (backwards > 0.0 && (s1 - std::sqrt(backwards)) / s0 - least < -law.critical_flux) {
    c = (s1 - std::sqrt(backwards)) / s0;
  } else if (slow - least <= law.critical_flux && slow - greatest >= -law.critical_flux &&
             (table_.never_opening() || slow >= greatest || slow <= least)) {
    c = slow;
  } else if (table_.never_opening() && table_.never_closing()) {  // at rest inside the jump
    const double below = head - std::copysign(law.laminar * law.critical_flux * s0, head);
    const double above = head - std::copysign(law.turbulent * law.critical_flux * law.critical_flux * s0, head);
    Region region;
    region.constant = std::copysign(law.critical_flux, head);
    region.constant_beyond = std::copysign(std::nextafter(law.critical_flux, 1e300), head);
    region.share = below / (below - above);
    region.start_pressure = upstream_;
    region.end = {table_.count() - 1, 1.0};
    region.to_mouth = true;
    profile_.at_regime_jump = true;
    profile_.turbulent_share = region.share;
    place(region);
    return true;
  } else {
    return false;
  }
  // The sums may have cancelled; a sweep tells, and a Newton step mends it.
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Residual r = through_residual(c, true);
    profile_.residual = std::abs(r.value);
    if (std::abs(r.value) <= r.floor) {
      Region region;
      region.constant = region.constant_beyond = c;
      region.start_pressure = upstream_;
      region.end = {table_.count() - 1, 1.0};
      region.to_mouth = true;
      place(region);
      return true;
    }
    c -= r.value / r.slope;
  }
  profile_.residual = 0.0;
  return false;
}

void PressureSolver::solve_through() {
  Region region;
  if (!open_) {
    region.constant = region.constant_beyond = table_.tip_change();
    region.closed = true;
  } else {
    use_prefix_ = options_.search == Search::prefix_moments;
    const auto [lower, upper] = flux_bracket();
    auto residual = [this](double c, bool wants_slope) { return through_residual(c, wants_slope); };
    region = find(numerics::RootFunction(residual), lower, upper);
    use_prefix_ = false;
    region.to_mouth = true;
  }
  region.start_pressure = upstream_;
  region.end = {table_.count() - 1, 1.0};
  place(region);
}

}  // namespace sunder::crackwater
