/// The water's convolution of white noise by one method, against the plain sum; and whether its weights are passive.

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "solver/convolution/direct_sum.hpp"
#include "solver/convolution/make_convolution.hpp"
#include "solver/numerics/compensated_sum.hpp"
#include "solver/reservoir/modal_exponentials.hpp"
#include "solver/simulation/ledger.hpp"
#include "verification/harness/studies/polygon_shape.hpp"
#include "verification/harness/studies/studies.hpp"
#include "verification/harness/studies/water_kernel.hpp"

namespace sunder::verification {
namespace {

using convolution::Method;
using convolution::WeightSequence;

Method method_of(const std::string& name) {
  if (name == "automatic") return Method::automatic;
  if (name == "direct") return Method::direct;
  if (name == "blocked-direct") return Method::blocked_direct;
  if (name == "block-fft") return Method::block_fft;
  if (name == "state-space") return Method::state_space;
  throw std::invalid_argument("parameters.method: there is no \"" + name + "\"");
}

Eigen::MatrixXd noise(int size, int steps) {
  std::mt19937_64 generator(3);
  Eigen::MatrixXd a(size, steps + 1);
  for (double& x : a.reshaped()) x = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
  return a;
}

Eigen::MatrixXd forces_of(convolution::Convolution& water, const Eigen::MatrixXd& a) {
  Eigen::MatrixXd forces(a.rows(), a.cols());
  for (Eigen::Index n = 0; n < a.cols(); ++n) {
    water.history_force(forces.col(n));
    water.append(a.col(n));
  }
  return forces;
}

/// The least power that harmonic accelerations of the unit circle radiate, over the largest: of the sum of all entries,
/// velocities by the trapezoidal rule.
double least_power(const WeightSequence& weights) {
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  constexpr int angles = 400;
  for (int k = 1; k < angles; ++k) {
    const std::complex<double> zeta = std::polar(1.0, -std::numbers::pi * k / angles);
    std::complex<double> sum = 0.0;  // by Horner's rule from the last weight
    for (long long j = weights.last(); j >= 0; --j) sum = sum * zeta + weights.values.col(j).sum();
    const std::complex<double> velocity = (1.0 + zeta) / (1.0 - zeta);
    const double power = std::real(std::conj(velocity) * sum);
    least = std::min(least, power);
    largest = std::max(largest, std::abs(power));
  }
  return least / largest;
}

}  // namespace

StudyOutput run_convolve(const StudyInput& input) {
  const int steps = whole_parameter(input, "steps", 1000), elements = whole_parameter(input, "elements", 10);
  const double step = number_parameter(input, "step", 0.144), alpha = number_parameter(input, "alpha", 0.75);
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "convolution", "convolution");
    const reservoir::FaceModes modes = unit_face_modes(elements, 2, alpha);
    const bool modal = alpha == 1.0;
    WeightSequence weights =
        modal ? reservoir::modal_weights(modes, step, steps) : reservoir::face_weights(modes, step, steps);
    const std::string method = text_parameter(input, "method");
    const double tolerance = number_parameter(input, "tolerance", 1e-5);
    const bool of_face = method == "water-memory";
    // the method meets the reference on the weights that it was given; what truncation leaves out is its error
    const std::unique_ptr<convolution::Convolution> reference =
        of_face ? reservoir::face_convolution(modes, step, steps).convolution
                : std::make_unique<convolution::DirectSum>(weights, steps);
    if (const double kept = number_parameter(input, "truncation", 0.0); kept > 0.0)
      weights = convolution::truncated(weights, std::min<long long>(static_cast<long long>(kept / step), steps));
    if (number_parameter(input, "passivity", 0.0) != 0.0)
      output.summary.quantities["least_power"] = least_power(weights);
    const convolution::MadeConvolution made =
        of_face ? reservoir::face_convolution(modes, step, steps,
                                              {.method = Method::state_space, .reduction = {.tolerance = tolerance}})
                : convolution::make_convolution(weights, steps,
                                                {.method = method_of(method), .reduction = {.tolerance = tolerance}});
    const Eigen::MatrixXd a = noise(reference->size(), steps);
    const Eigen::MatrixXd theirs = forces_of(*reference, a), mine = forces_of(*made.convolution, a);
    const double largest = theirs.size() > 0 ? theirs.cwiseAbs().maxCoeff() : 0.0;
    results::Quantity& found = output.summary.quantities;
    found["error"] = (mine - theirs).cwiseAbs().maxCoeff() / std::fmax(largest, 1e-300);
    found["relative_error"] = (mine - theirs).norm() / std::fmax(theirs.norm(), 1e-300);
    found["stated_error"] = made.error.relative;
    double worst = 0.0;
    for (Eigen::Index n = 0; n < a.cols(); ++n) worst = std::fmax(worst, (mine - theirs).col(n).norm());
    found["share_of_bound"] =
        made.error.absolute > 0.0 ? worst / (made.error.absolute * a.colwise().norm().maxCoeff()) : 0.0;
  }
  ledger.close(output.summary);
  return output;
}

StudyOutput run_long_memory(const StudyInput& input) {
  const auto steps = static_cast<long long>(number_parameter(input, "steps"));
  const double step = number_parameter(input, "step", 0.144);
  StudyOutput output;
  simulation::Ledger ledger;
  {
    const simulation::Ledger::Visit visit(ledger, "convolution", "convolution");
    const reservoir::FaceModes modes = unit_face_modes(whole_parameter(input, "elements", 2), 2, 1.0);
    const convolution::ExponentialSums sums =
        reservoir::modal_exponentials(modes, step, steps, number_parameter(input, "tolerance"));
    convolution::DiagonalStateSpace water(sums);
    const auto m = static_cast<std::size_t>(water.size());
    Eigen::VectorXd force(water.size());
    const Eigen::VectorXd acceleration = Eigen::VectorXd::Ones(water.size());
    // P_j and P_{j-1} of each mode, from P_{j+1} (j + 1) = (2 j + 1) x P_j - j P_{j-1}
    std::vector<double> x(m), now(m, 1.0), before(m, 0.0), size(m, 0.0), worst(m, 0.0);
    std::vector<numerics::CompensatedSum> exact(m);
    for (std::size_t k = 0; k < m; ++k) {
      const double t = 0.5 * std::sqrt(modes.wavenumber_squared[static_cast<Eigen::Index>(k)]) * step;
      x[k] = (1.0 - t) * (1.0 + t) / (1.0 + t * t);
      size[k] = sums.mass[static_cast<Eigen::Index>(k)];
    }
    water.append(acceleration);
    for (long long j = 1; j <= steps; ++j) {
      water.history_force(force);
      for (std::size_t k = 0; k < m; ++k) {
        const double order = static_cast<double>(j - 1), front = sums.mass[static_cast<Eigen::Index>(k)];
        const double next = ((2.0 * order + 1.0) * x[k] * now[k] - order * before[k]) / (order + 1.0);
        before[k] = now[k];
        now[k] = next;
        const double weight = front * (now[k] + before[k]);
        size[k] += std::abs(weight);
        exact[k].add(weight);
        worst[k] = std::max(worst[k], std::abs(force[static_cast<Eigen::Index>(k)] - exact[k].value()));
      }
      water.append(acceleration);
    }
    double error = 0.0;
    for (std::size_t k = 0; k < m; ++k) error = std::max(error, worst[k] / size[k]);
    results::Quantity& found = output.summary.quantities;
    found["error"] = error;
    found["stated_error"] = sums.error.relative;
    found["megabytes"] = 1e-6 * water.bytes();
    found["numbers_per_mode"] = static_cast<double>(sums.decay.rows());
  }
  ledger.close(output.summary);
  return output;
}

}  // namespace sunder::verification
