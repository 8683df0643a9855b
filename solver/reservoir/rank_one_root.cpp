#include "solver/reservoir/rank_one_root.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;

constexpr int most_rounds = 200;
constexpr double tolerance = 1e-9;

/// 1/z without the checks for infinities of the standard's division.
Complex inverse(Complex z) {
  const double scale = 1.0 / (z.real() * z.real() + z.imag() * z.imag());
  return {z.real() * scale, -z.imag() * scale};
}

Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

RankOneRoot::RankOneRoot(Eigen::VectorXd d, Eigen::VectorXd b)
    : d_(std::move(d)),
      b_(std::move(b)),
      b2_(b_.cwiseAbs2()),
      shift_(d_.size()),
      mu_(d_.size()),
      vectors_(d_.size(), d_.size()) {}

/// Rounds of Newton's method on every root of the characteristic polynomial, each divided by the others.
bool RankOneRoot::improve(Complex sigma) {
  const Eigen::Index m = d_.size();
  const double small = 8.0 * std::numeric_limits<double>::epsilon();
  for (rounds_ = 1; rounds_ <= most_rounds; ++rounds_) {
    bool settled = true;
    for (Eigen::Index j = 0; j < m; ++j) {
      Complex sum = 0.0, slope = 0.0, others = 0.0;
      double nearest = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < m; ++i) {
        const Complex distance = d_[i] - d_[j] - shift_[j];
        nearest = std::fmin(nearest, std::norm(distance));
        const Complex one = inverse(distance), term = b2_[i] * one;
        sum += term;
        slope += times(term, one);
        others -= one;
        if (i != j) others -= inverse(d_[j] - d_[i] + shift_[j] - shift_[i]);
      }
      const Complex f = 1.0 + times(sigma, sum);
      const Complex change = times(f, inverse(times(sigma, slope) + times(f, others)));
      shift_[j] -= change;
      // what the vectors need is the distance to the nearest pole
      if (!(std::norm(change) <= small * small * nearest * static_cast<double>(m * m))) settled = false;
      if (!std::isfinite(change.real()) || !std::isfinite(change.imag())) return false;
    }
    if (settled) return true;
  }
  return true;  // the checks decide
}

bool RankOneRoot::form_vectors(Complex sigma) {
  const Eigen::Index m = d_.size();
  Complex trace = 0.0, dyad = 0.0;
  for (Eigen::Index j = 0; j < m; ++j) {
    Complex square = 0.0, along = 0.0;
    for (Eigen::Index i = 0; i < m; ++i) {
      const Complex one = inverse(d_[i] - d_[j] - shift_[j]);
      vectors_(i, j) = b_[i] * one;
      square += times(vectors_(i, j), vectors_(i, j));
      along += b_[i] * vectors_(i, j);
    }
    const Complex scale = inverse(std::sqrt(square));
    for (Eigen::Index i = 0; i < m; ++i) vectors_(i, j) = times(vectors_(i, j), scale);
    dyad += times(times(along, along), times(scale, scale));
    trace += shift_[j];
    mu_[j] = d_[j] + shift_[j];
  }
  const double total = b2_.sum();
  return std::abs(trace - sigma * total) <= tolerance * (std::abs(sigma) * total + d_.cwiseAbs().maxCoeff()) &&
         std::abs(dyad - total) <= tolerance * total;
}

void RankOneRoot::take_full_matrix(Complex sigma) {
  full_ = true;
  Eigen::MatrixXcd X = sigma * (b_ * b_.transpose()).cast<Complex>();
  X.diagonal() += d_.cast<Complex>();
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(X);
  mu_ = solver.eigenvalues();
  vectors_ = solver.eigenvectors();
  for (Eigen::Index j = 0; j < d_.size(); ++j) {
    const Complex square = (vectors_.col(j).transpose() * vectors_.col(j)).value();
    vectors_.col(j) /= std::sqrt(square);
  }
}

void RankOneRoot::decompose(Complex sigma, bool fresh) {
  full_ = false;
  if (sigma == 0.0 || b2_.sum() == 0.0) {
    shift_.setZero();
    mu_ = d_.cast<Complex>();
    vectors_ = Eigen::MatrixXcd::Identity(d_.size(), d_.size());
    rounds_ = 0;
    return;
  }
  // the last root's neighbourhood for every root, well apart from the poles
  const auto start = [&] {
    for (Eigen::Index j = 0; j < d_.size(); ++j) {
      const double above = j + 1 < d_.size() ? d_[j + 1] - d_[j] : d_[j] - (j > 0 ? d_[j - 1] : 0.0);
      const Complex first = sigma * b2_[j];
      shift_[j] = first / (1.0 + std::abs(first) / (0.5 * above));
      if (shift_[j] == 0.0) shift_[j] = 1e-300;
    }
  };
  if (fresh || !shift_.allFinite() || shift_.isZero(0.0)) start();
  if (improve(sigma) && form_vectors(sigma)) return;
  start();
  if (!improve(sigma) || !form_vectors(sigma)) take_full_matrix(sigma);
}

}  // namespace sunder::reservoir
