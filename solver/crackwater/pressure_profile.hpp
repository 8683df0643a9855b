#pragma once
/// Water pressure along a crack whose faces move: where the crack is wet, what the water presses, what flows through
/// the mouths.
///
/// The water is incompressible and without inertia; the crack was full just before. With s from the upstream mouth [m],
/// aperture w [m], opening rate v = dw/dt [m/s] and the flux q [m²/s]:
///
///     q = c - V,  V(s) = ∫₀ˢ v ds                                     continuity            [seed paper, Eq. (7)]
///     dp/ds = -φ(q)/w³ - ρ g dz/ds                                    flow law              [seed paper, Eqs.
///     (9)-(11)] 0 ≤ p,  0 ≤ dm/ds,  p dm/ds = 0  with m = q + V                 water leaves the faces rather than be
///     pulled
///
/// m is constant, = c, in every wet region and grows where p = 0: that growth is void. It is the minimum of a strictly
/// convex functional over non-decreasing m, so pressure and flux are unique. At a front p = 0 and dp/ds = 0 (for a
/// horizontal crack: q = 0); in a void the water stands, or runs down an inclined crack as a full one would. Any number
/// of wet regions with voids between them can come out: from either mouth and, where the faces close inside, islands.
///
/// The regions are found from the upstream mouth on: c is the largest constant for which p ≥ 0 up to the other end, so
/// it is the root of a monotone function of c, min(lowest local minimum of p, p(L) - p_down) = 0, and the region ends
/// where that minimum lies. A void follows as far as V grows; where it stops growing lies the next region, found in the
/// same way.
///
/// The flux is bracketed by physics: min V - q_s ≤ c ≤ max V + q_s with q_s the flux of a resting crack under the same
/// heads.

#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/crackwater/flow_law.hpp"
#include "solver/crackwater/segment_table.hpp"
#include "solver/numerics/bracketed_root.hpp"
#include "solver/numerics/compensated_sum.hpp"

namespace sunder::crackwater {

enum class Search {
  bisection,  ///< the seed paper's
  itp,
  toms748,
  newton,
  prefix_moments,  ///< closed form where the whole crack flows one way in one regime; else Newton's method on prefix
                   ///< sums, O(log n) a residual, confirmed by sweeps; as `newton` where the opening rate changes its
                   ///< sign
};

struct ProfileOptions {
  Quadrature quadrature = Quadrature::exact;
  Search search = Search::prefix_moments;
  double relative_tolerance = 0.0;  ///< of the flux, upper - lower ≤ tolerance · max|bracket|; 0: to round-off
  int max_evaluations = 400;        ///< residuals a wet region
};

/// Pressures at the ends [Pa above atmospheric]. A mouth below zero is dry: it counts as zero and is reported.
struct MouthPressures {
  double upstream = 0.0;
  std::optional<double> downstream;  ///< absent: closed tip
};

enum class ProfileStatus {
  converged,
  not_converged,   ///< the best answer is given; `residual` says how far it is off
  unusable_input,  ///< a value is not finite, an aperture is not > 0, or a length is wrong; nothing is given
};

struct WetRegion {
  double start = 0.0, end = 0.0;  ///< s [m]
  double flux_constant = 0.0;     ///< c: flux there + V [m²/s]
};

struct PressureProfile {
  ProfileStatus status = ProfileStatus::unusable_input;
  std::vector<double> pressure;     ///< (n + 1) at the nodes [Pa], ≥ 0
  std::vector<double> nodal_force;  ///< (n + 1) ∫ N_j p ds on one face [N/m], N_j the linear shape function of node j
  std::vector<WetRegion> wet_regions;
  double uplift_force = 0.0;     ///< ∫ p ds [N/m]
  double uplift_moment = 0.0;    ///< ∫ s p ds, about the upstream mouth [N]
  double upstream_flux = 0.0;    ///< into the crack [m²/s]
  double downstream_flux = 0.0;  ///< out of the crack [m²/s]; 0 at a closed tip
  double front_position = 0.0;   ///< end of the region at the upstream mouth [m]
  double peak_pressure = 0.0;    ///< [Pa], not limited in any way
  double peak_position = 0.0;    ///< [m]
  bool cavitated = false;        ///< somewhere the water has left the faces
  bool at_regime_jump = false;   ///< no flux meets the pressures exactly: Re = 2300 over a stretch; p is the mixture of
                                 ///< the laminar and the turbulent profile that does
  double turbulent_share = 0.0;  ///< of that mixture, 0 … 1
  bool mouth_below_zero = false;  ///< a mouth pressure was negative and counted as zero
  double residual = 0.0;          ///< largest |p - required p| at the end of a region [Pa], before mixing
  int residual_evaluations = 0;
  long long gradient_evaluations = 0;  ///< segments visited by the searches
};

/// Throws std::invalid_argument naming the value and its bound where `solve` would answer `unusable_input`: lengths
/// other than (n + 1), apertures not finite and > 0, rates not finite.
void check(const CrackLine& line, std::span<const double> apertures, std::span<const double> rates);

/// Solves one crack again and again; holds all memory, so that a solve allocates nothing and throws nothing.
class PressureSolver {
 public:
  /// Throws std::invalid_argument as the checks of `CrackLine` and `Water`, or where an option is out of range.
  PressureSolver(const CrackLine& line, const Water& water, const ProfileOptions& options = {});

  /// `apertures` [m] and their `rates` [m/s] are (n + 1), from `apertures(…)`: those that the water finds.
  const PressureProfile& solve(std::span<const double> apertures, std::span<const double> rates,
                               const MouthPressures& mouths) noexcept;

  /// All of the crack under the pressure of its upstream mouth, still water and no fronts (the paper's models 1 and 2);
  /// in an inclined crack hydrostatic from there, never below zero.
  const PressureProfile& uniform(double upstream_pressure) noexcept;

  const PressureProfile& profile() const { return profile_; }
  const SegmentTable& table() const { return table_; }
  const ProfileOptions& options() const { return options_; }

  /// The wet regions of the last solve as the tangents and a march want them.
  struct Region {
    Location start, end;
    double constant = 0.0;         ///< c, the laminar side of a jump
    double constant_beyond = 0.0;  ///< the other side of a jump; = constant otherwise
    double share = 0.0;            ///< weight of the profile with `constant_beyond`
    double start_pressure = 0.0;   ///< [Pa]
    bool to_mouth = false;         ///< ends at the open downstream mouth
    bool closed = false;           ///< c is fixed by a closed tip
  };
  std::span<const Region> regions() const { return {regions_.data(), regions_.size()}; }

  /// Where the next solve's search for the flux into the upstream mouth begins [m²/s], with `newton` or
  /// `prefix_moments`; a good guess halves its evaluations. The answer is the same to round-off.
  void suggest(double upstream_flux) { guess_ = upstream_flux; }

  /// For a march: the table filled by the caller.
  SegmentTable& table_for_march() { return table_; }
  const PressureProfile& solve_filled(const MouthPressures& mouths) noexcept;
  /// The profile of unusable input.
  const PressureProfile& give_nothing() noexcept;
  /// Those of the last solve, as they were given.
  const MouthPressures& mouths() const { return mouths_; }

 private:
  /// The lowest local minimum of the pressure for one c, and where it lies.
  struct Minimum {
    numerics::Residual residual;
    Location at;
    bool at_end = false;
  };

  bool reset(const MouthPressures& mouths);
  bool solve_pure();
  void solve_through();
  void solve_never_closing();
  void solve_general();
  void place(Region region);
  void mix(Region& region);
  void note_mixed_extremes(const Region& region);
  double lay(const Region& region, double c, double share);
  void lay_block(int first, int last, double c, double share, numerics::CompensatedSum& pressure);
  void lay_whole(int first, int last, double c, double share, double& pressure);
  struct Stretch;
  Stretch cut_stretch(int segment, double from, double to, double c) const;
  void note_extremes(int segment, double from, double to, double c, double pressure);
  void lay_part(int segment, double from, double to, double c, double share, double& pressure);
  void finish();

  Region find(numerics::RootFunction residual, double lower, double upper);
  bool settles(numerics::RootFunction residual, double lower, Region& region);
  numerics::BracketedRoot confirm(numerics::RootFunction residual, numerics::BracketedRoot root, double lower,
                                  double upper, const numerics::RootOptions& options);
  void take_both_sides(numerics::RootFunction residual, const numerics::BracketedRoot& root, Region& region);
  double stationary_point(int segment, double c) const;
  numerics::Residual through_residual(double c, bool wants_slope);
  numerics::Residual front_residual(double c, bool wants_slope);
  numerics::Residual far_residual(double c, bool wants_slope);
  Loss range_loss(double c, int first, int last, bool wants_slope);
  Location crossing_of(double c) const;
  Minimum lowest(Location start, double start_pressure, double c);
  Location first_descent(Location from) const;
  Location rise_to(Location from, Location to, double c) const;
  double free_constant(int segment, double y) const;
  std::pair<double, double> flux_bracket() const;

  ProfileOptions options_;
  SegmentTable table_;
  PressureProfile profile_;
  std::vector<Region> regions_;
  std::vector<double> loss_, to_first_, to_last_;
  MouthPressures mouths_;
  double upstream_ = 0.0, downstream_ = 0.0;  // what counts of them
  double lowest_pressure_ = 0.0, magnitude_ = 0.0, peak_before_ = 0.0, peak_position_before_ = 0.0;
  double guess_ = std::numeric_limits<double>::quiet_NaN();
  bool open_ = false, use_prefix_ = false;
};

}  // namespace sunder::crackwater
