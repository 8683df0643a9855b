#include "solver/contact/free_factor.hpp"

#include <cmath>
#include <limits>

namespace sunder::contact {

void FreeFactor::reserve(int most) {
  L_.setZero(most, most);
  row_.setZero(most);
  members_.assign(static_cast<std::size_t>(most), -1);
  count_ = 0;
}

bool FreeFactor::independent(double pivot, double diagonal) const {
  // A Schur complement is worth no more than the round-off of its m subtractions.
  return pivot > 4.0 * (count_ + 1) * std::numeric_limits<double>::epsilon() * diagonal;
}

bool FreeFactor::append(const Eigen::MatrixXd& M, int j) {
  auto row = row_.head(count_);
  for (int i = 0; i < count_; ++i) row[i] = M(members_[i], j);
  L_.topLeftCorner(count_, count_).triangularView<Eigen::Lower>().solveInPlace(row);
  const double pivot = M(j, j) - row.squaredNorm();
  if (!independent(pivot, M(j, j))) return false;
  L_.row(count_).head(count_) = row.transpose();
  L_(count_, count_) = std::sqrt(pivot);
  members_[count_++] = j;
  return true;
}

void FreeFactor::remove(int p) {
  const int behind = count_ - p - 1;
  auto w = row_.head(behind);
  w = L_.col(p).segment(p + 1, behind);
  for (int c = 0; c < p; ++c) {
    for (int r = p; r + 1 < count_; ++r) L_(r, c) = L_(r + 1, c);
  }
  for (int c = p + 1; c < count_; ++c) {
    for (int r = c; r < count_; ++r) L_(r - 1, c - 1) = L_(r, c);
  }
  for (int i = p; i + 1 < count_; ++i) members_[i] = members_[i + 1];
  --count_;
  // What stood left of the removed column is lost to the rows behind it: L Lᵀ + w wᵀ, one rotation a column.
  for (int i = 0; i < behind; ++i) {
    const int at = p + i, below = behind - i - 1;
    const double diagonal = L_(at, at), length = std::hypot(diagonal, w[i]);
    const double cosine = diagonal / length, sine = w[i] / length;
    L_(at, at) = length;
    auto column = L_.col(at).segment(at + 1, below);
    auto rest = w.tail(below);
    for (int r = 0; r < below; ++r) {
      const double old = column[r];
      column[r] = cosine * old + sine * rest[r];
      rest[r] = cosine * rest[r] - sine * old;
    }
  }
}

bool FreeFactor::factorise(const Eigen::MatrixXd& M, std::span<const int> members) {
  count_ = 0;
  const int m = static_cast<int>(members.size());
  for (int j = 0; j < m; ++j) {  // left-looking: column j once all columns before it are known
    auto column = L_.col(j).segment(j, m - j);
    for (int i = j; i < m; ++i) column[i - j] = M(members[i], members[j]);
    if (j > 0) {
      row_.head(j) = L_.row(j).head(j).transpose();
      column.noalias() -= L_.block(j, 0, m - j, j) * row_.head(j);
    }
    const double pivot = column[0];
    if (!independent(pivot, M(members[j], members[j]))) return false;
    column /= std::sqrt(pivot);
    members_[j] = members[j];
    count_ = j + 1;
  }
  return true;
}

void FreeFactor::solve_in_place(Eigen::Ref<Eigen::VectorXd> b) const {
  const auto L = L_.topLeftCorner(count_, count_);
  L.triangularView<Eigen::Lower>().solveInPlace(b);
  L.transpose().triangularView<Eigen::Upper>().solveInPlace(b);
}

}  // namespace sunder::contact
