/// The kernel J0 of the simplest unbounded domain from M * M = G, by schemes that work and schemes that do not.

#include <cmath>
#include <limits>

#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {
namespace {

constexpr double too_large = 1e100;  // grown out of all bounds: the march ends there

/// M_n by piecewise linear M: of the first kind, M * M = sin t, collocated at the steps' ends, or differentiated to the
/// second, M(0) M + M' * M = cos t. The sum is linear in M_n but in the first step, where Newton's method needs a few
/// rounds.
double next_linear(Eigen::VectorXd& M, int n, double dt, bool second_kind) {
  double x = M[n - 1];
  for (int round = 0; round < 30; ++round) {
    M[n] = x;
    double value = 0.0, slope = 0.0;
    for (int k = 0; k < n; ++k) {
      const double left = M[k], right = M[k + 1], far = M[n - k], near = M[n - k - 1];
      const double d_right = k + 1 == n ? 1.0 : 0.0, d_far = k == 0 ? 1.0 : 0.0;
      if (second_kind) {
        value += 0.5 * (right - left) * (far + near);
        slope += 0.5 * d_right * (far + near) + 0.5 * (right - left) * d_far;
      } else {
        value += dt / 6.0 * (2.0 * left * far + left * near + right * far + 2.0 * right * near);
        slope += dt / 6.0 * (d_far * (2.0 * left + right) + d_right * (far + 2.0 * near));
      }
    }
    const double residual = second_kind ? M[0] * x + value - std::cos(n * dt) : value - std::sin(n * dt);
    const double change = residual / (second_kind ? M[0] + slope : slope);
    x -= change;
    if (!(std::abs(change) > 1e-15 * std::fmax(1.0, std::abs(x)))) break;
  }
  return x;
}

/// Piecewise constant M, M_k from step k - 1 to k: Σ M_k M_{n+1-k} Δt = sin t_n. NaN where the first has no real root.
double next_constant(const Eigen::VectorXd& M, int n, double dt) {
  const double right = std::sin(n * dt) / dt;
  if (n == 1) return right < 0.0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(right);
  double known = 0.0;
  for (int k = 2; k < n; ++k) known += M[k] * M[n + 1 - k];
  return 0.5 * (right - known) / M[1];
}

}  // namespace

StudyOutput run_kernel_march(const StudyInput& input) {
  const std::string scheme = text_parameter(input, "scheme");
  const double dt = number_parameter(input, "step");
  const int steps = whole_parameter(input, "steps", 400);
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "convolution", "march");
    Eigen::VectorXd M(steps + 1);
    M[0] = 1.0;
    double worst = 0.0, worst_in_middle = 0.0;
    for (int n = 1; n <= steps; ++n) {
      M[n] = scheme == "piecewise-constant" ? next_constant(M, n, dt) : next_linear(M, n, dt, scheme == "second-kind");
      if (n == 1 && std::isnan(M[n])) {
        output.refusal = "the first value has no real square root";
        return output;
      }
      if (!(std::abs(M[n]) < too_large)) {
        worst = worst_in_middle = too_large;
        break;
      }
      worst = std::fmax(worst, std::abs(M[n] - ::j0(n * dt)));
      worst_in_middle = std::fmax(worst_in_middle, std::abs(M[n] - ::j0((n - 0.5) * dt)));
    }
    output.summary.quantities["kernel_error"] = worst;
    if (scheme == "piecewise-constant") output.summary.quantities["kernel_error_in_middle"] = worst_in_middle;
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
