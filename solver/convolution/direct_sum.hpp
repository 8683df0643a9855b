#pragma once
/// The convolution summed as it is written: the reference of all faster ones, exact to the order of its additions.
///
/// Plain: one product of W_1 … W_k, side by side, with the accelerations, newest first: n² k numbers are read for 2 n²
/// k operations, so the memory decides. Blocked: the lags >= B of B coming steps at once, [W_B W_{B+1} …] times the
/// Hankel matrix of the accelerations, whose columns are the same memory shifted by one step: each weight is used B
/// times while it is in the cache. The lags below B are summed at each step.
///
/// Memory: the weights, and 8 n (steps + B) bytes of accelerations.

#include <vector>

#include "solver/convolution/convolution.hpp"
#include "solver/convolution/weight_sequence.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::convolution {

struct DirectOptions {
  int block = 1;                         ///< B, 1 … 1024; 1: plain
  numerics::ThreadPool* pool = nullptr;  ///< of the blocks; the bits are the same for any number of threads
};

class DirectSum final : public Convolution {
 public:
  /// For accelerations 0 … `steps`. Throws std::invalid_argument as `check(weights)`, where steps < 0 or B is out of
  /// range.
  DirectSum(WeightSequence weights, long long steps, const DirectOptions& options = {});

  int size() const override { return weights_.size; }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override;
  /// Throws std::length_error after acceleration number `steps`.
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

  double bytes() const;  ///< held

 private:
  const double* newest(long long before) const;
  void add_lags(long long first, long long last, long long now, double* force) const;
  void sum_block();
  void sum_block_part(int part);

  WeightSequence weights_;
  Eigen::MatrixXd mass_;
  numerics::ThreadPool* pool_;
  int block_;
  long long steps_, count_ = 0;
  Eigen::VectorXd history_;             // newest first: acceleration q at (steps - q) n; then B zeros
  Eigen::MatrixXd ahead_;               // (n, B) far lags of the steps count_ … of this block, last step first
  std::vector<Eigen::MatrixXd> parts_;  // partial sums in fixed places: the bits do not depend on threads
};

}  // namespace sunder::convolution
