/// An undamped oscillator on the face of a reservoir with a rigid bottom, below the cut-off where water radiates
/// nothing: what a scheme adds to or takes from its energy is the scheme's own doing.

#include <cmath>
#include <limits>
#include <memory>

#include "solver/convolution/contour_weights.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/convolution/simple_convolutions.hpp"
#include "solver/reservoir/modal_exponentials.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"
#include "verification/harness/studies/water_kernel.hpp"

namespace sunder::verification {
namespace {

using convolution::WeightSequence;

constexpr double still_water = 0.5427545144089087;  // 14 ζ(3)/π³
constexpr double too_large = 1e100;                 // grown out of all bounds: the march ends there

/// Coefficients of 1/√(s² + k²), s = (3/2 - 2 ζ + ζ²/2)/Δt, from p f' = -½ p' f with p = s² + k².
Eigen::RowVectorXd backward_difference_weights(double k, double dt, int steps) {
  const double p[5] = {2.25 / (dt * dt) + k * k, -6.0 / (dt * dt), 5.5 / (dt * dt), -2.0 / (dt * dt), 0.25 / (dt * dt)};
  Eigen::RowVectorXd f(steps + 1);
  f[0] = 1.0 / std::sqrt(p[0]);
  for (int n = 1; n <= steps; ++n) {
    double sum = 0.0;
    for (int i = 1; i <= std::min(n, 4); ++i) sum += p[i] * (n - 0.5 * i) * f[n - i];
    f[n] = -sum / (p[0] * n);
  }
  return f;
}

/// Scalar weights of one scheme.
WeightSequence weights_of(const std::string& scheme, double dt, int steps) {
  const reservoir::FaceModes modes = unit_face_modes(10, 2, 1.0);
  const WaterKernel kernel = water_kernel(modes);
  WeightSequence weights{1, false, Eigen::MatrixXd(1, steps + 1)};
  if (scheme == "trapezoidal" || scheme == "load-side") {
    weights.values = kernel.weight.transpose() * reservoir::modal_weights(modes, dt, steps).values;
  } else if (scheme == "contour") {
    weights = convolution::contour_weights(
        1, dt, steps, [&](const convolution::ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> M) {
          M(0, 0) = 0.0;
          for (Eigen::Index k = 0; k < kernel.weight.size(); ++k)
            M(0, 0) += kernel.weight[k] / std::sqrt(at.s * at.s + kernel.frequency[k] * kernel.frequency[k]);
        });
  } else if (scheme == "hat") {
    weights.values = convolution::hat_weights(twice_integrated(kernel, dt, steps + 2), dt);
  } else if (scheme == "sampled") {
    for (int j = 0; j <= steps; ++j) weights.values(0, j) = (j == 0 ? 0.5 : 1.0) * dt * kernel.sample(j * dt);
  } else if (scheme == "backward-difference") {
    weights.values.setZero();
    for (Eigen::Index k = 0; k < kernel.weight.size(); ++k)
      weights.values += kernel.weight[k] * backward_difference_weights(kernel.frequency[k], dt, steps);
  } else {
    throw std::invalid_argument("parameters.scheme: there is no \"" + scheme + "\"");
  }
  return weights;
}

std::unique_ptr<convolution::Convolution> sum_of(const std::string& scheme, double dt, int steps, double truncation) {
  WeightSequence weights = weights_of(scheme, dt, steps);
  if (truncation > 0.0)
    weights = convolution::truncated(weights, std::min<long long>(static_cast<long long>(truncation / dt), steps));
  return std::make_unique<convolution::DirectSum>(weights, steps);
}

/// The trapezoidal weights as sums of exponentials.
std::unique_ptr<convolution::Convolution> exponentials(double dt, int steps, double tolerance) {
  const reservoir::FaceModes modes = unit_face_modes(10, 2, 1.0);
  return std::make_unique<convolution::Transformed>(
      water_kernel(modes).weight.cwiseSqrt(),
      std::make_unique<convolution::DiagonalStateSpace>(reservoir::modal_exponentials(modes, dt, steps, tolerance)));
}

struct Motion {
  double early = 0.0, late = 0.0;  // largest |u| of the first and of the last tenth
  double frequency = 0.0;          // 2/Δt tan(ωΔt/2) of the oscillation, from its zero crossings
  bool bounded = true;
};

/// Newmark's average acceleration from an initial velocity of 1.
Motion march(convolution::Convolution& water, double mass, double dry, double dt, int steps, bool mass_on_load_side) {
  const double stiffness = dry * dry * mass, W0 = water.instantaneous_mass()(0, 0);
  const double effective = mass + (mass_on_load_side ? 0.0 : W0) + 0.25 * dt * dt * stiffness;
  Motion motion;
  Eigen::VectorXd a = Eigen::VectorXd::Zero(1), history(1);
  double u = 0.0, v = 1.0, first = 0.0, last = 0.0;
  int crossings = 0;
  water.append(a);
  for (int n = 1; n <= steps; ++n) {
    water.history_force(history);
    const double lagged = mass_on_load_side ? W0 * a[0] : 0.0, before = u;
    u += dt * v + 0.25 * dt * dt * a[0];
    v += 0.5 * dt * a[0];
    a[0] = -(stiffness * u + history[0] + lagged) / effective;
    u += 0.25 * dt * dt * a[0];
    v += 0.5 * dt * a[0];
    water.append(a);
    if (!(std::abs(u) < too_large)) {
      motion.bounded = false;
      motion.late = too_large;
      return motion;
    }
    if (10 * n <= steps) motion.early = std::fmax(motion.early, std::abs(u));
    if (10 * n > 9 * steps) motion.late = std::fmax(motion.late, std::abs(u));
    if (before < 0.0 && u >= 0.0) {
      last = (n - 1 + before / (before - u)) * dt;
      if (crossings++ == 0) first = last;
    }
  }
  if (crossings > 1) {
    const double omega = 2.0 * std::acos(-1.0) * (crossings - 1) / (last - first);
    motion.frequency = 2.0 / dt * std::tan(0.5 * omega * dt);
  }
  return motion;
}

}  // namespace

StudyOutput run_coupled_oscillator(const StudyInput& input) {
  const std::string scheme = text_parameter(input, "scheme");
  const double dt = number_parameter(input, "step"), duration = number_parameter(input, "duration", 2000.0);
  const double ratio = number_parameter(input, "mass_ratio", 1.0), dry = number_parameter(input, "dry", 1.3);
  const int steps = static_cast<int>(std::ceil(duration / dt));
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "convolution", "march");
    const std::unique_ptr<convolution::Convolution> water =
        scheme == "exponentials" ? exponentials(dt, steps, number_parameter(input, "tolerance"))
                                 : sum_of(scheme, dt, steps, number_parameter(input, "truncation", 0.0));
    const double mass = ratio * still_water;
    const Motion motion = march(*water, mass, dry, dt, steps, scheme == "load-side");
    results::Quantity& found = output.summary.quantities;
    found["growth"] = motion.bounded && motion.early > 0.0 ? motion.late / motion.early : too_large;
    found["mass_share"] = water->instantaneous_mass()(0, 0) / mass;
    if (motion.bounded) found["frequency"] = motion.frequency;
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
