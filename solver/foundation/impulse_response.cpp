#include "solver/foundation/impulse_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sunder::foundation {
namespace {

using Eigen::MatrixXd;
using Complex = std::complex<double>;

constexpr double beta = 1.0;  // shifts the poles of the terms below off the path
constexpr int by_hand = 5;    // terms of the series beyond σ c that are transformed by hand

/// d_1, d_2, … with ŝ/σ² ~ Σ d_m (σ + β)^-m. From σ^-j = Σ_i C(j - 1 + i, i) βⁱ (σ + β)^-(j+i).
std::vector<MatrixXd> shifted_series(const UnboundedDomain& domain) {
  std::vector<MatrixXd> plain{MatrixXd(domain.c.asDiagonal()), domain.k};  // of σ^-1, σ^-2, …
  for (int j = 0; plain.size() < by_hand; ++j) plain.push_back(domain.series[j]);
  std::vector<MatrixXd> shifted;
  for (int m = 1; m <= by_hand; ++m) {
    MatrixXd sum = MatrixXd::Zero(domain.size(), domain.size());
    double binomial = 1.0;  // C(m - 1, m - j), from j = m downwards
    for (int j = m; j >= 1; --j) {
      sum += binomial * std::pow(beta, m - j) * plain[j - 1];
      binomial *= static_cast<double>(j - 1) / (m - j + 1);
    }
    shifted.push_back(sum);
  }
  return shifted;
}

}  // namespace

ImpulseSamples impulse_response(const UnboundedDomain& domain, std::span<const double> times,
                                const StiffnessOptions& options) {
  double last = 0.0;
  for (const double t : times) {
    if (!(t >= 0.0) || !std::isfinite(t))
      throw std::invalid_argument("time = " + std::to_string(t) + " s, accepted is >= 0");
    last = std::max(last, t / domain.time);
  }
  ImpulseSamples result;
  const Eigen::Index n = domain.size();
  std::vector<MatrixXd> shifted = shifted_series(domain);
  for (MatrixXd& d : shifted) d = (domain.F * d * domain.F.transpose()).eval();
  if (last == 0.0) {
    result.M.assign(times.size(), domain.time * shifted.front());
    return result;
  }
  const double period = 2.0 * last, gamma = std::log(1e10) / period, spacing = 2.0 * std::numbers::pi / period;
  // Beyond the start of the series the rest is (start/|σ|)^6 of little: four times as far it is below 1e-8.
  const std::vector<Complex> probe{Complex(1e12, 0.0) / domain.time};
  const double start = dynamic_stiffness(
                           domain, probe, [](std::size_t, const Eigen::MatrixXcd&) {}, options)
                           .start *
                       domain.time;
  const int count = static_cast<int>(std::ceil(std::max(4.0 * start, 40.0) / spacing));
  std::vector<Complex> s;
  for (int k = count; k >= 0; --k) s.push_back(Complex(gamma, spacing * k) / domain.time);

  std::vector<MatrixXd> sums(times.size(), MatrixXd::Zero(n, n));
  const StiffnessPath path = dynamic_stiffness(
      domain, s,
      [&](std::size_t i, const Eigen::MatrixXcd& S) {
        const Complex sigma = s[i] * domain.time;
        const Complex inverse = 1.0 / (sigma * sigma);
        MatrixXd re = inverse.real() * S.real() - inverse.imag() * S.imag();
        MatrixXd im = inverse.real() * S.imag() + inverse.imag() * S.real();
        Complex power = 1.0;
        for (const MatrixXd& d : shifted) {
          power /= sigma + beta;
          re -= power.real() * d;
          im -= power.imag() * d;
        }
        const double half = s[i].imag() == 0.0 ? 0.5 : 1.0;
        for (std::size_t j = 0; j < times.size(); ++j) {
          const Complex wave = half * (2.0 / period) * std::exp(sigma * (times[j] / domain.time));
          sums[j] += wave.real() * re - wave.imag() * im;
        }
      },
      options);
  result.status = path.status;
  if (path.status != StiffnessStatus::converged) return result;
  for (std::size_t j = 0; j < times.size(); ++j) {
    const double t = times[j] / domain.time;
    if (t == 0.0) {
      sums[j] = shifted.front();
    } else {
      double factor = std::exp(-beta * t);  // t^{m-1} e^{-βt} / (m - 1)!
      for (int m = 1; m <= by_hand; ++m) {
        sums[j] += factor * shifted[m - 1];
        factor *= t / m;
      }
    }
    result.M.push_back(domain.time * sums[j]);
  }
  return result;
}

}  // namespace sunder::foundation
