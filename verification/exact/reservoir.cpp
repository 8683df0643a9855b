#include "verification/exact/reservoir.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sunder::exact {

double reservoir_force(double kappa) {
  if (!(kappa >= 0.0 && kappa < std::numbers::pi / 2.0)) throw std::invalid_argument("kappa must be 0 … π/2");
  constexpr int terms = 2000;
  double sum = 1.0 / (std::pow(std::numbers::pi, 3) * terms * terms);  // the rest, where κ no longer counts
  for (int n = terms - 1; n >= 0; --n) {
    const double z = (n + 0.5) * std::numbers::pi;
    sum += 2.0 / (z * z * std::sqrt((z - kappa) * (z + kappa)));
  }
  return sum;
}

double coupled_frequency(double ratio, double dry) {
  const double mass = ratio * reservoir_force(0.0);
  double low = 0.0, high = std::fmin(dry, std::numbers::pi / 2.0 * (1.0 - 1e-15));
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (middle * middle * (mass + reservoir_force(middle)) > dry * dry * mass ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double reservoir_impulse_before_echo(double T) {
  if (!(T >= 0.0 && T <= 2.0)) throw std::invalid_argument("T must be 0 … 2");
  return 1.0 - 2.0 * T / std::numbers::pi;
}

}  // namespace sunder::exact
