#include "solver/faces/complementarity.hpp"

#include <cmath>
#include <limits>

namespace sunder::faces {
namespace {

constexpr int patience = 8;

/// Gaussian elimination with partial pivoting in place on the leading n by n block and its right side: a few dozen
/// unknowns, and no memory of its own. False where a pivot vanishes against its column's first size.
bool solve_in_place(Eigen::MatrixXd& A, Eigen::VectorXd& b, Eigen::Index n) {
  const double size = A.topLeftCorner(n, n).cwiseAbs().maxCoeff();
  const double least = size * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(pivot, k))) pivot = i;
    }
    if (!(std::abs(A(pivot, k)) > least)) return false;
    if (pivot != k) {
      A.row(k).head(n).swap(A.row(pivot).head(n));
      std::swap(b[k], b[pivot]);
    }
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const double factor = A(i, k) / A(k, k);
      A(i, k) = 0.0;
      A.row(i).segment(k + 1, n - k - 1) -= factor * A.row(k).segment(k + 1, n - k - 1);
      b[i] -= factor * b[k];
    }
  }
  for (Eigen::Index k = n; k-- > 0;) {
    b[k] -= A.row(k).segment(k + 1, n - k - 1).dot(b.segment(k + 1, n - k - 1));
    b[k] /= A(k, k);
  }
  return true;
}

}  // namespace

ComplementarityProblem::ComplementarityProblem(Eigen::Index largest)
    : touching_(static_cast<std::size_t>(largest), 0), block_(largest, largest), right_(largest), slack_(largest) {
  active_.reserve(static_cast<std::size_t>(largest));
}

ComplementarityStatus ComplementarityProblem::solve(const Eigen::Ref<const Eigen::MatrixXd>& M,
                                                    const Eigen::Ref<const Eigen::VectorXd>& q,
                                                    Eigen::Ref<Eigen::VectorXd> lambda, const Columns& will_read) {
  const Eigen::Index n = q.size();
  // A force of round-off, or a gap of round-off, is no reason to change sides.
  const double small_gap = 8.0 * std::numeric_limits<double>::epsilon() * (n > 0 ? q.cwiseAbs().maxCoeff() : 0.0);
  const int max_exchanges = 50 + 10 * static_cast<int>(n);
  Eigen::Index fewest = n + 1;
  int tries = patience;
  for (exchanges_ = 0; exchanges_ <= max_exchanges; ++exchanges_) {
    active_.clear();
    for (Eigen::Index i = 0; i < n; ++i) {
      if (touches(i)) active_.push_back(i);
    }
    const auto count = static_cast<Eigen::Index>(active_.size());
    if (will_read && count > 0) will_read(active_);
    for (Eigen::Index j = 0; j < count; ++j) {
      right_[j] = -q[active_[j]];
      for (Eigen::Index i = 0; i < count; ++i) block_(i, j) = M(active_[i], active_[j]);
    }
    if (count > 0 && !solve_in_place(block_, right_, count)) {
      lambda.setZero();
      return ComplementarityStatus::singular;
    }
    slack_.head(n) = q;
    lambda.setZero();
    double largest_force = 0.0;
    for (Eigen::Index j = 0; j < count; ++j) {
      lambda[active_[j]] = right_[j];
      largest_force = std::fmax(largest_force, std::abs(right_[j]));
      slack_.head(n) += right_[j] * M.col(active_[j]);
    }
    const double small_force = 8.0 * std::numeric_limits<double>::epsilon() * largest_force;
    const auto wrong = [&](Eigen::Index i) { return touches(i) ? lambda[i] < -small_force : slack_[i] < -small_gap; };
    Eigen::Index broken = 0, last = -1;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (wrong(i)) {
        ++broken;
        last = i;
      }
    }
    if (broken == 0) {
      for (Eigen::Index i = 0; i < n; ++i) lambda[i] = std::fmax(lambda[i], 0.0);
      return ComplementarityStatus::solved;
    }
    if (broken < fewest) {
      fewest = broken;
      tries = patience;
    } else {
      --tries;
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      if (tries > 0 ? wrong(i) : i == last) touching_[static_cast<std::size_t>(i)] ^= 1;
    }
  }
  lambda = lambda.cwiseMax(0.0);
  return ComplementarityStatus::not_converged;
}

}  // namespace sunder::faces
