#include "verification/exact/crack_water.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::exact {

LouisLaw louis_law(double viscosity) {
  const double logarithm = std::log10(0.5 / 1.9);
  return {12.0 * viscosity * (1.0 + 8.8 * std::sqrt(0.125)), 1000.0 / (16.0 * logarithm * logarithm),
          2300.0 * viscosity / 2000.0};
}

double resting_crack_flux(double pressure, double aperture, double length, double viscosity) {
  const LouisLaw law = louis_law(viscosity);
  const double resistance = pressure * aperture * aperture * aperture / length;
  // φ jumps upwards at q_c: between the two laws the flux stays there
  return std::min(resistance / law.laminar, std::max(std::sqrt(resistance / law.turbulent), law.critical_flux));
}

namespace {

/// What the crack loses over the last u metres before the point of rest, and the integral of that over u.
struct Loss {
  explicit Loss(const MovingCrack& crack)
      : law(louis_law(crack.viscosity)),
        speed(std::abs(crack.rate)),
        laminar_length(law.critical_flux / speed),
        scale(1.0 / (crack.aperture * crack.aperture * crack.aperture)) {}

  double over(double u) const {
    const double l = laminar_length;
    if (u <= l) return scale * law.laminar * speed * u * u / 2.0;
    return scale * (law.laminar * speed * l * l / 2.0 + law.turbulent * speed * speed * (u * u * u - l * l * l) / 3.0);
  }
  double integral(double u) const {
    const double l = std::min(laminar_length, u), turbulent = law.turbulent * speed * speed;
    const double rest = u - l;  // turbulent: ∫ (t³ - l³)/3 dt from l to u = (u - l)² (u² + 2 u l + 3 l²)/12
    return scale * (law.laminar * speed * (l * l * l / 6.0 + l * l * rest / 2.0) +
                    turbulent * rest * rest * (u * u + 2.0 * u * l + 3.0 * l * l) / 12.0);
  }
  double length_of(double pressure) const {
    const double l = laminar_length, at_switch = over(l);
    if (pressure <= at_switch) return std::sqrt(2.0 * pressure / (scale * law.laminar * speed));
    return std::cbrt(l * l * l + 3.0 * (pressure - at_switch) / (scale * law.turbulent * speed * speed));
  }

  LouisLaw law;
  double speed, laminar_length, scale;
};

}  // namespace

double moving_crack_front(const MovingCrack& crack) {
  if (!(crack.rate > 0.0)) return crack.length;
  return std::min(crack.length, Loss(crack).length_of(crack.pressure));
}

double moving_crack_tip_pressure(const MovingCrack& crack) {
  const double loss = Loss(crack).over(crack.length);
  return crack.rate > 0.0 ? std::max(crack.pressure - loss, 0.0) : crack.pressure + loss;
}

double moving_crack_uplift(const MovingCrack& crack) {
  const double front = moving_crack_front(crack), at_rest = moving_crack_tip_pressure(crack);
  return at_rest * front + std::copysign(Loss(crack).integral(front), crack.rate);
}

double filling_front(double pressure, double aperture, double time, double viscosity) {
  const LouisLaw law = louis_law(viscosity);
  const double w = aperture, q = law.critical_flux;
  const double x1 = pressure * w * w * w / (law.turbulent * q * q), x2 = pressure * w * w * w / (law.laminar * q);
  const double rise = 1.5 * std::sqrt(pressure * w / law.turbulent);
  const double t1 = x1 * std::sqrt(x1) / rise, t2 = t1 + (x2 - x1) * w / q;
  if (time <= t1) return std::cbrt(rise * time * rise * time);
  if (time <= t2) return x1 + q / w * (time - t1);
  return std::sqrt(x2 * x2 + 2.0 * pressure * w * w * (time - t2) / law.laminar);
}

}  // namespace sunder::exact
