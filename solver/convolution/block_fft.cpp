#include "solver/convolution/block_fft.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "solver/convolution/real_transform.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::convolution {
namespace {

/// Frequencies multiplied together: the transforms of a chunk of accelerations and forces stay in the cache while the
/// weights stream past.
constexpr int chunk_length = 32;

/// y += w x of one chunk of complex numbers in split form.
void add_product(const double* w, const double* xr, const double* xi, double* yr, double* yi) {
  for (int f = 0; f < chunk_length; ++f) {
    yr[f] += w[f] * xr[f] - w[chunk_length + f] * xi[f];
    yi[f] += w[f] * xi[f] + w[chunk_length + f] * xr[f];
  }
}

int chunks_of(int frequencies) {
  return (frequencies + chunk_length - 1) / chunk_length;
}

}  // namespace

struct BlockFft::Level {
  int length;               // L
  RealTransform transform;  // of 2 L
  Eigen::VectorXd weights;  // chunk by chunk, entry by entry: real parts, imaginary parts
};

BlockFft::~BlockFft() = default;

BlockFft::BlockFft(const WeightSequence& weights, long long steps, const BlockFftOptions& options)
    : size_(weights.size),
      block_(options.block),
      diagonal_(weights.diagonal),
      steps_(steps),
      pool_(options.pool),
      mass_() {
  check(weights);
  if (steps < 0 || steps > (1LL << 28))
    throw std::invalid_argument("BlockFft: steps = " + std::to_string(steps) + " must be 0 … 2^28");
  if (block_ < 1 || block_ > 4096)
    throw std::invalid_argument("BlockFft: block = " + std::to_string(block_) + " must be 1 … 4096");
  mass_ = weights.weight(0);
  for (int c = 0; c < size_; ++c)
    for (int r = c; r < (diagonal_ ? c + 1 : size_); ++r) entries_.push_back({r, c});
  near_.setZero(weights.values.rows(), block_);
  const long long kept = std::min<long long>(block_, weights.last() + 1);
  near_.leftCols(kept) = weights.values.leftCols(kept);
  recent_.setZero(static_cast<Eigen::Index>(block_) * size_);
  history_.setZero(steps_ + 1, size_);
  ahead_.setZero(steps_ + 1, size_);
  // a square at i = L is of use where a step i exists; weights that are zero make none
  for (long long L = block_; L <= steps_; L *= 2) {
    levels_.push_back({static_cast<int>(L), RealTransform(static_cast<int>(2 * L)), {}});
    transform_weights(weights, levels_.back());
  }
  if (levels_.empty()) return;
  sequence_.setZero(2 * levels_.back().length, size_);
  input_.setZero(2 * levels_.back().transform.offset(), size_);
  output_ = input_;
}

template <class Work>
void BlockFft::share(int count, const Work& work) {
  if (pool_ != nullptr) return pool_->parallel_for(count, work);
  for (int i = 0; i < count; ++i) work(i);
}

void BlockFft::transform_weights(const WeightSequence& weights, Level& level) {
  const int frequencies = level.transform.frequencies(), chunks = chunks_of(frequencies);
  const auto entry_count = static_cast<int>(entries_.size());
  const long long last = std::min<long long>(weights.last(), 2LL * level.length - 1);
  level.weights.setZero(static_cast<Eigen::Index>(chunks) * entry_count * 2 * chunk_length);
  const double scale = 1.0 / (2.0 * level.length);  // of the transform there and back
  // `group` entries at a time: they lie side by side in each weight
  constexpr int group = 8;
  share((entry_count + group - 1) / group, [&](int g) {
    const int first = g * group, end = std::min(first + group, entry_count);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(2 * level.length, end - first);
    for (long long j = 1; j <= last; ++j) {
      const double* values = weights.values.col(j).data();
      for (int e = first; e < end; ++e) {
        const Entry at = entries_[static_cast<std::size_t>(e)];
        x(j, e - first) = scale * values[diagonal_ ? at.row : at.column * size_ + at.row];
      }
    }
    Eigen::VectorXd spectrum(2 * level.transform.offset());
    for (int e = first; e < end; ++e) {
      level.transform.forward(x.col(e - first).data(), spectrum.data());
      for (int chunk = 0; chunk < chunks; ++chunk) {
        const int from = chunk * chunk_length, count = std::min(chunk_length, frequencies - from);
        double* out = level.weights.data() + (static_cast<Eigen::Index>(chunk) * entry_count + e) *
                                                 static_cast<Eigen::Index>(2 * chunk_length);
        std::copy_n(spectrum.data() + from, count, out);
        std::copy_n(spectrum.data() + level.transform.offset() + from, count, out + chunk_length);
      }
    }
  });
}

void BlockFft::history_force(Eigen::Ref<Eigen::VectorXd> force) {
  if (count_ > steps_) {  // no such step; `append` says so
    force.setZero();
    return;
  }
  force = ahead_.row(count_).transpose();
  const long long inside = count_ % block_;
  if (inside == 0) return;
  const double* past = recent_.data() + (block_ - inside) * size_;
  if (diagonal_) {
    const Eigen::Map<const Eigen::MatrixXd> a(past, size_, inside);
    for (long long j = 1; j <= inside; ++j) force += near_.col(j).cwiseProduct(a.col(j - 1));
    return;
  }
  const Eigen::Map<const Eigen::MatrixXd> W(near_.col(1).data(), size_, inside * size_);
  force.noalias() += W * Eigen::Map<const Eigen::VectorXd>(past, W.cols());
}

void BlockFft::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  if (count_ > steps_)
    throw std::length_error("BlockFft: made for accelerations 0 … " + std::to_string(steps_) + ", got one more");
  recent_.segment((block_ - 1 - count_ % block_) * size_, size_) = acceleration;
  history_.row(count_) = acceleration.transpose();
  ++count_;
  if (count_ % block_ != 0 || count_ > steps_) return;
  std::size_t power = 0;
  for (long long blocks = count_ / block_; blocks % 2 == 0; blocks /= 2) ++power;
  add_square(levels_[power]);
}

void BlockFft::multiply(const Level& level, int chunk) {
  const auto entry_count = static_cast<Eigen::Index>(entries_.size());
  const double* w = level.weights.data() + chunk * entry_count * 2 * chunk_length;
  const Eigen::Index from = static_cast<Eigen::Index>(chunk) * chunk_length, offset = level.transform.offset();
  for (int d = 0; d < size_; ++d) {
    output_.col(d).segment<chunk_length>(from).setZero();
    output_.col(d).segment<chunk_length>(offset + from).setZero();
  }
  const auto add = [&](int column, int row) {
    const double* x = input_.col(column).data() + from;
    double* y = output_.col(row).data() + from;
    add_product(w, x, x + offset, y, y + offset);
  };
  for (const Entry& at : entries_) {
    add(at.column, at.row);
    if (at.row != at.column) add(at.row, at.column);
    w += 2 * chunk_length;
  }
}

void BlockFft::add_square(Level& level) {
  const int L = level.length;
  share(size_, [&](int d) {
    sequence_.col(d).head(L) = history_.col(d).segment(count_ - L, L);
    sequence_.col(d).segment(L, L).setZero();
    level.transform.forward(sequence_.col(d).data(), input_.col(d).data());
  });
  share(chunks_of(level.transform.frequencies()), [&](int chunk) { multiply(level, chunk); });
  const long long ahead = std::min<long long>(L, steps_ + 1 - count_);
  const int from = numerics::planted_fault("convolution/square-shifted") ? L - 1 : L;
  share(size_, [&](int d) {
    level.transform.backward(output_.col(d).data(), sequence_.col(d).data());
    ahead_.col(d).segment(count_, ahead) += sequence_.col(d).segment(from, ahead);
  });
}

double BlockFft::bytes() const {
  Eigen::Index numbers =
      near_.size() + recent_.size() + history_.size() + ahead_.size() + sequence_.size() + 2 * input_.size();
  for (const Level& level : levels_) numbers += level.weights.size();
  return 8.0 * static_cast<double>(numbers);
}

}  // namespace sunder::convolution
