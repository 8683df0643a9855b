#include "solver/foundation/dynamic_stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace sunder::foundation {
namespace {

using Eigen::MatrixXd;
using Complex = std::complex<double>;

/// A complex symmetric matrix in two real parts: products of real matrices are the fastest there are.
struct Split {
  MatrixXd re, im;

  explicit Split(Eigen::Index n) : re(MatrixXd::Zero(n, n)), im(MatrixXd::Zero(n, n)) {}
  void add(double factor, const Split& other) {
    re += factor * other.re;
    im += factor * other.im;
  }
};

/// Where the series is used and how many of its terms: the first one left out is ≤ tolerance · ‖g‖ at |σ| = start.
struct SeriesRange {
  double start = 0.0;
  std::size_t terms = 0;
};

SeriesRange series_range(const UnboundedDomain& domain, double tolerance) {
  const double bound = tolerance * (domain.k + domain.e1).norm();
  SeriesRange range{.start = HUGE_VAL};
  for (std::size_t j = 2; j < domain.series.size(); ++j) {
    const auto from = [&](std::size_t term) {
      return std::pow(domain.series[term - 1].norm() / bound, 1.0 / static_cast<double>(term));
    };
    const double start = std::max(from(j), from(j + 1));  // a single term may happen to be small
    if (start < range.start) range = {start, j - 1};
  }
  return range;
}

/// t = Σ a_j σ^-j by Horner's scheme.
void evaluate_series(const UnboundedDomain& domain, std::size_t terms, Complex sigma, Split& t) {
  const Complex inverse = 1.0 / sigma;
  t.re.setZero();
  t.im.setZero();
  for (std::size_t j = terms; j-- > 0;) {
    t.re += domain.series[j];
    const MatrixXd re = inverse.real() * t.re - inverse.imag() * t.im;
    t.im = inverse.real() * t.im + inverse.imag() * t.re;
    t.re = re;
  }
}

/// The integrator, with its memory.
class Integrator {
 public:
  Integrator(const UnboundedDomain& domain, double tolerance)
      : domain_(domain),
        g_(domain.k + domain.e1),
        decay_(domain.c.replicate(1, domain.size()) + domain.c.transpose().replicate(domain.size(), 1)),
        tolerance_(tolerance),
        t(domain.size()),
        stage_(domain.size()),
        a_(domain.size(), domain.size()),
        b_(a_),
        re_(a_),
        im_(a_) {
    slopes_.assign(7, Split(domain.size()));
  }

  /// From σ to σ e^{length}. `step` is the fraction of the way that is tried first, and, after it, the last one taken.
  StiffnessStatus go(Complex sigma, Complex length, double& step, StiffnessPath& path, long max_steps);

 private:
  void slope(Complex sigma, Complex length, const Split& at, Split& result);
  double attempt(Complex sigma, Complex length, double from, double step);

  const UnboundedDomain& domain_;
  MatrixXd g_, decay_;
  double tolerance_;

 public:
  Split t;

 private:
  Split stage_;
  MatrixXd a_, b_, re_, im_;
  std::vector<Split> slopes_;
};

/// length · (σ (c t + t c) + (g + t)(g + t)ᵀ - e2). With g + t = a + i b the product has the real part
/// sym((a + b)(a - b)ᵀ) and the imaginary part 2 sym(a bᵀ): two products of matrices.
void Integrator::slope(Complex sigma, Complex length, const Split& at, Split& result) {
  const Eigen::Index n = domain_.size();
  result.re = g_ + at.re + at.im;
  result.im = g_ + at.re - at.im;
  a_.noalias() = result.re * result.im.transpose();
  result.re = g_ + at.re;
  b_.noalias() = result.re * at.im.transpose();
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i <= j; ++i) {
      const Complex value(0.5 * (a_(i, j) + a_(j, i)) - domain_.e2(i, j), b_(i, j) + b_(j, i));
      const Complex slope = length * (sigma * decay_(i, j) * Complex(at.re(i, j), at.im(i, j)) + value);
      result.re(i, j) = result.re(j, i) = slope.real();
      result.im(i, j) = result.im(j, i) = slope.imag();
    }
  }
}

/// One step of Dormand & Prince's pair [Dormand & Prince 1980, Table 2]; slopes_[0] is known. Returns the error over
/// the tolerance; stage_ is then the new t and slopes_[6] the slope there.
double Integrator::attempt(Complex sigma, Complex length, double from, double step) {
  static constexpr std::array<double, 7> node{0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};
  static constexpr std::array<std::array<double, 6>, 7> weight{{
      {},
      {0.2},
      {3.0 / 40.0, 9.0 / 40.0},
      {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
      {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
      {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
      {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
  }};
  static constexpr std::array<double, 7> difference{71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                                    -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
  for (int i = 1; i < 7; ++i) {
    stage_ = t;
    for (int j = 0; j < i; ++j) {
      if (weight[i][j] != 0.0) stage_.add(step * weight[i][j], slopes_[j]);
    }
    slope(sigma * std::exp(length * (from + step * node[i])), length, stage_, slopes_[i]);
  }
  re_.setZero();
  im_.setZero();
  for (int j = 0; j < 7; ++j) {
    if (difference[j] == 0.0) continue;
    re_ += difference[j] * slopes_[j].re;
    im_ += difference[j] * slopes_[j].im;
  }
  const double error = step * std::hypot(re_.norm(), im_.norm());
  return error / (tolerance_ * std::hypot((g_ + stage_.re).norm(), stage_.im.norm()));
}

StiffnessStatus Integrator::go(Complex sigma, Complex length, double& step, StiffnessPath& path, long max_steps) {
  double done = 0.0;
  slope(sigma, length, t, slopes_[0]);
  while (done < 1.0) {
    if (path.steps + path.rejected >= max_steps) return StiffnessStatus::too_many_steps;
    const double tried = std::min(step, 1.0 - done);
    const double error = attempt(sigma, length, done, tried);
    if (!std::isfinite(error) && tried < 1e-12) return StiffnessStatus::not_finite;
    const double change = std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0) : 0.2;
    if (error <= 1.0) {
      ++path.steps;
      done = tried == 1.0 - done ? 1.0 : done + tried;
      std::swap(t, stage_);
      std::swap(slopes_[0], slopes_[6]);
      step = tried < step ? std::max(step, tried * change) : tried * change;  // a cut step says little of the next
    } else {
      ++path.rejected;
      step = tried * change;
      if (step < 1e-14) return StiffnessStatus::too_many_steps;
    }
  }
  return StiffnessStatus::converged;
}

void check(std::span<const Complex> s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double size = std::abs(s[i]);
    if (!(s[i].real() >= 0.0 && size > 0.0 && std::isfinite(size)) ||
        (i > 0 && size > std::abs(s[i - 1]) * (1.0 + 1e-9))) {
      std::ostringstream message;
      message << "s[" << i << "] = " << s[i] << " 1/s, accepted is Re s >= 0, s != 0, |s| not above the one before";
      throw std::invalid_argument(message.str());
    }
  }
}

}  // namespace

StiffnessPath dynamic_stiffness(const UnboundedDomain& domain, std::span<const Complex> s,
                                const std::function<void(std::size_t, const Eigen::MatrixXcd&)>& visit,
                                const StiffnessOptions& options) {
  check(s);
  if (!(options.tolerance > 0.0)) throw std::invalid_argument("tolerance must be > 0");
  const SeriesRange range = series_range(domain, options.tolerance);
  StiffnessPath path{.start = range.start / domain.time};
  if (!std::isfinite(range.start)) {
    path.status = StiffnessStatus::not_finite;
    return path;
  }
  Integrator integrator(domain, options.tolerance);
  const Eigen::Index n = domain.size();
  Eigen::MatrixXd re(n, n), im(n, n);
  Eigen::MatrixXcd S(n, n);
  Complex sigma = 0.0;     // where integrator.t stands; 0: has not begun
  double log_step = 1e-3;  // size of the last step in ln σ
  const auto advance = [&](Complex& from, Complex to) {
    const Complex length = std::log(to / from);
    StiffnessStatus status = StiffnessStatus::converged;
    if (std::abs(length) > 0.0) {
      double step = log_step / std::abs(length);
      status = integrator.go(from, length, step, path, options.max_steps);
      log_step = step * std::abs(length);
    }
    from = to;
    return status;
  };
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Complex to = s[i] * domain.time;
    if (std::abs(to) >= range.start) {
      evaluate_series(domain, range.terms, to, integrator.t);
    } else {
      if (sigma == 0.0) {
        // Far inwards on the real axis all errors die out; on the imaginary one those of high frequency only add up.
        const bool by_real_axis = std::abs(to) < 0.25 * range.start;
        sigma = by_real_axis ? Complex(range.start) : to / std::abs(to) * range.start;
        evaluate_series(domain, range.terms, sigma, integrator.t);
        if (by_real_axis) path.status = advance(sigma, std::abs(to));
      }
      if (path.status == StiffnessStatus::converged) path.status = advance(sigma, to);
      if (path.status != StiffnessStatus::converged) return path;
    }
    re = domain.k + integrator.t.re;
    re.diagonal() += to.real() * domain.c;
    im = integrator.t.im;
    im.diagonal() += to.imag() * domain.c;
    S.real() = domain.F * re * domain.F.transpose();
    S.imag() = domain.F * im * domain.F.transpose();
    if (!S.allFinite()) {
      path.status = StiffnessStatus::not_finite;
      return path;
    }
    visit(i, S);
    path.reached = i + 1;
  }
  return path;
}

}  // namespace sunder::foundation
