#include "solver/convolution/direct_sum.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::convolution {
namespace {

constexpr int part_count = 4;  // of the lags of a block, for the threads

/// Inner length of one product. Eigen packs both factors; below 128 KiB each it does so on the stack, so that a step
/// allocates nothing.
long long inner_length(int size, int block) {
  return std::max<long long>(14000 / std::max(size, block), 1);
}

}  // namespace

DirectSum::DirectSum(WeightSequence weights, long long steps, const DirectOptions& options)
    : weights_(std::move(weights)), pool_(options.pool), block_(options.block), steps_(steps) {
  check(weights_);
  if (steps < 0) throw std::invalid_argument("DirectSum: steps = " + std::to_string(steps) + " must be >= 0");
  if (block_ < 1 || block_ > 1024)
    throw std::invalid_argument("DirectSum: block = " + std::to_string(block_) + " must be 1 … 1024");
  if (weights_.diagonal) block_ = 1;  // n products a lag: nothing to reuse
  mass_ = weights_.weight(0);
  if (numerics::planted_fault("convolution/no-instantaneous-mass")) mass_.setZero();
  history_.setZero((steps_ + 1 + block_) * size());
  if (block_ > 1) {
    ahead_.setZero(size(), block_);
    parts_.assign(part_count, ahead_);
  }
}

const double* DirectSum::newest(long long before) const {
  return history_.data() + (steps_ - before + 1) * size();
}

/// Adds Σ_{first <= j <= last} W_j a_{now-j}.
void DirectSum::add_lags(long long first, long long last, long long now, double* force) const {
  if (last < first) return;
  const int n = size();
  const double* past = newest(now - first + 1);
  Eigen::Map<Eigen::VectorXd> sum(force, n);
  if (weights_.diagonal) {
    const Eigen::Map<const Eigen::MatrixXd> a(past, n, last - first + 1);
    for (long long j = first; j <= last; ++j) sum += weights_.values.col(j).cwiseProduct(a.col(j - first));
    return;
  }
  const Eigen::Map<const Eigen::MatrixXd> W(weights_.values.col(first).data(), n, (last - first + 1) * n);
  sum.noalias() += W * Eigen::Map<const Eigen::VectorXd>(past, W.cols());
}

void DirectSum::history_force(Eigen::Ref<Eigen::VectorXd> force) {
  const long long reach = std::min(count_, weights_.last());
  const bool late = numerics::planted_fault("convolution/one-step-late");
  if (block_ == 1) {
    force.setZero();
    add_lags(1, reach, late ? count_ - 1 : count_, force.data());
    return;
  }
  force = ahead_.col(block_ - 1 - count_ % block_);
  add_lags(1, std::min<long long>(reach, block_ - 1), late ? count_ - 1 : count_, force.data());
}

/// Lags B … of one share of the inner products, in a fixed order.
void DirectSum::sum_block_part(int part) {
  const int n = size();
  const long long lags = std::max<long long>(std::min(count_, weights_.last() - block_ + 1), 0);
  const long long step = std::max<long long>(inner_length(n, block_) / n, 1);
  const long long products = (lags + step - 1) / step;
  Eigen::MatrixXd& sum = parts_[static_cast<std::size_t>(part)];
  sum.setZero();
  for (long long p = products * part / part_count; p < products * (part + 1) / part_count; ++p) {
    const long long from = p * step, to = std::min(from + step, lags);
    const Eigen::Map<const Eigen::MatrixXd> W(weights_.values.col(block_ + from).data(), n, (to - from) * n);
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> a(newest(count_) + from * n, (to - from) * n,
                                                                       block_, Eigen::OuterStride<>(n));
    sum.noalias() += W * a;
  }
}

void DirectSum::sum_block() {
  const auto share = [this](int part) { sum_block_part(part); };
  if (pool_ != nullptr) {
    pool_->parallel_for(part_count, share);
  } else {
    for (int part = 0; part < part_count; ++part) share(part);
  }
  ahead_ = parts_[0];
  for (int part = 1; part < part_count; ++part) ahead_ += parts_[static_cast<std::size_t>(part)];
}

void DirectSum::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  if (count_ > steps_)
    throw std::length_error("DirectSum: made for accelerations 0 … " + std::to_string(steps_) + ", got one more");
  history_.segment((steps_ - count_) * size(), size()) = acceleration;
  ++count_;
  if (block_ > 1 && count_ % block_ == 0) sum_block();
}

double DirectSum::bytes() const {
  return weights_.bytes() + 8.0 * static_cast<double>(history_.size() + ahead_.size() * (1 + part_count));
}

}  // namespace sunder::convolution
