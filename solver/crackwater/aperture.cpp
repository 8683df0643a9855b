#include "solver/crackwater/aperture.hpp"

#include <cassert>
#include <cstddef>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::crackwater {

using numerics::planted_fault;

Aperture aperture(double opening, double opening_rate, double minimum_aperture, ApertureRule rule) {
  double bound = 0.0, offset = 0.0;
  switch (rule) {
    case ApertureRule::larger:
      bound = minimum_aperture;
      break;
    case ApertureRule::sum:
      (planted_fault("crackwater/sum-as-larger") ? bound : offset) = minimum_aperture;
      break;
  }
  const bool follows = opening > bound || (opening == bound && opening_rate > 0.0);
  const bool moves = follows || planted_fault("crackwater/solid-velocity");
  // `!(opening <= bound)` and not `opening > bound`: a NaN must reach the check of the solve
  return {!(opening <= bound) ? offset + opening : offset + bound,
          planted_fault("crackwater/no-opening-rate") ? 0.0 : (moves ? opening_rate : 0.0 * opening_rate),
          follows ? 1.0 : 0.0};
}

void apertures(std::span<const double> openings, std::span<const double> opening_rates, double minimum_aperture,
               ApertureRule rule, std::span<double> values, std::span<double> rates, std::span<double> factors) {
  assert(opening_rates.size() == openings.size() && values.size() == openings.size());
  assert(rates.size() == openings.size() && factors.size() == openings.size());
  for (std::size_t node = 0; node < openings.size(); ++node) {
    const Aperture a = aperture(openings[node], opening_rates[node], minimum_aperture, rule);
    values[node] = a.value;
    rates[node] = a.rate;
    factors[node] = a.factor;
  }
}

}  // namespace sunder::crackwater
