#pragma once
/// The crack cut into segments, with everything that the search for its flux asks of a segment worked out beforehand.
///
/// Inside segment i, y ∈ [-1, 1], the aperture w is linear and the flux q = c - V with V = V_m + α y + β y² (the
/// opening rate is linear too), where c is the flux at the mouth plus what opened voids have taken. With A_j = ∫ (V -
/// V_m)^j w⁻³ ds the friction loss of a segment in one regime is exact and costs a few multiplications, d = c - V_m:
///
///     laminar     ∫ φ w⁻³ ds = a (A_0 d - A_1)
///     turbulent   ∫ φ w⁻³ ds = ± b (A_0 d² - 2 A_1 d + A_2)
///
/// A segment in which |q| crosses the critical flux is cut there into pieces (segment_pieces.hpp). The midpoint rule
/// (the seed paper's) is the same with A_0 = h/w_m³, A_1 = A_2 = 0 and no cutting.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "solver/crackwater/flow_law.hpp"

namespace sunder::crackwater {

enum class Quadrature {
  exact,     ///< cut at q = 0 and |q| = q_c; pressure resultants integrated as exactly as the pressure
  midpoint,  ///< aperture and flux at the middle of a segment, resultants by the trapezoidal rule: the seed paper's
};

/// Where the crack runs.
struct CrackLine {
  std::vector<double> lengths;  ///< (n) of the segments from the upstream mouth [m], > 0
  std::vector<double> rises;    ///< (n) height gained over each segment [m], |rise| ≤ length; empty: horizontal
};

/// n equal segments.
CrackLine straight_crack(double length, int segments);

/// Throws std::invalid_argument naming the value and its bound.
void check(const CrackLine& line);

/// A point of the crack.
struct Location {
  int segment = 0;
  double y = -1.0;  ///< -1 … 1 within the segment
};

/// One segment as the cutting sees it.
struct Segment {
  double length;             ///< [m]
  double first, last;        ///< apertures at its ends [m]
  double middle;             ///< V_m [m²/s]
  double linear, quadratic;  ///< α, β [m²/s]
};

/// Over a stretch.
struct Loss {
  double value = 0.0;      ///< friction loss ∫ φ w⁻³ ds [Pa]
  double slope = 0.0;      ///< its derivative with respect to c [Pa s/m²]
  double magnitude = 0.0;  ///< Σ |loss|, the scale of its round-off [Pa]

  void add(const Loss& part) {
    value += part.value;
    slope += part.slope;
    magnitude += part.magnitude;
  }
};

/// What rounding leaves of a pressure that is a sum of terms of this magnitude [Pa].
inline double round_off(double magnitude) {
  return 8.0 * std::numeric_limits<double>::epsilon() * magnitude;
}

class SegmentTable {
 public:
  SegmentTable(const CrackLine& line, const FlowLaw& law, Quadrature quadrature);

  /// Works the coefficients out for apertures [m] and their rates [m/s], both (n + 1). Nothing is allocated.
  /// Returns false, leaving nothing usable, where a value is not finite or an aperture is not > 0.
  [[nodiscard]] bool fill(std::span<const double> apertures, std::span<const double> rates);

  /// The same for a march: V given (n + 1) up to and with each node's volume, so constant within each segment.
  [[nodiscard]] bool fill_steps(std::span<const double> apertures, std::span<const double> changes);

  /// Whether V is constant in each segment, so that fronts lie at nodes and resultants follow the trapezoidal rule.
  bool flat() const { return steps_ || quadrature_ == Quadrature::midpoint; }
  bool marching() const { return steps_; }
  double loss_coefficient(int i) const { return a0_[static_cast<std::size_t>(i)]; }  ///< ∫ w⁻³ ds [1/m²]

  int count() const { return count_; }
  int padded_count() const { return padded_; }
  const FlowLaw& law() const { return law_; }
  Quadrature quadrature() const { return quadrature_; }
  bool never_closing() const { return least_rate_ >= 0.0; }
  bool never_opening() const { return greatest_rate_ <= 0.0; }
  double least_change() const { return least_change_; }                              ///< min V over the crack [m²/s]
  double greatest_change() const { return greatest_change_; }                        ///< max V
  double change(int node) const { return change_[static_cast<std::size_t>(node)]; }  ///< V at a node [m²/s]
  /// c of a crack full to its closed tip: V(L); in a march V of the last node's volume.
  double tip_change() const { return steps_ ? tip_step_ : change_[static_cast<std::size_t>(count_)]; }
  double middle_change(int i) const { return middle_[static_cast<std::size_t>(i)]; }
  double position(int node) const { return position_[static_cast<std::size_t>(node)]; }  ///< s [m]
  std::span<const double> lengths() const { return length_; }
  std::span<const double> positions() const { return position_; }
  double weight(int node) const { return weight_[static_cast<std::size_t>(node)]; }  ///< ρ g (z - z_mouth) [Pa]
  bool inclined() const { return climb_ > 0.0; }
  double climb() const { return climb_; }  ///< Σ |ρ g rise| [Pa]
  double rate(int node) const { return rate_[static_cast<std::size_t>(node)]; }
  double aperture(int node) const { return aperture_[static_cast<std::size_t>(node)]; }
  double length(int i) const { return length_[static_cast<std::size_t>(i)]; }
  Segment segment(int i) const;
  double position(Location at) const;
  double change(Location at) const;
  double weight(Location at) const;

  /// ∫ w⁻³ ds over segments [first, last) as the quadrature sees it [1/m²].
  double inverse_cubes(int first, int last) const;

  /// Friction loss over segments [first, last) for the constant c; the vectorised sweep.
  Loss loss(double c, int first, int last, bool wants_slope) const;

  /// That of one segment, cut or not.
  Loss cut_loss(int i, double c) const;
  double single_loss(int i, double c) const;  ///< not cut

  /// The same from prefix sums over blocks of 64 segments: with C_j = Σ ∫ V^j w⁻³ ds over blocks of one regime the loss
  /// is ± b (C_0 c² - 2 C_1 c + C_2) or a (C_0 c - C_1), and only blocks in which the regime changes are swept. O(log
  /// n) where V is monotone over the crack, O(n/64) where not.
  Loss prefix_loss(double c, int first, int last) const;

  struct Totals {
    double s0, s1, s2;  ///< ∫ V^j w⁻³ ds over the crack, j = 0, 1, 2
  };
  Totals totals() const { return {sum0_.back(), sum1_.back(), sum2_.back()}; }

  /// True where the closed form of segment i does not hold for this c: a regime change lies inside.
  bool is_split(int i, double c) const;
  /// True where, besides, the flux may turn inside segment i.
  bool may_turn(int i, double c) const;

  /// False where the flux turns or changes regime in no segment of [first, last).
  bool may_turn_within(int first, int last, double c) const;

  /// Friction loss of every segment in [first, last) with the parts of it that the nodal forces need:
  /// ∫ N_a p ds = p_a h/2 - to_first, ∫ N_b p ds = p_a h/2 - to_last. Wrong for segments that `is_split`: those are the
  /// caller's. The spans hold `padded_count()` numbers; in a flat table `to_first` and `to_last` are left alone.
  void losses(double c, int first, int last, std::span<double> loss, std::span<double> to_first,
              std::span<double> to_last) const;

 private:
  bool take(std::span<const double> apertures);
  void fill_moments(int first, int last);
  void fill_midpoint(int first, int last);
  void fill_block(int first, int last);
  template <int terms>
  void fill_four(int i);
  void fill_one(int i);

  int count_, padded_;
  FlowLaw law_;
  Quadrature quadrature_;
  bool steps_ = false;
  double climb_ = 0.0, tip_step_ = 0.0;
  double least_rate_ = 0.0, greatest_rate_ = 0.0, least_change_ = 0.0, greatest_change_ = 0.0;
  std::vector<double> length_, position_, weight_;
  std::vector<double> aperture_, rate_, change_;
  std::vector<double> middle_, spread_, block_low_, block_high_;
  std::vector<double> a0_, a1_, a2_;
  std::vector<double> sum0_, sum1_, sum2_;  // at the ends of blocks
};

}  // namespace sunder::crackwater
