#include "solver/reservoir/modal_exponentials.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;
using convolution::ExponentialSums;
using Eigen::ArrayXd;
using Eigen::Index;

struct Mode {
  double angle = 0.0;   ///< θ
  double cosine = 1.0;  ///< cos θ, without the loss of cos(θ) near 1
  double front = 0.0;   ///< of P_j + P_{j-1} [kg/m]
};

Mode mode_of(const FaceModes& modes, double time_step, Index k) {
  const double c = modes.water.sound_speed, t = 0.5 * std::sqrt(modes.wavenumber_squared[k]) * c * time_step;
  return {.angle = 2.0 * std::atan(t),
          .cosine = (1.0 - t) * (1.0 + t) / (1.0 + t * t),
          .front = 0.5 * modes.water.density * c * time_step / std::sqrt(1.0 + t * t)};
}

/// Nodes v of the rule and what each contributes at j = 0, without the factor of the mode.
struct Rule {
  std::vector<double> v, share;  ///< share: h v, of the trapezoidal rule in ln v
};

Rule rule_of(double tolerance, long long steps) {
  const double h = std::numbers::pi * std::numbers::pi / std::log(1.0 / tolerance);
  // the node that stands for all below it errs by (N v)² / 8 of √v, summed over N lags against Σ |w_j| ~ √N
  const double first = std::pow(16.0 * tolerance, 0.4) / static_cast<double>(steps);
  const double last = std::log(1.0 / tolerance) + 5.0;  // e^{-v} is below the tolerance
  Rule rule;
  for (double y = std::log(first); y < std::log(last); y += h) {
    const double v = std::exp(y);
    rule.v.push_back(v);
    rule.share.push_back(h * v);
  }
  // below: Σ √v and Σ v √v of the geometric series v e^{-h}, v e^{-2h}, …, in units of the first node's h v / √v
  const double q = std::exp(-0.5 * h), weights = q / (1.0 - q), moments = q * q * q / (1.0 - q * q * q);
  const double v = first * moments / weights;
  rule.v.insert(rule.v.begin(), v);
  rule.share.insert(rule.share.begin(), h * std::sqrt(first) * weights * std::sqrt(v));
  return rule;
}

void place(const Mode& mode, const Rule& rule, Index k, ExponentialSums& sums) {
  for (std::size_t i = 0; i < rule.v.size(); ++i) {
    const double v = rule.v[i], t = std::exp(v);
    const Complex turn = std::polar(1.0, mode.angle);
    const Complex density = (1.0 + turn * t) / (std::sqrt(std::expm1(v)) * std::sqrt(1.0 - t * turn * turn));
    const Complex decay = std::polar(std::exp(-v), -mode.angle);
    sums.decay(static_cast<Index>(i), k) = decay;
    sums.weight(static_cast<Index>(i), k) = 2.0 / std::numbers::pi * mode.front * rule.share[i] * density * decay;
  }
}

/// The weights of one mode against its exponentials, lag after lag.
class Comparison {
 public:
  Comparison(const Mode& mode, const ExponentialSums& sums, Index k)
      : mode_(mode),
        fade_(sums.decay.col(k).real()),
        turn_(sums.decay.col(k).imag()),
        real_(sums.weight.col(k).real()),
        imaginary_(sums.weight.col(k).imag()),
        total_(mode.front) {}

  /// |w_j - w~_j| of the next lags.
  void next(Eigen::Ref<ArrayXd> differences) {
    const Index r = fade_.size();
    for (double& difference : differences) {
      const double order = static_cast<double>(lag_++);
      const double after = ((2.0 * order + 1.0) * mode_.cosine * now_ - order * before_) / (order + 1.0);
      before_ = now_;
      now_ = after;
      const double exact = mode_.front * (now_ + before_);
      const double sum = real_.sum();
      for (Index i = 0; i < r; ++i) {
        const double x = real_[i], y = imaginary_[i];
        real_[i] = fade_[i] * x - turn_[i] * y;
        imaginary_[i] = fade_[i] * y + turn_[i] * x;
      }
      difference = std::abs(exact - sum);
      error_ += difference;
      total_ += std::abs(exact);
    }
  }

  double relative_error() const { return error_ / total_; }  ///< over all lags so far, W_0 in the denominator

 private:
  Mode mode_;
  ArrayXd fade_, turn_, real_, imaginary_;
  double now_ = 1.0, before_ = 0.0;
  long long lag_ = 0;
  double error_ = 0.0, total_;
};

void certify(const FaceModes& modes, double time_step, long long steps, numerics::ThreadPool* pool,
             ExponentialSums& sums) {
  const Index m = modes.load.rows();
  std::vector<Comparison> comparisons;
  for (Index k = 0; k < m; ++k) comparisons.emplace_back(mode_of(modes, time_step, k), sums, k);
  constexpr long long block = 4096;
  Eigen::ArrayXXd differences(block, m);
  double largest = 0.0;  // Σ_j max_k
  for (long long first = 0; first < steps; first += block) {
    const Index lags = std::min(block, steps - first);
    const auto share = [&](int k) { comparisons[static_cast<std::size_t>(k)].next(differences.col(k).head(lags)); };
    if (pool != nullptr) {
      pool->parallel_for(static_cast<int>(m), share);
    } else {
      for (int k = 0; k < static_cast<int>(m); ++k) share(k);
    }
    for (Index j = 0; j < lags; ++j) largest += differences.row(j).maxCoeff();
  }
  const double spread = Eigen::BDCSVD<Eigen::MatrixXd>(modes.load).singularValues()[0];
  sums.error = {.absolute = spread * spread * largest, .relative = 0.0};
  for (const Comparison& comparison : comparisons)
    sums.error.relative = std::fmax(sums.error.relative, comparison.relative_error());
  sums.certified_lags = steps;
}

}  // namespace

ExponentialSums modal_exponentials(const FaceModes& modes, double time_step, long long steps, double tolerance,
                                   numerics::ThreadPool* pool) {
  if (!(time_step > 0.0) || !std::isfinite(time_step))
    throw std::invalid_argument("time_step = " + std::to_string(time_step) + " must be finite and > 0");
  if (steps < 1) throw std::invalid_argument("steps = " + std::to_string(steps) + " must be >= 1");
  if (!(tolerance >= 1e-12) || !(tolerance <= 0.1))
    throw std::invalid_argument("tolerance = " + std::to_string(tolerance) + " must be 1e-12 … 0.1");
  const Index m = modes.load.rows();
  ExponentialSums sums;
  sums.mass.resize(m);
  for (Index k = 0; k < m; ++k) sums.mass[k] = mode_of(modes, time_step, k).front;
  // the rule errs by a small multiple of its aim, depending on the steps and angles; the certificate decides
  double aim = 0.3 * tolerance;
  for (int attempt = 0; attempt < 4 && !sums.within_tolerance; ++attempt, aim *= 0.2) {
    const Rule rule = rule_of(aim, steps);
    const auto r = static_cast<Index>(rule.v.size());
    sums.decay.resize(r, m);
    sums.weight.resize(r, m);
    for (Index k = 0; k < m; ++k) place(mode_of(modes, time_step, k), rule, k, sums);
    certify(modes, time_step, steps, pool, sums);
    sums.within_tolerance = sums.error.relative <= tolerance;
  }
  return sums;
}

}  // namespace sunder::reservoir
