#pragma once
/// Products with the block Hankel matrix of a sequence of weights. Private to this module.

#include <Eigen/Core>
#include <vector>

#include "solver/convolution/real_transform.hpp"
#include "solver/convolution/weight_sequence.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::convolution {

/// H_ij = W_{first+i+j}, i, j = 0 … blocks - 1, zero after the last weight. A block vector is (blocks, n) a column of a
/// matrix (blocks·n, q), degree of freedom by degree of freedom: row d·blocks + i.
class HankelProduct {
 public:
  HankelProduct(const WeightSequence& weights, long long first, numerics::ThreadPool* pool);
  int blocks() const { return blocks_; }
  int rows() const { return blocks_ * size_; }
  /// H x for all columns of x.
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& x) const;

 private:
  int size_, blocks_;
  RealTransform transform_;
  Eigen::MatrixXd spectra_;  // (2 offset, n (n + 1) / 2)
  numerics::ThreadPool* pool_;
};

}  // namespace sunder::convolution
