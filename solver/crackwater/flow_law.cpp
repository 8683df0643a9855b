#include "solver/crackwater/flow_law.hpp"

#include <cmath>
#include <limits>

#include "solver/crackwater/check.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

double resistance_jump(double relative_roughness) {
  const double logarithm = std::log10(relative_roughness / 1.9);
  // (ρ q_c² / (16 l²)) / (12 μ (1 + 8.8 r^1.5) q_c) with ρ q_c = 2300 μ / 2
  return critical_reynolds_number / 2.0 /
         (192.0 * logarithm * logarithm * (1.0 + 8.8 * relative_roughness * std::sqrt(relative_roughness)));
}

void check(const Water& water) {
  require_positive("density", water.density);
  require_positive("dynamic_viscosity", water.dynamic_viscosity);
  require_not_negative("gravity", water.gravity);
  if (!(water.relative_roughness > 0.0 && water.relative_roughness <= 0.5)) {
    refuse("relative_roughness", water.relative_roughness, "> 0 and <= 0.5");
  }
  if (!(resistance_jump(water.relative_roughness) >= 1.0) && !planted_fault("crackwater/roughness-believed")) {
    refuse("relative_roughness", water.relative_roughness,
           ">= 0.00687879: below it the flow law is not monotone at Re = 2300 and fluxes are not unique");
  }
}

FlowLaw flow_law(const Water& water) {
  check(water);
  const double r = water.relative_roughness;
  const double logarithm = std::log10(r / 1.9);
  double denominator = 16.0;
  if (planted_fault("crackwater/turbulent-denominator-4")) denominator = 4.0;
  if (planted_fault("crackwater/turbulent-denominator-8")) denominator = 8.0;
  FlowLaw law{};
  law.laminar = 12.0 * water.dynamic_viscosity * (1.0 + 8.8 * r * std::sqrt(r));
  law.turbulent = water.density / (denominator * logarithm * logarithm);
  law.critical_flux = critical_reynolds_number * water.dynamic_viscosity / (2.0 * water.density);
  law.weight = planted_fault("crackwater/weightless") ? 0.0 : water.density * water.gravity;
  if (planted_fault("crackwater/laminar-only")) law.critical_flux = std::numeric_limits<double>::infinity();
  return law;
}

double flux_of_resistance(const FlowLaw& law, double value) {
  const double size = std::abs(value);
  const double laminar = size / law.laminar;
  if (laminar <= law.critical_flux) return std::copysign(laminar, value);
  return std::copysign(std::fmax(std::sqrt(size / law.turbulent), law.critical_flux), value);
}

}  // namespace sunder::crackwater
