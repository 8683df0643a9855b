#include "verification/exact/oscillator.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace sunder::exact {

using std::numbers::pi;

namespace {

/// u'' + 2 ζ φ u' + φ² u = φ² with Δt = 1, from rest, by the scheme of second order with the largest damping of high
/// frequencies [Chung & Hulbert 1993, Eqs. (17), (18)]: u after `steps`.
double march(double alpha_m, double alpha_f, double phase, double damping_ratio, int steps) {
  const double sum = 1.0 - alpha_m + alpha_f, beta = 0.25 * sum * sum, gamma = sum - 0.5;
  const double stiffness = phase * phase, damping = 2.0 * damping_ratio * phase, force = stiffness;
  double u = 0.0, v = 0.0, a = force;
  for (int n = 0; n < steps; ++n) {
    const double u_known = u + v + (0.5 - beta) * a, v_known = v + (1.0 - gamma) * a;
    const double rest = force - alpha_m * a - damping * ((1.0 - alpha_f) * v_known + alpha_f * v) -
                        stiffness * ((1.0 - alpha_f) * u_known + alpha_f * u);
    a = rest / (1.0 - alpha_m + (1.0 - alpha_f) * (gamma * damping + beta * stiffness));
    u = u_known + beta * a;
    v = v_known + gamma * a;
  }
  return u;
}

/// u_g of u_g'' = sin(Ω t) from rest; 0 before.
double sine_ground(double forcing, double time) {
  return time > 0.0 ? time / forcing - std::sin(forcing * time) / (forcing * forcing) : 0.0;
}

}  // namespace

Motion free_oscillator(double omega, double damping_ratio, Motion start, double time) {
  const double decay = damping_ratio * omega, damped = omega * std::sqrt(1.0 - damping_ratio * damping_ratio);
  const double c = std::cos(damped * time), s = std::sin(damped * time), e = std::exp(-decay * time);
  const double b = (start.velocity + decay * start.displacement) / damped;
  return {
      .displacement = e * (start.displacement * c + b * s),
      .velocity = e * ((b * damped - decay * start.displacement) * c - (start.displacement * damped + decay * b) * s)};
}

Motion forced_oscillator(double omega, double damping_ratio, double amplitude, double forcing, double time) {
  const double stiff = omega * omega - forcing * forcing, lossy = 2.0 * damping_ratio * omega * forcing;
  const double size = amplitude / (stiff * stiff + lossy * lossy);
  const double in_phase = size * stiff, out_of_phase = -size * lossy;
  const Motion transient =
      free_oscillator(omega, damping_ratio, {.displacement = -out_of_phase, .velocity = -in_phase * forcing}, time);
  const double c = std::cos(forcing * time), s = std::sin(forcing * time);
  return {.displacement = transient.displacement + in_phase * s + out_of_phase * c,
          .velocity = transient.velocity + forcing * (in_phase * c - out_of_phase * s)};
}

Motion ramped_oscillator(double omega, double damping_ratio, double value, double slope, double time) {
  const double lag = 2.0 * damping_ratio / omega, stiffness = omega * omega;
  const double at_start = (value - slope * lag) / stiffness, rate = slope / stiffness;
  const Motion transient = free_oscillator(omega, damping_ratio, {.displacement = -at_start, .velocity = -rate}, time);
  return {.displacement = transient.displacement + at_start + rate * time, .velocity = transient.velocity + rate};
}

Motion trapezoidal_oscillator(double omega, double damping_ratio, Motion start, double step, double steps) {
  const double damped = omega * std::sqrt(1.0 - damping_ratio * damping_ratio);
  const std::complex<double> lambda(-damping_ratio * omega, damped);
  // u = Re(q e^{λt}): Re q = u_0 and Re(λ q) = v_0
  const std::complex<double> q(start.displacement,
                               -(start.velocity + damping_ratio * omega * start.displacement) / damped);
  const std::complex<double> half = 0.5 * step * lambda;
  const std::complex<double> now = q * std::polar(std::pow(std::abs((1.0 + half) / (1.0 - half)), steps),
                                                  steps * std::arg((1.0 + half) / (1.0 - half)));
  return {.displacement = now.real(), .velocity = (lambda * now).real()};
}

double smooth_pulse(double amplitude, double duration, double time) {
  if (time <= 0.0 || time >= duration) return 0.0;
  return amplitude * std::pow(std::sin(pi * time / duration), 6);
}

double smooth_pulse_acceleration(double amplitude, double duration, double time) {
  if (time <= 0.0 || time >= duration) return 0.0;
  const double s = std::sin(pi * time / duration), c = std::cos(pi * time / duration), rate = pi / duration;
  return amplitude * rate * rate * (30.0 * std::pow(s, 4) * c * c - 6.0 * std::pow(s, 6));
}

double rod_free_end(double amplitude, double duration, double length, double speed, double time) {
  double total = 0.0, sign = 2.0;
  for (double arrival = length / speed; arrival < time; arrival += 2.0 * length / speed, sign = -sign) {
    total += sign * smooth_pulse(amplitude, duration, time - arrival);
  }
  return total - smooth_pulse(amplitude, duration, time);
}

double shaken_rod_free_end(double transit, double forcing, double time) {
  double total = 0.0, sign = 2.0;
  for (double arrival = transit; arrival < time; arrival += 2.0 * transit, sign = -sign) {
    total += sign * sine_ground(forcing, time - arrival);
  }
  return total - sine_ground(forcing, time);
}

double hht_alpha_step_response(double radius, double phase, double damping_ratio, int steps) {
  return march(0.0, (1.0 - radius) / (1.0 + radius), phase, damping_ratio, steps);
}

double generalised_alpha_step_response(double radius, double phase, double damping_ratio, int steps) {
  return march((2.0 * radius - 1.0) / (radius + 1.0), radius / (radius + 1.0), phase, damping_ratio, steps);
}

}  // namespace sunder::exact
