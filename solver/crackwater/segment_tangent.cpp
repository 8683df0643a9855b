#include "solver/crackwater/segment_tangent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/crackwater/segment_pieces.hpp"

namespace sunder::crackwater {

namespace {

/// Gauss-Legendre nodes and weights on [-1, 1], 8 points [Abramowitz & Stegun 1964, Table 25.4].
constexpr double gauss_points[4] = {0.183434642495649804939476142360, 0.525532409916328985817739049189,
                                    0.796666477413626739591553936476, 0.960289856497536231683560868569};
constexpr double gauss_weights[4] = {0.362683783378361982965150449277, 0.313706645877887287337962201987,
                                     0.222381034453374470544355994426, 0.101228536290376259152531354310};

/// ∂V/∂v at y, V counted from the segment's first node; the first and the last rate.
double change_by_first(double h, double y) {
  return h * (2.0 * (y + 1.0) - (y * y - 1.0)) / 8.0;
}
double change_by_last(double h, double y) {
  return h * (2.0 * (y + 1.0) + (y * y - 1.0)) / 8.0;
}

}  // namespace

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
  std::array<double, 10> borders{};
  const int stretches = cut_borders(segment, law, c, start, end, std::numeric_limits<double>::quiet_NaN(), borders);
  for (std::size_t k = 0; k < static_cast<std::size_t>(stretches); ++k) {
    const double from = borders[k], to = borders[k + 1];
    const bool turbulent = std::abs(flux(segment, c, 0.5 * (from + to))) > law.critical_flux;
    // panels over which the aperture changes by no more than 1 : 1.5, where eight points leave 1e-13
    const double w0 = aperture(segment, from), w1 = aperture(segment, to);
    const double ratio = std::max(w0, w1) / std::min(w0, w1);
    const int panels = ratio < 1.5 ? 1 : 1 + static_cast<int>(std::log(ratio) / std::log(1.5));
    for (int panel = 0; panel < panels; ++panel) {
      const auto border = [&](int j) {  // geometric in w
        if (j == 0) return from;
        if (j == panels) return to;
        const double w = w0 * std::pow(w1 / w0, static_cast<double>(j) / panels);
        return from + (to - from) * (w - w0) / (w1 - w0);
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
  std::array<double, 2> y{};
  for (const double target : {law.critical_flux, -law.critical_flux}) {
    const int found = crossings(segment, c - target, start, end, y);
    for (int k = 0; k < found; ++k) {
      const double at = y[static_cast<std::size_t>(k)], slope = cut_slope(segment, law, at);
      if (std::isfinite(slope)) add_slope(at, slope);
    }
  }
  return t;
}

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

}  // namespace sunder::crackwater
