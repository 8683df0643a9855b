#pragma once
/// Motions in time with a closed form: the damped oscillator, what the trapezoidal rule makes of it, and a rod on a
/// moving base.

namespace sunder::exact {

struct Motion {
  double displacement = 0.0, velocity = 0.0;  ///< [m], [m/s]
};

/// u'' + 2 ζ ω u' + ω² u = 0 from `start`; ω [1/s] > 0, 0 <= ζ < 1.
Motion free_oscillator(double omega, double damping_ratio, Motion start, double time);

/// u'' + 2 ζ ω u' + ω² u = p sin(Ω t) from rest; p [m/s²]. Not both ζ = 0 and Ω = ω.
Motion forced_oscillator(double omega, double damping_ratio, double amplitude, double forcing, double time);

/// The same from rest under p + s t from time 0 on.
Motion ramped_oscillator(double omega, double damping_ratio, double value, double slope, double time);

/// What the trapezoidal rule (Newmark's average acceleration) answers for free_oscillator after `steps` steps of `step`
/// [s], without round-off: each step multiplies the eigenvector of λ = -ζω ± iω√(1 - ζ²) by (1 + λΔt/2)/(1 - λΔt/2).
Motion trapezoidal_oscillator(double omega, double damping_ratio, Motion start, double step, double steps);

/// Displacement of a base that moves once: A sin⁶(π t / D) within 0 … D, else 0 [m].
double smooth_pulse(double amplitude, double duration, double time);
/// Its acceleration [m/s²].
double smooth_pulse_acceleration(double amplitude, double duration, double time);

/// Free end of a rod of `length` [m] and wave speed c [m/s] whose other end follows g = smooth_pulse, relative to that
/// end, after d'Alembert: u = 2 Σ (-1)^k g(t - (2k + 1) L / c) - g(t).
double rod_free_end(double amplitude, double duration, double length, double speed, double time);

/// The same rod on ground whose acceleration is sin(Ω t) [m/s²] from t = 0; waves take `transit` [s] from end to end.
double shaken_rod_free_end(double transit, double forcing, double time);

/// What a scheme with numerical damping makes of u'' + 2 ζ ω u' + ω² u = ω² from rest after `steps` steps of ω Δt =
/// `phase`: [Chung & Hulbert 1993, Eqs. (2)-(5)] for one unknown, solved for the acceleration. `radius` at infinity.
double hht_alpha_step_response(double radius, double phase, double damping_ratio, int steps);
double generalised_alpha_step_response(double radius, double phase, double damping_ratio, int steps);

}  // namespace sunder::exact
