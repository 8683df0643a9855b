#pragma once
/// The front of water that runs into a dry or partly dry crack, followed exactly through the segments.
///
/// Behind the front x(t) the crack is full and its flux follows from the pressures, p(0) = p_up and p(x) = 0; the front
/// moves by continuity, dx/dt = q(x)/void(x, t) with void = aperture - water that lies ahead. x starts as t^(2/3) in an
/// empty crack (turbulent), so x^(3/2) is what is integrated, by the embedded Runge-Kutta pair of order 5(4) [Dormand &
/// Prince 1980] with |error| ≤ tolerance · (x + first segment) a step. Where the flux at the front turns back the front
/// would leave water behind on its way out; that is the march's business (filling_march.hpp), and the tracking stops
/// there and says so.

#include <functional>
#include <span>
#include <vector>

#include "solver/crackwater/pressure_profile.hpp"

namespace sunder::crackwater {

/// Apertures [m] and their rates [m/s] at a time [s], both (n + 1), and the upstream pressure [Pa] returned.
using CrackMotion = std::function<double(double time, std::span<double> apertures, std::span<double> rates)>;

struct FrontOptions {
  double tolerance = 1e-10;  ///< relative error of x a step, > 0
  double first_step = 1e-6;  ///< [s], > 0
  int max_steps = 1'000'000;
  std::vector<double> water_ahead =
      {};  ///< (n + 1) height of the water that lies in the dry part [m], ≥ 0; empty: none
};

enum class FrontStatus {
  reached_time,
  reached_end,     ///< the crack is full; `time` says when
  turned_back,     ///< the flux at the front became negative; `time` is the last at which it was not
  step_limit,      ///< max_steps, or a step too small to count
  unusable_input,  ///< a value is not finite or out of its range, or no void is left at the front
};

struct FrontTrack {
  FrontStatus status = FrontStatus::reached_time;
  double time = 0.0;      ///< [s]
  double position = 0.0;  ///< x [m]
  double flux = 0.0;      ///< q(x) [m²/s]
  double upstream_flux = 0.0;
  long long steps = 0, rejected = 0, residual_evaluations = 0;
};

class FrontTracker {
 public:
  /// Throws std::invalid_argument naming the value and its bound.
  FrontTracker(const CrackLine& line, const Water& water, CrackMotion motion, const FrontOptions& options = {});

  /// From `position` at `start` to `end` [s].
  [[nodiscard]] FrontTrack track(double position, double start, double end);

 private:
  double speed(double time, double measure);
  double crack_length() const;

  SegmentTable table_;
  CrackMotion motion_;
  FrontOptions options_;
  std::vector<double> apertures_, rates_;
  FrontTrack track_;
  bool usable_ = true;
};

}  // namespace sunder::crackwater
