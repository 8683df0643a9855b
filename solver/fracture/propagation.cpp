#include "solver/fracture/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/fracture/kink_angle.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::fracture {

void check(const PropagationLaw& law) {
  const auto refuse = [](const char* name, double value, const char* accepted) {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(value) + ", accepted is " + accepted);
  };
  if (!(law.fracture_toughness > 0.0)) refuse("fracture_toughness", law.fracture_toughness, "> 0 Pa √m");
  if (!(law.increment > 0.0 && std::isfinite(law.increment))) refuse("increment", law.increment, "> 0 m, finite");
  if (!(law.max_speed > 0.0)) refuse("max_speed", law.max_speed, "> 0 m/s");
}

GrowthDecision decide_growth(const StressIntensityFactors& factors, Faces faces, const PropagationLaw& law) {
  const bool overlap = faces == Faces::as_K_I_says && factors.K_I < -closed_ratio * std::abs(factors.K_II);
  if (faces == Faces::held_closed || (overlap && !numerics::planted_fault("fracture/closed-crack-grows"))) return {};
  GrowthDecision decision{.verdict = GrowthVerdict::below_toughness,
                          .kink_angle = kink_angle(factors),
                          .equivalent_factor = equivalent_factor(factors)};
  if (numerics::planted_fault("fracture/growth-ignores-mode-two")) {
    decision.kink_angle = 0.0;
    decision.equivalent_factor = factors.K_I;
  }
  if (decision.equivalent_factor >= law.fracture_toughness) decision.verdict = GrowthVerdict::grows;
  return decision;
}

Eigen::Vector2d next_tip(const Eigen::Vector2d& tip, double direction, double kink_angle, double increment) {
  const double angle = direction + (numerics::planted_fault("fracture/growth-angle-sign") ? -kink_angle : kink_angle);
  return tip + increment * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

void refill(SpeedAllowance& allowance, const PropagationLaw& law, double time_step) {
  const double of_this_step = law.max_speed * time_step;
  allowance.length = std::min(allowance.length + of_this_step, std::max(law.increment, of_this_step));
}

bool take_increment(SpeedAllowance& allowance, const PropagationLaw& law, int taken) {
  if (law.per_step == GrowthPerStep::one_increment && taken > 0) return false;
  // Ten refills of a tenth of an increment make one, round-off or not.
  constexpr double round_off = 1e-9;
  if (allowance.length < (1.0 - round_off) * law.increment) return false;
  allowance.length = std::max(0.0, allowance.length - law.increment);
  return true;
}

}  // namespace sunder::fracture
