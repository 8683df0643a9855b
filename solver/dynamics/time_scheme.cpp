#include "solver/dynamics/time_scheme.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::dynamics {
namespace {

void require_radius(double radius, double least) {
  if (!(radius >= least && radius <= 1.0)) {
    throw std::invalid_argument("spectral_radius = " + std::to_string(radius) + " must lie in " +
                                std::to_string(least) + " … 1");
  }
}

/// Order 2 needs γ = ½ - α_m + α_f; β is the largest damping of high frequencies then.
TimeScheme of_second_order(double alpha_m, double alpha_f) {
  const double shift = alpha_f - alpha_m;
  return {.alpha_m = alpha_m, .alpha_f = alpha_f, .beta = 0.25 * (1.0 + shift) * (1.0 + shift), .gamma = 0.5 + shift};
}

}  // namespace

TimeScheme newmark() {
  TimeScheme scheme;
  if (numerics::planted_fault("dynamics/newmark-gamma")) scheme.gamma = 0.55;
  return scheme;
}

TimeScheme hht_alpha(double spectral_radius) {
  require_radius(spectral_radius, 0.5);
  return of_second_order(0.0, (1.0 - spectral_radius) / (1.0 + spectral_radius));
}

TimeScheme generalised_alpha(double spectral_radius) {
  require_radius(spectral_radius, 0.0);
  const double r = spectral_radius;
  return of_second_order((2.0 * r - 1.0) / (r + 1.0), r / (r + 1.0));
}

StepFactors step_factors(const TimeScheme& scheme, double time_step) {
  const double share = 1.0 - scheme.alpha_f;
  return {.mass = (1.0 - scheme.alpha_m) / (scheme.beta * time_step * time_step),
          .damping = share * scheme.gamma / (scheme.beta * time_step),
          .stiffness = share};
}

std::array<std::complex<double>, 3> amplification(const TimeScheme& scheme, double phase) {
  // State {u, Δt v, Δt² a}; K = ω², M = 1. Rows of the implicit and of the explicit side.
  const auto [am, af, beta, gamma] = scheme;
  Eigen::Matrix3d after, before;
  after << 1.0, 0.0, -beta, 0.0, 1.0, -gamma, (1.0 - af) * phase * phase, 0.0, 1.0 - am;
  before << 1.0, 1.0, 0.5 - beta, 0.0, 1.0, 1.0 - gamma, -af * phase * phase, 0.0, -am;
  const Eigen::Vector3cd values = Eigen::EigenSolver<Eigen::Matrix3d>(after.inverse() * before, false).eigenvalues();
  return {values[0], values[1], values[2]};
}

}  // namespace sunder::dynamics
