/// An undamped oscillator on the face of a reservoir with a rigid bottom, below the cut-off where water radiates
/// nothing: what a scheme adds to or takes from its energy is the scheme's own doing.

#include <cmath>
#include <limits>

#include "solver/convolution/contour_weights.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"
#include "verification/harness/studies/water_kernel.hpp"

namespace sunder::verification {
namespace {

using convolution::WeightSequence;

constexpr double still_water = 0.5427545144089087;  // 14 ζ(3)/π³
constexpr double too_large = 1e100;                 // grown out of all bounds: the march ends there

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
  } else {
    throw std::invalid_argument("parameters.scheme: there is no \"" + scheme + "\"");
  }
  return weights;
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
    WeightSequence weights = weights_of(scheme, dt, steps);
    if (const double kept = number_parameter(input, "truncation", 0.0); kept > 0.0)
      weights = convolution::truncated(weights, std::min<long long>(static_cast<long long>(kept / dt), steps));
    convolution::DirectSum water(weights, steps);
    const double mass = ratio * still_water;
    const Motion motion = march(water, mass, dry, dt, steps, scheme == "load-side");
    results::Quantity& found = output.summary.quantities;
    found["growth"] = motion.bounded && motion.early > 0.0 ? motion.late / motion.early : too_large;
    found["mass_share"] = weights.values(0, 0) / mass;
    if (motion.bounded) found["frequency"] = motion.frequency;
  }
  ledger.close(output.summary);
  return output;
}

/// M * M = G, the first-kind equation for J0(t), by piecewise linear M collocated at the steps' ends, and
/// differentiated to the second kind: M(0) M + M' * M = G'.
StudyOutput run_kernel_march(const StudyInput& input) {
  const bool second_kind = text_parameter(input, "scheme") == "second-kind";
  const double dt = number_parameter(input, "step");
  const int steps = whole_parameter(input, "steps", 400);
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "convolution", "march");
    Eigen::VectorXd M(steps + 1);
    M[0] = 1.0;
    double worst = 0.0;
    for (int n = 1; n <= steps; ++n) {
      const double t = n * dt;
      // unknown x = M_n; the sum is linear in it but in the first step, where Newton's method needs a few rounds
      double x = M[n - 1];
      for (int round = 0; round < 30; ++round) {
        M[n] = x;
        double value = 0.0, slope = 0.0;
        for (int k = 0; k < n; ++k) {
          const double left = M[k], right = M[k + 1], far = M[n - k], near = M[n - k - 1];
          const double d_left = k == n ? 1.0 : 0.0, d_right = k + 1 == n ? 1.0 : 0.0, d_far = k == 0 ? 1.0 : 0.0;
          if (second_kind) {
            value += 0.5 * (right - left) * (far + near);
            slope += 0.5 * (d_right - d_left) * (far + near) + 0.5 * (right - left) * d_far;
          } else {
            value += dt / 6.0 * (2.0 * left * far + left * near + right * far + 2.0 * right * near);
            slope += dt / 6.0 * (d_far * (2.0 * left + right) + d_right * (far + 2.0 * near));
          }
        }
        const double residual = second_kind ? M[0] * x + value - std::cos(t) : value - std::sin(t);
        const double change = residual / (second_kind ? M[0] + slope : slope);
        x -= change;
        if (!(std::abs(change) > 1e-15 * std::fmax(1.0, std::abs(x)))) break;
      }
      M[n] = x;
      if (!(std::abs(x) < too_large)) {
        worst = too_large;
        break;
      }
      worst = std::fmax(worst, std::abs(x - ::j0(t)));
    }
    output.summary.quantities["kernel_error"] = worst;
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
