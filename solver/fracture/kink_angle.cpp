#include "solver/fracture/kink_angle.hpp"

#include <algorithm>
#include <cmath>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::fracture {

double kink_angle(const StressIntensityFactors& factors) {
  const double K_I = factors.K_I;
  const double K_II = numerics::planted_fault("fracture/kink-angle-sign") ? -factors.K_II : factors.K_II;
  if (K_II == 0.0) return 0.0;
  const double root = std::hypot(K_I, std::sqrt(8.0) * K_II);
  // Both are the same number; each adds where the other would subtract nearly equal ones.
  const double tangent = K_I >= 0.0 ? -2.0 * K_II / (K_I + root) : (K_I - root) / (4.0 * K_II);
  return 2.0 * std::atan(tangent);
}

double equivalent_factor(const StressIntensityFactors& factors) {
  const double theta = kink_angle(factors);
  const double c = std::cos(0.5 * theta);
  return std::max(0.0, c * (factors.K_I * c * c - 1.5 * factors.K_II * std::sin(theta)));
}

}  // namespace sunder::fracture
