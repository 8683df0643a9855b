#include "verification/exact/vibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace sunder::exact {
namespace {

using std::numbers::pi;

struct AlphaScheme {
  double alpha_m, alpha_f, beta, gamma;
};

/// γ and β of second order with the largest damping of high frequencies [Chung & Hulbert 1993, Eqs. (17), (18)].
AlphaScheme alpha_scheme(double alpha_m, double alpha_f) {
  const double sum = 1.0 - alpha_m + alpha_f;
  return {alpha_m, alpha_f, 0.25 * sum * sum, 0.5 - alpha_m + alpha_f};
}

/// a + 2 ζ φ v + φ² u = φ² with Δt = 1, from rest: u after `steps`.
double march(const AlphaScheme& scheme, double phase, double ratio, int steps) {
  const double stiffness = phase * phase, damping = 2.0 * ratio * phase, force = stiffness;
  const auto [am, af, beta, gamma] = scheme;
  double u = 0.0, v = 0.0, a = force;
  for (int n = 0; n < steps; ++n) {
    const double u_known = u + v + (0.5 - beta) * a, v_known = v + (1.0 - gamma) * a;
    const double rest =
        force - am * a - damping * ((1.0 - af) * v_known + af * v) - stiffness * ((1.0 - af) * u_known + af * u);
    a = rest / (1.0 - am + (1.0 - af) * (gamma * damping + beta * stiffness));
    u = u_known + beta * a;
    v = v_known + gamma * a;
  }
  return u;
}

/// u_g of u_g'' = sin(Ω t) from rest; 0 before.
double ground_displacement(double omega, double time) {
  return time > 0.0 ? time / omega - std::sin(omega * time) / (omega * omega) : 0.0;
}

}  // namespace

double shear_wave_speed(const PlaneBody& body, double density) {
  return std::sqrt(body.shear_modulus / density);
}

double longitudinal_wave_speed(const PlaneBody& body, double density) {
  return shear_wave_speed(body, density) * std::sqrt((body.kolosov + 1.0) / (body.kolosov - 1.0));
}

double roller_square_frequency(const PlaneBody& body, double density, double side, int index) {
  if (index < 0) throw std::invalid_argument("roller_square_frequency: index must be >= 0");
  const double c_s = shear_wave_speed(body, density), c_p = longitudinal_wave_speed(body, density);
  std::vector<double> speeds;
  const int most = index + 2;  // the index + 1 lowest have i, j <= index + 1
  for (int i = 0; i <= most; ++i)
    for (int j = 0; j <= most; ++j) {
      if (i >= 1 && j >= 1) speeds.push_back(c_s * std::hypot(i, j));
      if (i + j >= 1) speeds.push_back(c_p * std::hypot(i, j));
    }
  std::sort(speeds.begin(), speeds.end());
  return pi / side * speeds[static_cast<std::size_t>(index)];
}

double slender_cantilever_frequency(double effective, double density, double length, double height, int n) {
  if (n < 1) throw std::invalid_argument("slender_cantilever_frequency: n must be >= 1");
  // cos λ + 1 / cosh λ changes its sign once in ((n - 1) π, n π).
  double low = (n - 1) * pi, high = n * pi;
  const auto f = [](double lambda) { return std::cos(lambda) + 1.0 / std::cosh(lambda); };
  const bool rising = f(low) < f(high);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) < 0.0) == rising ? low : high) = middle;
  }
  return low * low * std::sqrt(effective * height * height / (12.0 * density)) / (length * length);
}

double step_response(double ratio, double phase) {
  if (!(ratio >= 0.0 && ratio < 1.0)) throw std::invalid_argument("step_response: ratio must be in 0 … 1");
  const double root = std::sqrt(1.0 - ratio * ratio);
  return 1.0 - std::exp(-ratio * phase) * (std::cos(root * phase) + ratio / root * std::sin(root * phase));
}

double shaken_oscillator(double omega, double ground_omega, double time) {
  const double forced = std::sin(ground_omega * time), free = ground_omega / omega * std::sin(omega * time);
  return (forced - free) / (omega * omega - ground_omega * ground_omega);
}

double shaken_rod(double transit, double ground_omega, double time) {
  double displacement = -ground_displacement(ground_omega, time);
  double sign = 2.0;
  for (double arrival = transit; arrival < time; arrival += 2.0 * transit, sign = -sign)
    displacement += sign * ground_displacement(ground_omega, time - arrival);
  return displacement;
}

double newmark_step_response(double phase, double ratio, int steps) {
  return march({0.0, 0.0, 0.25, 0.5}, phase, ratio, steps);
}

double hht_alpha_step_response(double radius, double phase, double ratio, int steps) {
  return march(alpha_scheme(0.0, (1.0 - radius) / (1.0 + radius)), phase, ratio, steps);
}

double generalised_alpha_step_response(double radius, double phase, double ratio, int steps) {
  return march(alpha_scheme((2.0 * radius - 1.0) / (radius + 1.0), radius / (radius + 1.0)), phase, ratio, steps);
}

}  // namespace sunder::exact
