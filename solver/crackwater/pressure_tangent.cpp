#include "solver/crackwater/pressure_tangent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/crackwater/segment_pieces.hpp"

namespace sunder::crackwater {

PressureTangent::PressureTangent(int segments)
    : pressure(Eigen::MatrixXd::Zero(segments + 1, 2 * segments + 4)),
      nodal_force(Eigen::MatrixXd::Zero(segments + 1, 2 * segments + 4)),
      change(Eigen::RowVectorXd::Zero(2 * segments + 4)),
      constant(Eigen::RowVectorXd::Zero(2 * segments + 4)),
      running(Eigen::RowVectorXd::Zero(2 * segments + 4)) {}

namespace {

/// Gauss-Legendre nodes and weights on [-1, 1], 8 points [Abramowitz & Stegun 1964, Table 25.4].
constexpr double gauss_points[4] = {0.183434642495649804939476142360, 0.525532409916328985817739049189,
                                    0.796666477413626739591553936476, 0.960289856497536231683560868569};
constexpr double gauss_weights[4] = {0.362683783378361982965150449277, 0.313706645877887287337962201987,
                                     0.222381034453374470544355994426, 0.101228536290376259152531354310};

/// Derivatives of the loss over a stretch, and of its parts in the two nodal forces.
struct StretchTangent {
  Eigen::Array3d by_flux = Eigen::Array3d::Zero();  ///< rows: loss, to_first, to_last
  Eigen::Array3d by_rate0 = Eigen::Array3d::Zero(), by_rate1 = Eigen::Array3d::Zero();
  Eigen::Array3d by_aperture0 = Eigen::Array3d::Zero(), by_aperture1 = Eigen::Array3d::Zero();
  Eigen::Array3d value = Eigen::Array3d::Zero();

  void add(const StretchTangent& other, double share) {
    by_flux += share * other.by_flux;
    by_rate0 += share * other.by_rate0;
    by_rate1 += share * other.by_rate1;
    by_aperture0 += share * other.by_aperture0;
    by_aperture1 += share * other.by_aperture1;
    value += share * other.value;
  }
};

/// ∂V/∂v at y, V counted from the segment's first node; the first and the last rate.
double change_by_first(double h, double y) {
  return h * (2.0 * (y + 1.0) - (y * y - 1.0)) / 8.0;
}
double change_by_last(double h, double y) {
  return h * (2.0 * (y + 1.0) + (y * y - 1.0)) / 8.0;
}

StretchTangent stretch_tangent(const Segment& segment, const FlowLaw& law, double c, double start, double end) {
  StretchTangent t;
  const double h = segment.length;
  const auto weights = [&](double y) {  // 1, ∫ N_a and ∫ N_b from y to the end
    return Eigen::Array3d(1.0, h / 8.0 * ((1.0 - y) * (1.0 - y) - (1.0 - end) * (1.0 - end)),
                          h / 8.0 * ((1.0 + end) * (1.0 + end) - (1.0 + y) * (1.0 + y)));
  };
  const auto add_slope = [&](double y, double slope) {  // slope: ∂g/∂q ds
    const Eigen::Array3d weighted = slope * weights(y);
    t.by_flux += weighted;
    t.by_rate0 -= change_by_first(h, y) * weighted;
    t.by_rate1 -= change_by_last(h, y) * weighted;
  };
  const auto add_point = [&](double y, double ds, bool turbulent) {
    const double w = aperture(segment, y), q = flux(segment, c, y), cube = 1.0 / (w * w * w);
    const double phi = turbulent ? law.turbulent * std::abs(q) * q : law.laminar * q;
    add_slope(y, (turbulent ? 2.0 * law.turbulent * std::abs(q) : law.laminar) * cube * ds);
    const Eigen::Array3d loss = phi * cube * ds * weights(y);
    t.value += loss;
    t.by_aperture0 -= 1.5 * (1.0 - y) / w * loss;
    t.by_aperture1 -= 1.5 * (1.0 + y) / w * loss;
  };
  const Pieces pieces = cut(segment, law, c, start, end, std::numeric_limits<double>::quiet_NaN());
  for (int k = 0; k < pieces.count; ++k) {
    const Piece& piece = pieces.piece[static_cast<std::size_t>(k)];
    const bool turbulent = std::abs(flux(segment, c, 0.5 * (piece.start + piece.end))) > law.critical_flux;
    // panels over which the aperture changes by no more than 1 : 1.5, where eight points leave 1e-13
    const double w0 = aperture(segment, piece.start), w1 = aperture(segment, piece.end);
    const double ratio = std::max(w0, w1) / std::min(w0, w1);
    const int panels = 1 + static_cast<int>(std::log(ratio) / std::log(1.5));
    for (int panel = 0; panel < panels; ++panel) {
      const auto border = [&](int j) {  // geometric in w
        if (j == 0) return piece.start;
        if (j == panels) return piece.end;
        const double w = w0 * std::pow(w1 / w0, static_cast<double>(j) / panels);
        return piece.start + (piece.end - piece.start) * (w - w0) / (w1 - w0);
      };
      const double middle = 0.5 * (border(panel) + border(panel + 1)), half = 0.5 * (border(panel + 1) - border(panel));
      for (int g = 0; g < 4; ++g) {
        const double ds = 0.5 * h * half * gauss_weights[g];
        add_point(middle - half * gauss_points[g], ds, turbulent);
        add_point(middle + half * gauss_points[g], ds, turbulent);
      }
    }
  }
  if (!std::isfinite(law.critical_flux)) return t;
  const double jump = (law.turbulent * law.critical_flux - law.laminar) * law.critical_flux;
  std::array<double, 2> y{};
  for (const double target : {law.critical_flux, -law.critical_flux}) {
    const int found = crossings(segment, c - target, start, end, y);
    for (int k = 0; k < found; ++k) {
      const double at = y[static_cast<std::size_t>(k)], w = aperture(segment, at);
      const double speed = 2.0 / h * std::abs(segment.linear + 2.0 * segment.quadratic * at);
      if (speed > 0.0) add_slope(at, jump / (w * w * w * speed));
    }
  }
  return t;
}

/// Of a flat table; its nodal forces follow from the nodal pressures.
StretchTangent flat_tangent(const SegmentTable& table, int i, double c) {
  StretchTangent t;
  const Segment segment = table.segment(i);
  const double h = segment.length, a0 = table.loss_coefficient(i), d = c - segment.middle;
  const double w0 = segment.first, w1 = segment.last, total = w0 + w1;
  t.by_flux[0] = resistance_slope(table.law(), d) * a0;
  t.value[0] = resistance(table.law(), d) * a0;
  if (table.marching()) {  // a0 = h (w0 + w1) / (2 w0² w1²)
    t.by_aperture0[0] = t.value[0] * (1.0 / total - 2.0 / w0);
    t.by_aperture1[0] = t.value[0] * (1.0 / total - 2.0 / w1);
  } else {  // a0 = h / w_m³
    t.by_rate0[0] = -change_by_first(h, 0.0) * t.by_flux[0];
    t.by_rate1[0] = -change_by_last(h, 0.0) * t.by_flux[0];
    t.by_aperture0[0] = t.by_aperture1[0] = -3.0 / total * t.value[0];
  }
  return t;
}

class Differentiation {
 public:
  Differentiation(const PressureSolver& solver, PressureTangent& tangent)
      : solver_(solver), table_(solver.table()), tangent_(tangent), nodes_(table_.count() + 1) {}

  void region(const PressureSolver::Region& region) {
    constant_change(region);
    walk(region, true);
  }

  /// Resultants of nodal pressures by the trapezoidal rule.
  void trapezoid() {
    for (int node = 0; node < nodes_; ++node) {
      const double before = node > 0 ? table_.length(node - 1) : 0.0;
      const double after = node + 1 < nodes_ ? table_.length(node) : 0.0;
      tangent_.nodal_force.row(node) = 0.5 * (before + after) * tangent_.pressure.row(node);
    }
  }

 private:
  int rate_column(int node) const { return nodes_ + node; }
  int upstream_column() const { return 2 * nodes_; }

  /// δc (or the change of the share of a mixture) from what is kept at the region's end.
  void constant_change(const PressureSolver::Region& region) {
    tangent_.constant.setZero();
    if (region.closed) {
      begin_change(tangent_.constant);
      for (int i = 0; i < table_.count(); ++i) add_change(i, tangent_.constant);
      return;
    }
    const double by_constant = walk(region, false);
    if (region.to_mouth && !(*solver_.mouths().downstream < 0.0))
      tangent_.running[upstream_column() + 1] -= 1.0;  // δp(end) = δp_down
    tangent_.constant = tangent_.running / by_constant;
  }

  /// Carries δp along the region into `running`; returns Σ by which a unit of the constant lowers it.
  double walk(const PressureSolver::Region& region, bool store) {
    PressureTangent& t = tangent_;
    t.running.setZero();
    begin_change(t.change);
    const bool at_mouth = region.start.segment == 0 && region.start.y == -1.0;
    if (at_mouth && !(solver_.mouths().upstream < 0.0)) t.running[upstream_column()] = 1.0;
    for (int i = 0; i < region.start.segment; ++i) add_change(i, t.change);
    if (store && region.start.y == -1.0) t.pressure.row(region.start.segment) += t.running;
    double by_constant = 0.0;
    for (int i = region.start.segment; i <= region.end.segment; ++i) {
      const double from = i == region.start.segment ? region.start.y : -1.0;
      const double to = i == region.end.segment ? region.end.y : 1.0;
      if (to > from) by_constant += step(region, i, from, to, store);
      add_change(i, t.change);
    }
    return by_constant;
  }

  /// ∂V at the first node; in a march, where the columns of rates stand for R, ∂V in the first segment.
  void begin_change(Eigen::RowVectorXd& change) const {
    change.setZero();
    if (table_.marching()) change[rate_column(0)] = 1.0;
  }
  void add_change(int i, Eigen::RowVectorXd& change) const {
    if (table_.marching()) {
      change[rate_column(i + 1)] += 1.0;
      return;
    }
    change[rate_column(i)] += 0.5 * table_.length(i);
    change[rate_column(i + 1)] += 0.5 * table_.length(i);
  }

  double step(const PressureSolver::Region& region, int i, double from, double to, bool store) {
    const auto of = [&](double c) {
      return table_.flat() ? flat_tangent(table_, i, c) : stretch_tangent(table_.segment(i), table_.law(), c, from, to);
    };
    StretchTangent s = of(region.constant);
    Eigen::Array3d by_constant = s.by_flux;
    if (region.share > 0.0) {
      const StretchTangent beyond = of(region.constant_beyond);
      by_constant = beyond.value - s.value;
      const StretchTangent near = s;
      s.add(near, -region.share);
      s.add(beyond, region.share);
    }
    PressureTangent& t = tangent_;
    const auto subtract = [&](auto&& row, int k) {  // the loss of row k, from a row of derivatives
      row += s.by_flux[k] * t.change;
      row[i] -= s.by_aperture0[k];
      row[i + 1] -= s.by_aperture1[k];
      row[rate_column(i)] -= s.by_rate0[k];
      row[rate_column(i + 1)] -= s.by_rate1[k];
      if (store) row -= by_constant[k] * t.constant;
    };
    if (store && !table_.flat()) {
      const double h = table_.length(i);
      const double on_first = h / 8.0 * ((1.0 - from) * (1.0 - from) - (1.0 - to) * (1.0 - to));
      const double on_last = h / 8.0 * ((1.0 + to) * (1.0 + to) - (1.0 + from) * (1.0 + from));
      t.nodal_force.row(i) += on_first * t.running;
      subtract(t.nodal_force.row(i), 1);
      t.nodal_force.row(i + 1) += on_last * t.running;
      subtract(t.nodal_force.row(i + 1), 2);
    }
    subtract(t.running, 0);
    if (store && to == 1.0) t.pressure.row(i + 1) += t.running;
    return by_constant[0];
  }

  const PressureSolver& solver_;
  const SegmentTable& table_;
  PressureTangent& tangent_;
  int nodes_;
};

}  // namespace

void differentiate(const PressureSolver& solver, PressureTangent& tangent) {
  tangent.pressure.setZero();
  tangent.nodal_force.setZero();
  const SegmentTable& table = solver.table();
  if (solver.profile().status == ProfileStatus::unusable_input) return;
  Differentiation differentiation(solver, tangent);
  for (const PressureSolver::Region& region : solver.regions()) {
    if (table.position(region.end) > table.position(region.start)) differentiation.region(region);
  }
  if (table.flat()) differentiation.trapezoid();
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
