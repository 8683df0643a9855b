#include "solver/crackwater/front_tracking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "solver/crackwater/check.hpp"
#include "solver/crackwater/segment_pieces.hpp"

namespace sunder::crackwater {

using numerics::Residual;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double position_of(double measure) {
  return std::cbrt(measure * measure);
}
double measure_of(double position) {
  return position * std::sqrt(position);
}

// Dormand & Prince 1980, Table 2: RK5(4)7M.
constexpr int stages = 7;
constexpr double nodes[stages] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr double matrix[stages][stages - 1] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr double error_weights[stages] = {71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                          -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

}  // namespace

FrontTracker::FrontTracker(const CrackLine& line, const Water& water, CrackMotion motion, const FrontOptions& options)
    : table_(line, flow_law(water), Quadrature::exact),
      motion_(std::move(motion)),
      options_(options),
      apertures_(line.lengths.size() + 1),
      rates_(line.lengths.size() + 1) {
  require_positive("tolerance", options.tolerance);
  require_positive("first_step", options.first_step);
  if (table_.inclined()) refuse("rises", 1.0, "absent: a tracked front runs in a horizontal crack");
  if (!options_.water_ahead.empty() && options_.water_ahead.size() != apertures_.size()) {
    refuse("number of water_ahead", static_cast<double>(options_.water_ahead.size()),
           "0 or the number of segments + 1");
  }
  for (std::size_t node = 0; node < options_.water_ahead.size(); ++node) {
    require_not_negative("water_ahead[" + std::to_string(node) + "]", options_.water_ahead[node]);
  }
}

double FrontTracker::crack_length() const {
  return table_.position(table_.count());
}

/// d(x^(3/2))/dt. Leaves the fluxes in `track_`.
double FrontTracker::speed(double time, double measure) {
  const double upstream = motion_(time, apertures_, rates_);
  usable_ = usable_ && table_.fill(apertures_, rates_) && std::isfinite(upstream) && upstream >= 0.0;
  if (!usable_) return 0.0;
  const int n = table_.count();
  const double x = std::min(position_of(measure), crack_length());
  const auto positions = table_.positions().first(static_cast<std::size_t>(n) + 1);
  const int i = std::clamp(
      static_cast<int>(std::upper_bound(positions.begin(), positions.end(), x) - positions.begin()) - 1, 0, n - 1);
  const double y = std::clamp(2.0 * (x - table_.position(i)) / table_.length(i) - 1.0, -1.0, 1.0);
  const Segment segment = table_.segment(i);
  const double w = aperture(segment, y);
  const std::size_t k = static_cast<std::size_t>(i);
  const double ahead = options_.water_ahead.empty()
                           ? 0.0
                           : 0.5 * ((1.0 - y) * options_.water_ahead[k] + (1.0 + y) * options_.water_ahead[k + 1]);
  usable_ = usable_ && w > ahead;
  if (!usable_) return 0.0;

  const double w0 = segment.first, stretch = 0.5 * segment.length * (1.0 + y);
  const double cubes = table_.inverse_cubes(0, i) + 0.5 * stretch * (w0 + w) / (w0 * w0 * w * w);
  if (!(cubes > 0.0)) {  // no water yet: the limit of x^½ q w/void for a uniform crack of the mouth's aperture
    return 1.5 * std::sqrt(upstream * w * w * w / table_.law().turbulent) / (w - ahead);
  }
  // q at the front is the unknown: c = q + V(x)
  const double at_front = table_.change({i, y});
  auto residual = [&](double flux, bool wants_slope) {
    ++track_.residual_evaluations;
    const double c = flux + at_front;
    const Loss whole = table_.loss(c, 0, i, wants_slope);
    const Loss part = y > -1.0 ? loss_between(segment, table_.law(), c, -1.0, y) : Loss{};
    return Residual{upstream - whole.value - part.value, -whole.slope - part.slope,
                    8.0 * epsilon * (upstream + whole.magnitude + part.magnitude)};
  };
  const double still = flux_of_resistance(table_.law(), upstream / cubes) * (1.0 + 16.0 * epsilon);
  const numerics::BracketedRoot root = bracketed_root(
      numerics::RootFunction(residual), table_.least_change() - at_front - 16.0 * epsilon * std::abs(at_front),
      table_.greatest_change() - at_front + still, {.method = numerics::RootMethod::newton});
  usable_ =
      usable_ && root.status != numerics::RootStatus::not_finite && root.status != numerics::RootStatus::no_sign_change;
  track_.flux = root.root;
  track_.upstream_flux = root.root + at_front;
  return 1.5 * std::sqrt(x) * root.root / (w - ahead);
}

FrontTrack FrontTracker::track(double position, double start, double end) {
  track_ = FrontTrack{};
  usable_ = std::isfinite(position) && position >= 0.0 && position <= crack_length() && std::isfinite(start) &&
            std::isfinite(end) && end >= start;
  double time = start, measure = usable_ ? measure_of(position) : 0.0, step = options_.first_step;
  const double goal = measure_of(crack_length());
  std::array<double, stages> slope{};
  slope[0] = usable_ ? speed(time, measure) : 0.0;
  const auto finish = [&](FrontStatus status) {
    track_.status = usable_ ? status : FrontStatus::unusable_input;
    track_.time = time;
    track_.position = position_of(measure);
    return track_;
  };
  while (usable_ && time < end) {
    if (slope[0] < 0.0) return finish(FrontStatus::turned_back);
    if (track_.steps + track_.rejected >= options_.max_steps || step < 4.0 * epsilon * std::abs(time)) {
      return finish(slope[0] > 0.0 && slope[stages - 1] < 0.0 ? FrontStatus::turned_back : FrontStatus::step_limit);
    }
    step = std::min(step, end - time);
    // A step that would leave the crack is shortened until its end is met: x grows, so dt/dx is finite.
    if (slope[0] > 0.0)
      step = std::min(step, std::max((goal - measure) / slope[0] * 2.0, 4.0 * epsilon * std::abs(end)));
    double error = 0.0, next = measure;
    for (int stage = 1; stage < stages && usable_; ++stage) {
      double at = 0.0;
      for (int j = 0; j < stage; ++j) at += matrix[stage][j] * slope[static_cast<std::size_t>(j)];
      next = measure + step * at;
      slope[static_cast<std::size_t>(stage)] = speed(time + nodes[stage] * step, std::max(next, 0.0));
    }
    for (int stage = 0; stage < stages; ++stage) error += error_weights[stage] * slope[static_cast<std::size_t>(stage)];
    const double scale =
        options_.tolerance * measure_of(position_of(std::max(next, measure)) + table_.length(0) * 1e-3);
    const double ratio = std::abs(step * error) / scale;
    const bool overshoots = next > goal * (1.0 + options_.tolerance);
    const bool turns = slope[stages - 1] < 0.0;  // try again shorter, to end where the flux is nil
    if (!(ratio <= 1.0) || overshoots || turns) {
      ++track_.rejected;
      step *= overshoots || turns ? 0.5 : std::clamp(0.9 * std::pow(ratio, -0.2), 0.1, 0.9);
      if (!std::isfinite(step)) return finish(FrontStatus::unusable_input);
      continue;
    }
    time = step == end - time ? end : time + step;
    measure = std::max(next, 0.0);
    slope[0] = slope[stages - 1];
    ++track_.steps;
    if (measure >= goal * (1.0 - options_.tolerance)) return finish(FrontStatus::reached_end);
    step *= std::clamp(0.9 * std::pow(std::max(ratio, 1e-10), -0.2), 0.2, 5.0);
  }
  return finish(FrontStatus::reached_time);
}

}  // namespace sunder::crackwater
