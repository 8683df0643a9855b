/// The constant of a wet region: by a search of choice, to round-off or to a tolerance, and what a jump of the flow law
/// at Re = 2300 makes of it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crackwater/pressure_profile.hpp"

namespace sunder::crackwater {

using numerics::BracketedRoot;
using numerics::Residual;
using numerics::RootStatus;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

numerics::RootMethod method_of(Search search) {
  switch (search) {
    case Search::bisection:
      return numerics::RootMethod::bisection;
    case Search::itp:
      return numerics::RootMethod::itp;
    case Search::toms748:
      return numerics::RootMethod::toms748;
    case Search::newton:
    case Search::prefix_moments:
      return numerics::RootMethod::newton;
  }
  return numerics::RootMethod::bisection;
}

/// Prefix sums find, sweeps decide.
class SweepsOnly {
 public:
  explicit SweepsOnly(bool& use_prefix) : use_prefix_(use_prefix), before_(use_prefix) { use_prefix_ = false; }
  ~SweepsOnly() { use_prefix_ = before_; }
  SweepsOnly(const SweepsOnly&) = delete;
  SweepsOnly& operator=(const SweepsOnly&) = delete;

 private:
  bool& use_prefix_;
  bool before_;
};

}  // namespace

/// The root of a residual that falls with c, as a region whose ends the caller fills in.
PressureSolver::Region PressureSolver::find(numerics::RootFunction residual, double lower, double upper) {
  numerics::RootOptions options;
  options.method = method_of(options_.search);
  options.max_evaluations = options_.max_evaluations;
  options.guess = guess_;
  const bool coarse = options_.relative_tolerance > 0.0;
  if (coarse) options.relative_tolerance = options_.relative_tolerance;
  Region region;
  BracketedRoot root = bracketed_root(residual, lower, upper, options);
  if (coarse && root.status == RootStatus::bracket_within_tolerance) {
    if (settles(residual, root.lower, region)) return region;
    options.relative_tolerance = numerics::RootOptions{}.relative_tolerance;
    root = bracketed_root(residual, lower, upper, options);
  }
  if (use_prefix_) root = confirm(residual, root, lower, upper, options);
  region.constant = region.constant_beyond = root.root;
  switch (root.status) {
    case RootStatus::residual_within_tolerance:
      break;
    case RootStatus::bracket_within_tolerance:
      take_both_sides(residual, root, region);
      break;
    case RootStatus::evaluation_limit:
    case RootStatus::no_sign_change:
    case RootStatus::not_finite:
      profile_.status = ProfileStatus::not_converged;
      break;
  }
  profile_.residual = std::max(profile_.residual, std::abs(root.residual));
  return region;
}

/// Whether the lower end of a bracket as narrow as the tolerance will do: there p ≥ 0 everywhere, the upper one would
/// cavitate where the sought profile does not. Not where the residual jumps inside it: only round-off tells where.
bool PressureSolver::settles(numerics::RootFunction residual, double lower, Region& region) {
  const SweepsOnly sweeps(use_prefix_);
  const Residual low = residual(lower, false);
  // a loss grows no faster than the square of the flux: a smooth residual is smaller than this
  const double smooth = options_.relative_tolerance * low.floor / epsilon;
  if (!(low.value >= -low.floor && low.value <= smooth)) return false;
  region.constant = region.constant_beyond = lower;
  profile_.residual = std::max(profile_.residual, std::abs(low.value));
  return true;
}

/// What the prefix sums found, confirmed by sweeps and mended by a Newton step or two. At a jump the sums know where to
/// 1e-12 of the bracket, and sweeps find which number.
BracketedRoot PressureSolver::confirm(numerics::RootFunction residual, BracketedRoot root, double lower, double upper,
                                      const numerics::RootOptions& options) {
  const SweepsOnly sweeps(use_prefix_);
  const double found = root.root;
  double c = found;
  for (int attempt = 0; attempt < 4 && c >= lower && c <= upper; ++attempt) {
    const Residual r = residual(c, true);
    root.root = c;
    root.residual = r.value;
    root.status = RootStatus::residual_within_tolerance;
    if (std::abs(r.value) <= r.floor) return root;
    c -= r.value / r.slope;
  }
  const double reach = 1e-12 * (upper - lower);
  root = bracketed_root(residual, std::max(lower, found - reach), std::min(upper, found + reach), options);
  return root.status == RootStatus::no_sign_change ? bracketed_root(residual, lower, upper, options) : root;
}

/// Where the residual jumps across zero: both sides, mixed so that the pressure is met.
void PressureSolver::take_both_sides(numerics::RootFunction residual, const BracketedRoot& root, Region& region) {
  const SweepsOnly sweeps(use_prefix_);
  const Residual below = residual(root.lower, false), above = residual(root.upper, false);
  if (!(below.value > 0.0 && above.value < 0.0)) return;
  region.constant = root.lower;
  region.constant_beyond = root.upper;
  region.share = below.value / (below.value - above.value);
  // a steep but continuous residual also misses its floor from one number to the next, but not by this much
  if (below.value - above.value <= 1e6 * (below.floor + above.floor)) return;
  profile_.at_regime_jump = true;
  profile_.turbulent_share = region.share;
}

}  // namespace sunder::crackwater
