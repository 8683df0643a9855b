#include "solver/convolution/hankel_product.hpp"

#include <algorithm>
#include <bit>

namespace sunder::convolution {
namespace {

template <class Work>
void share(numerics::ThreadPool* pool, int count, const Work& work) {
  if (pool != nullptr) return pool->parallel_for(count, work);
  for (int i = 0; i < count; ++i) work(i);
}

int entry_of(int size, int row, int column) {
  const auto [low, high] = std::minmax(row, column);
  return low * size - low * (low - 1) / 2 + high - low;
}

}  // namespace

HankelProduct::HankelProduct(const WeightSequence& weights, long long first, numerics::ThreadPool* pool)
    : size_(weights.size),
      blocks_(static_cast<int>(weights.last() - first + 1)),
      transform_(static_cast<int>(std::bit_ceil(2ULL * static_cast<unsigned long long>(blocks_)))),
      spectra_(2 * transform_.offset(), size_ * (size_ + 1) / 2),
      pool_(pool) {
  share(pool_, size_, [&](int c) {
    Eigen::VectorXd sequence(transform_.length());
    for (int r = c; r < size_; ++r) {
      sequence.setZero();
      for (int i = 0; i < blocks_; ++i)
        sequence[i] =
            weights.diagonal ? (r == c ? weights.values(r, first + i) : 0.0) : weights.values(c * size_ + r, first + i);
      transform_.forward(sequence.data(), spectra_.col(entry_of(size_, r, c)).data());
    }
  });
}

/// y_i = Σ_j W_{i+j} x_j is a correlation: W's spectrum times the conjugate of x's.
Eigen::MatrixXd HankelProduct::operator*(const Eigen::MatrixXd& x) const {
  const int offset = transform_.offset(), frequencies = transform_.frequencies();
  const double scale = 1.0 / transform_.length();
  Eigen::MatrixXd y(rows(), x.cols());
  share(pool_, static_cast<int>(x.cols()), [&](int column) {
    Eigen::VectorXd sequence(transform_.length());
    Eigen::MatrixXd in(2 * offset, size_);
    Eigen::VectorXd out(2 * offset);
    for (int d = 0; d < size_; ++d) {
      sequence.setZero();
      sequence.head(blocks_) = scale * x.col(column).segment(d * blocks_, blocks_);
      transform_.forward(sequence.data(), in.col(d).data());
    }
    for (int r = 0; r < size_; ++r) {
      out.setZero();
      double *yr = out.data(), *yi = yr + offset;
      for (int d = 0; d < size_; ++d) {
        const double *wr = spectra_.col(entry_of(size_, r, d)).data(), *wi = wr + offset;
        const double *xr = in.col(d).data(), *xi = xr + offset;
        for (int f = 0; f < frequencies; ++f) {
          yr[f] += wr[f] * xr[f] + wi[f] * xi[f];
          yi[f] += wi[f] * xr[f] - wr[f] * xi[f];
        }
      }
      transform_.backward(out.data(), sequence.data());
      y.col(column).segment(r * blocks_, blocks_) = sequence.head(blocks_);
    }
  });
  return y;
}

}  // namespace sunder::convolution
