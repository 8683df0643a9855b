#include "solver/crackwater/pressure_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "solver/crackwater/segment_tangent.hpp"

namespace sunder::crackwater {

namespace {

// Columns of PressureTangent::segments: derivatives of a segment's loss (+ 0) and of its parts in the nodal forces of
// its first (+ 1) and last node (+ 2); then how much of the pressure at its start these forces take.
enum Column { by_flux = 0, by_constant = 3, by_aperture0 = 6, by_aperture1 = 9, by_rate0 = 12, by_rate1 = 15 };
enum { on_first = 18, on_last = 19, column_count = 20 };

/// What one input of the profile does, before the region's constant answers: node j's aperture or rate, or a mouth.
struct Input {
  double start = 0.0;        ///< δp at the start of the region
  double target = 0.0;       ///< δp at its end
  int node = 0;              ///< j
  Column first = by_flux;    ///< its own effect on segment j, whose first node j is; by_flux: none, as for a mouth
  Column last = by_flux;     ///< on segment j - 1
  double change_at = 0.0;    ///< δV at the first node of segment j
  double change_beyond = 0;  ///< and of all segments behind it
};

/// δp = start - Σ [by_constant δc - by_flux δV + own effect] along a region, one column of the tangent after the other.
/// With the sums of by_constant and by_flux worked out an entry costs a few multiplications.
class RegionTangent {
 public:
  RegionTangent(const PressureSolver& solver, const PressureSolver::Region& region, PressureTangent& tangent)
      : table_(solver.table()), region_(region), tangent_(tangent), first_(region.start.segment) {
    last_ = region.end.y > -1.0 ? region.end.segment : region.end.segment - 1;
    tangent_.by_change[first_] = tangent_.by_constant[first_] = 0.0;
    for (int i = first_; i <= last_; ++i) {
      prepare(i);
      tangent_.by_change[i + 1] = tangent_.by_change[i] + at(i, by_flux);
      tangent_.by_constant[i + 1] = tangent_.by_constant[i] + at(i, by_constant);
    }
  }

  void differentiate(const MouthPressures& mouths) {
    const int nodes = table_.count() + 1;
    const bool shifts = region_.share > 0.0;  // a mixture answers with its share, not with its flux
    const int from = shifts || region_.closed ? 0 : first_;
    const int to = region_.closed ? nodes - 1 : last_ + 1;
    for (int j = from; j <= to; ++j) {
      const double before = j > 0 ? 0.5 * table_.length(j - 1) : 0.0;
      const double after = j < table_.count() ? 0.5 * table_.length(j) : 0.0;
      add({.node = j, .first = by_aperture0, .last = by_aperture1}, j, 0.0);
      // in a march the columns of rates stand for R
      const bool march = table_.marching();
      const double beyond = march ? 1.0 : before + after;
      add({.node = j, .first = by_rate0, .last = by_rate1, .change_at = march ? 1.0 : before, .change_beyond = beyond},
          nodes + j, beyond);
    }
    const bool at_mouth = first_ == 0 && region_.start.y == -1.0;
    if (at_mouth && !(mouths.upstream < 0.0)) add({.start = 1.0, .node = -1}, 2 * nodes, 0.0);
    if (region_.to_mouth && !(*mouths.downstream < 0.0)) add({.target = 1.0, .node = -1}, 2 * nodes + 1, 0.0);
  }

 private:
  double& at(int segment, int column) { return tangent_.segments(segment, column); }
  bool holds(int segment) const { return segment >= first_ && segment <= last_; }

  void prepare(int i) {
    const double from = i == region_.start.segment ? region_.start.y : -1.0;
    const double to = i == region_.end.segment ? region_.end.y : 1.0;
    const auto of = [&](double c) {
      if (!(to > from)) return StretchTangent{};
      return table_.flat() ? flat_tangent(table_, i, c) : stretch_tangent(table_.segment(i), table_.law(), c, from, to);
    };
    StretchTangent s = of(region_.constant);
    Eigen::Array3d of_constant = s.by_flux;
    if (region_.share > 0.0) {
      const StretchTangent near = s, beyond = of(region_.constant_beyond);
      of_constant = beyond.value - near.value;
      s.add(near, -region_.share);
      s.add(beyond, region_.share);
    }
    if (std::abs(of_constant[0]) >
        largest_jump_) {  // the two constants are neighbours: round-off in all other segments
      largest_jump_ = std::abs(of_constant[0]);
      jump_ = i;
    }
    auto row = tangent_.segments.row(i);
    row.segment<3>(by_flux) = s.by_flux.transpose();
    row.segment<3>(by_constant) = of_constant.transpose();
    row.segment<3>(by_aperture0) = s.by_aperture0.transpose();
    row.segment<3>(by_aperture1) = s.by_aperture1.transpose();
    row.segment<3>(by_rate0) = s.by_rate0.transpose();
    row.segment<3>(by_rate1) = s.by_rate1.transpose();
    const double h = table_.length(i);
    row[on_first] = h / 8.0 * ((1.0 - from) * (1.0 - from) - (1.0 - to) * (1.0 - to));
    row[on_last] = h / 8.0 * ((1.0 + to) * (1.0 + to) - (1.0 + from) * (1.0 + from));
  }

  /// The own effect of an input on row k of a segment, V at its first node included.
  double own(const Input& input, int segment, int k) {
    if (input.node < 0 || !holds(segment)) return 0.0;
    if (segment == input.node) return at(segment, input.first + k) - input.change_at * at(segment, by_flux + k);
    return at(segment, input.last + k);
  }

  /// Adds one column; `tip_change` is δV at the tip.
  void add(const Input& input, Eigen::Index column, double tip_change) {
    const int j = input.node, end = last_ + 1;
    const auto& changes = tangent_.by_change;
    const auto& constants = tangent_.by_constant;
    auto& running = tangent_.running;
    // without the constant: `start` up to node j, then less the own effects, then with what V adds behind segment j
    const int turn = std::clamp(j + 1, first_, end);  // the first node behind both own effects
    const double behind = input.start - own(input, j - 1, 0) - own(input, j, 0);
    // a mixture stays where its segment has the critical flux: the region's flux follows V there
    const bool follows = region_.share > 0.0 && table_.marching() && j >= 0 && j <= jump_;
    const double shift = follows ? input.change_beyond : 0.0;
    double constant = tip_change;
    if (!region_.closed) {
      const double at_end = behind + input.change_beyond * (changes[end] - changes[turn]) - shift * changes[end];
      constant = (at_end - input.target) / constants[end];
    }
    running.segment(first_, turn - first_) = input.start - constant * constants.segment(first_, turn - first_);
    if (holds(j - 1) && j < turn) running[j] -= own(input, j - 1, 0);
    running.segment(turn, end + 1 - turn) = (behind - input.change_beyond * changes[turn]) +
                                            input.change_beyond * changes.segment(turn, end + 1 - turn) -
                                            constant * constants.segment(turn, end + 1 - turn);
    if (shift != 0.0) running.segment(first_, end + 1 - first_) -= shift * changes.segment(first_, end + 1 - first_);
    // the start of a region inside a segment is no node, nor is its end
    const int from = region_.start.y == -1.0 ? first_ : first_ + 1;
    const int to = region_.end.y > -1.0 && region_.end.y < 1.0 ? last_ : end;
    if (to >= from)
      tangent_.pressure.col(column).segment(from, to + 1 - from).array() += running.segment(from, to + 1 - from);
    if (!table_.flat()) add_forces(input, column, constant, shift, turn);
  }

  void add_forces(const Input& input, Eigen::Index column, double constant, double shift, int turn) {
    const int count = last_ + 1 - first_;
    auto force = tangent_.nodal_force.col(column).array();
    const auto data = [&](int k) { return tangent_.segments.col(k).segment(first_, count); };
    const auto running = tangent_.running.segment(first_, count);
    force.segment(first_, count) += data(on_first) * running - constant * data(by_constant + 1);
    force.segment(first_ + 1, count) += data(on_last) * running - constant * data(by_constant + 2);
    if (shift != 0.0) {
      force.segment(first_, count) -= shift * data(by_flux + 1);
      force.segment(first_ + 1, count) -= shift * data(by_flux + 2);
    }
    if (input.change_beyond != 0.0 && turn <= last_) {
      const int rest = last_ + 1 - turn;
      force.segment(turn, rest) += input.change_beyond * tangent_.segments.col(by_flux + 1).segment(turn, rest);
      force.segment(turn + 1, rest) += input.change_beyond * tangent_.segments.col(by_flux + 2).segment(turn, rest);
    }
    for (const int i : {input.node - 1, input.node}) {
      if (input.node < 0 || !holds(i)) continue;
      force[i] -= own(input, i, 1);
      force[i + 1] -= own(input, i, 2);
    }
  }

  const SegmentTable& table_;
  const PressureSolver::Region& region_;
  PressureTangent& tangent_;
  int first_, last_;
  int jump_ = -1;  // the segment whose regime a mixture mixes
  double largest_jump_ = 0.0;
};

/// Resultants of nodal pressures by the trapezoidal rule.
void add_trapezoid(const SegmentTable& table, PressureTangent& tangent) {
  for (int node = 0; node <= table.count(); ++node) {
    const double before = node > 0 ? table.length(node - 1) : 0.0;
    const double after = node < table.count() ? table.length(node) : 0.0;
    tangent.running[node] = 0.5 * (before + after);
  }
  tangent.nodal_force = tangent.running.matrix().asDiagonal() * tangent.pressure;
}

}  // namespace

PressureTangent::PressureTangent(int segment_count)
    : pressure(Eigen::MatrixXd::Zero(segment_count + 1, 2 * segment_count + 4)),
      nodal_force(pressure),
      segments(Eigen::ArrayXXd::Zero(segment_count, column_count)),
      by_change(Eigen::ArrayXd::Zero(segment_count + 1)),
      by_constant(by_change),
      running(by_change) {}

void differentiate(const PressureSolver& solver, PressureTangent& tangent) {
  tangent.pressure.setZero();
  tangent.nodal_force.setZero();
  const SegmentTable& table = solver.table();
  if (solver.profile().status == ProfileStatus::unusable_input) return;
  for (const PressureSolver::Region& region : solver.regions()) {
    if (table.position(region.end) > table.position(region.start))
      RegionTangent(solver, region, tangent).differentiate(solver.mouths());
  }
  if (table.flat()) add_trapezoid(table, tangent);
}

namespace {

/// From ∂/∂w and ∂/∂R to the whole ∂/∂w: R = (void + C(w) - C before)/Δt.
void fold_capacities(const SegmentTable& table, double time_step, Eigen::MatrixXd& derivatives) {
  const int n = table.count(), nodes = n + 1;
  const double sixth = 1.0 / (6.0 * time_step);
  for (int j = 0; j < nodes; ++j) {
    const double before = j > 0 ? sixth * table.length(j - 1) : 0.0, after = j < n ? sixth * table.length(j) : 0.0;
    auto column = derivatives.col(j);
    column += 2.0 * (before + after) * derivatives.col(nodes + j);
    if (j > 0) column += before * derivatives.col(nodes + j - 1);
    if (j < n) column += after * derivatives.col(nodes + j + 1);
  }
  derivatives.middleCols(nodes, nodes).setZero();
}

}  // namespace

void differentiate(const FillingMarch& march, PressureTangent& tangent) {
  differentiate(march.solver(), tangent);
  if (march.profile().status == ProfileStatus::unusable_input) return;
  fold_capacities(march.solver().table(), march.trial_time_step(), tangent.pressure);
  fold_capacities(march.solver().table(), march.trial_time_step(), tangent.nodal_force);
}

}  // namespace sunder::crackwater
