#include "solver/crackwater/segment_pieces.hpp"

#include <cmath>
#include <utility>

#include "solver/crackwater/inverse_cube_moments.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

int crossings(const Segment& segment, double c, double start, double end, std::array<double, 2>& y) {
  // β y² + α y = d, by the formula that does not cancel
  const double d = c - segment.middle, a = segment.linear, b = segment.quadratic;
  const double discriminant = a * a + 4.0 * b * d;
  int count = 0;
  const auto keep = [&](double root) {
    if (root > start && root < end) y[static_cast<std::size_t>(count++)] = root;
  };
  if (discriminant < 0.0 || (a == 0.0 && b == 0.0)) return 0;
  const double half = -0.5 * (a + std::copysign(std::sqrt(discriminant), a));
  if (half != 0.0) keep(-d / half);
  if (b != 0.0 && discriminant > 0.0) keep(half / b);
  if (count == 2 && y[0] > y[1]) std::swap(y[0], y[1]);
  return count;
}

namespace {

Piece piece_of(const Segment& segment, const FlowLaw& law, double c, double start, double end) {
  const double w0 = aperture(segment, start), w1 = aperture(segment, end);
  const double centre = 0.5 * (start + end), half = 0.5 * (end - start);
  const double length = segment.length * half;
  const double d = flux(segment, c, centre);
  const double alpha = (segment.linear + 2.0 * segment.quadratic * centre) * half;
  const double beta = segment.quadratic * half * half;
  const auto m = inverse_cube_moments(w0, w1, taper_of(w0, w1));
  const double wm = 0.5 * (w0 + w1);
  const double scale = 0.5 * length / (wm * wm * wm);
  const bool turbulent = std::abs(d) > law.critical_flux;
  const double sign = planted_fault("crackwater/unsigned-flux") ? 1.0 : std::copysign(1.0, d);
  // φ as a polynomial in y: e_0 + e_1 y + …
  std::array<double, 5> e{};
  if (turbulent) {
    const double b = sign * law.turbulent * scale;
    e = {b * d * d, -2.0 * b * d * alpha, b * (alpha * alpha - 2.0 * d * beta), 2.0 * b * alpha * beta,
         b * beta * beta};
  } else {
    e = {law.laminar * scale * d, -law.laminar * scale * alpha, -law.laminar * scale * beta, 0.0, 0.0};
  }
  std::array<double, 3> r{};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 5; k-- > 0;) r[j] += e[k] * m[j + k];
  }
  Piece piece{};
  piece.start = start;
  piece.end = end;
  piece.loss = r[0];
  piece.slope = turbulent ? 2.0 * sign * law.turbulent * scale * (d * m[0] - alpha * m[1] - beta * m[2])
                          : law.laminar * scale * m[0];
  piece.to_first = length / 8.0 * (r[0] - 2.0 * r[1] + r[2]);
  piece.to_last = length / 8.0 * (3.0 * r[0] - 2.0 * r[1] - r[2]);
  return piece;
}

/// Into an ascending list of at most a handful.
template <std::size_t size>
void insert(std::array<double, size>& values, int& count, double value) {
  std::size_t at = static_cast<std::size_t>(count++);
  for (; at > 0 && values[at - 1] > value; --at) values[at] = values[at - 1];
  values[at] = value;
}

}  // namespace

double cut_slope(const Segment& segment, const FlowLaw& law, double y) {
  const double jump = (law.turbulent * law.critical_flux - law.laminar) * law.critical_flux;
  const double speed = 2.0 / segment.length * std::abs(segment.linear + 2.0 * segment.quadratic * y);  // |v|
  const double w = aperture(segment, y);
  return jump / (w * w * w * speed);
}

Piece whole_piece(const Segment& segment, const FlowLaw& law, double c) {
  return piece_of(segment, law, c, -1.0, 1.0);
}

Loss loss_between(const Segment& segment, const FlowLaw& law, double c, double start, double end) {
  std::array<double, 5> cuts{};
  int count = 0;
  Loss loss;
  std::array<double, 2> y{};
  if (std::isfinite(law.critical_flux)) {
    for (const double target : {law.critical_flux, -law.critical_flux}) {
      const int found = crossings(segment, c - target, start, end, y);
      for (int k = 0; k < found; ++k) {
        const double at = y[static_cast<std::size_t>(k)];
        insert(cuts, count, at);
        loss.slope += cut_slope(segment, law, at);
      }
    }
  }
  cuts[static_cast<std::size_t>(count)] = end;
  double from = start;
  for (int k = 0; k <= count; ++k) {
    const double to = cuts[static_cast<std::size_t>(k)];
    if (!(to > from)) continue;
    const double w0 = aperture(segment, from), w1 = aperture(segment, to);
    const Taper<double> taper = taper_of(w0, w1);
    const double inverse = taper.inverse_sum;
    const double centre = 0.5 * (from + to), half = 0.5 * (to - from);
    const double d = flux(segment, c, centre), beta = segment.quadratic * half * half;
    const double alpha = (segment.linear + 2.0 * segment.quadratic * centre) * half;
    const double scale = 4.0 * segment.length * half * (inverse * inverse * inverse);
    const auto m = inverse_cube_moments(w0, w1, taper);
    const double once = scale * (d * m[0] - alpha * m[1] - beta * m[2]);
    if (std::abs(d) > law.critical_flux) {
      const double square = scale * (d * (d * m[0] - 2.0 * (alpha * m[1] + beta * m[2])) + alpha * alpha * m[2] +
                                     beta * (2.0 * alpha * m[3] + beta * m[4]));
      const double sign = planted_fault("crackwater/unsigned-flux") ? 1.0 : std::copysign(1.0, d);
      loss.value += sign * law.turbulent * square;
      loss.slope += 2.0 * law.turbulent * std::abs(once);
      loss.magnitude += law.turbulent * square;
    } else {
      loss.value += law.laminar * once;
      loss.slope += law.laminar * scale * m[0];
      loss.magnitude += law.laminar * std::abs(once);
    }
    from = to;
  }
  return loss;
}

namespace {

/// `at_switch` is called with each cut where |q| = q_c.
template <class Action>
int borders_of(const Segment& segment, const FlowLaw& law, double c, double start, double end, double extra,
               std::array<double, 10>& borders, Action&& at_switch) {
  std::array<double, 9> cuts{};
  int count = 0;
  std::array<double, 2> y{};
  if (std::isgreater(extra, start) && std::isless(extra, end)) insert(cuts, count, extra);
  for (const double target : {0.0, law.critical_flux, -law.critical_flux}) {
    const int found = std::isfinite(target) ? crossings(segment, c - target, start, end, y) : 0;
    for (int k = 0; k < found; ++k) {
      const double at = y[static_cast<std::size_t>(k)];
      insert(cuts, count, at);
      if (target != 0.0) at_switch(at);
    }
  }
  int stretches = 0;
  borders[0] = start;
  for (int k = 0; k <= count; ++k) {
    const double to = k < count ? cuts[static_cast<std::size_t>(k)] : end;
    if (to > borders[static_cast<std::size_t>(stretches)]) borders[static_cast<std::size_t>(++stretches)] = to;
  }
  return stretches;
}

}  // namespace

int cut_borders(const Segment& segment, const FlowLaw& law, double c, double start, double end, double extra,
                std::array<double, 10>& borders) {
  return borders_of(segment, law, c, start, end, extra, borders, [](double) {});
}

Pieces cut(const Segment& segment, const FlowLaw& law, double c, double start, double end, double extra) {
  Pieces pieces;
  std::array<double, 10> borders{};
  pieces.count = borders_of(segment, law, c, start, end, extra, borders,
                            [&](double y) { pieces.cut_slope += cut_slope(segment, law, y); });
  for (std::size_t k = 0; k < static_cast<std::size_t>(pieces.count); ++k)
    pieces.piece[k] = piece_of(segment, law, c, borders[k], borders[k + 1]);
  return pieces;
}

}  // namespace sunder::crackwater
