#include "verification/harness/studies/water_kernel.hpp"

#include <cmath>

#include "solver/numerics/quadrature.hpp"

namespace sunder::verification {

double WaterKernel::sample(double t) const {
  double sum = 0.0;
  for (Eigen::Index k = 0; k < frequency.size(); ++k) sum += weight[k] * ::j0(frequency[k] * t);
  return sum;
}

reservoir::FaceModes unit_face_modes(int elements, int order, double reflection_coefficient) {
  return reservoir::face_modes(reservoir::pressure_mesh(reservoir::uniform_face(1.0, elements, order), 1.0),
                               {.density = 1.0, .sound_speed = 1.0, .reflection_coefficient = reflection_coefficient});
}

WaterKernel water_kernel(const reservoir::FaceModes& modes) {
  return {modes.wavenumber_squared.cwiseSqrt(), modes.load.rowwise().sum().cwiseAbs2()};
}

/// ∫₀ᵗ (t - τ) J0(kτ) dτ = t A(t) - t J1(kt)/k with A the integral of J0(kτ).
Eigen::RowVectorXd twice_integrated(const WaterKernel& kernel, double time_step, int count) {
  const numerics::QuadratureRule rule = numerics::gauss_legendre(12);
  Eigen::RowVectorXd twice = Eigen::RowVectorXd::Zero(count);
  for (Eigen::Index k = 0; k < kernel.frequency.size(); ++k) {
    const double frequency = kernel.frequency[k];
    const int pieces = 1 + static_cast<int>(frequency * time_step / 3.0);
    double integral = 0.0;
    for (int j = 1; j < count; ++j) {
      const double half = 0.5 * time_step / pieces;
      for (int piece = 0; piece < pieces; ++piece) {
        const double middle = (j - 1) * time_step + (2 * piece + 1) * half;
        for (Eigen::Index g = 0; g < rule.points.size(); ++g)
          integral += half * rule.weights[g] * ::j0(frequency * (middle + half * rule.points[g]));
      }
      const double t = j * time_step;
      twice[j] += kernel.weight[k] * t * (integral - ::j1(frequency * t) / frequency);
    }
  }
  return twice;
}

}  // namespace sunder::verification
