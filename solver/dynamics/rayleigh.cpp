#include "solver/dynamics/rayleigh.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::dynamics {
namespace {

void require(bool holds, const char* name, double value, const char* bound) {
  if (!holds) throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " must be " + bound);
}

double planted_share() {
  return numerics::planted_fault("dynamics/damping-doubled") ? 2.0 : 1.0;
}

}  // namespace

Rayleigh rayleigh(double ratio, double first, double second) {
  require(ratio >= 0.0 && ratio < 1.0, "damping ratio", ratio, "in 0 … 1");
  require(first > 0.0, "first frequency", first, "> 0");
  require(second > first && std::isfinite(second), "second frequency", second, "finite and > the first");
  const double of_stiffness = 2.0 * planted_share() * ratio / (first + second);
  return {.of_mass = of_stiffness * first * second, .of_stiffness = of_stiffness};
}

Rayleigh stiffness_proportional(double ratio, double omega) {
  require(ratio >= 0.0 && ratio < 1.0, "damping ratio", ratio, "in 0 … 1");
  require(omega > 0.0 && std::isfinite(omega), "frequency", omega, "finite and > 0");
  return {.of_mass = 0.0, .of_stiffness = 2.0 * planted_share() * ratio / omega};
}

}  // namespace sunder::dynamics
