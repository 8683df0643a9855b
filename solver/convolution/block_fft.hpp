#pragma once
/// The convolution in O(N log² N) operations instead of O(N²), exact to rounding and without delay.
///
/// The triangle of all pairs (step, earlier acceleration) is cut into squares [Hairer, Lubich & Schlichte 1985]: after
/// i accelerations, with L the largest power of two times B that divides i, the last L accelerations are convolved with
/// W_1 … W_{2L-1} by one fast Fourier transform of length 2L and added to the forces of the L steps to come. What is
/// nearer than B is summed directly. The transforms of the weights are made once, of the lower triangles only.
///
/// A step costs the more the higher the power of two in its number: most a few products, number N/2 a transform over
/// the whole history. Memory: 8 n (n + 1) bytes a step for the transformed weights (twice the weights' own triangle; up
/// to twice that again where N lies just above a power of two times B), 48 n bytes a step for the rest.

#include <memory>
#include <vector>

#include "solver/convolution/convolution.hpp"
#include "solver/convolution/weight_sequence.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::convolution {

struct BlockFftOptions {
  int block = 32;                        ///< B, 1 … 4096: steps summed directly
  numerics::ThreadPool* pool = nullptr;  ///< shared by transforms and products; the same bits for any number of threads
};

class BlockFft final : public Convolution {
 public:
  /// For accelerations 0 … `steps`; the weights are not kept. Throws std::invalid_argument as `check(weights)`, where
  /// steps < 0 or B is out of range.
  BlockFft(const WeightSequence& weights, long long steps, const BlockFftOptions& options = {});
  ~BlockFft() override;

  int size() const override { return size_; }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override;
  /// Throws std::length_error after acceleration number `steps`.
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

  double bytes() const;  ///< held

 private:
  struct Level;
  struct Entry {
    int row, column;
  };
  template <class Work>
  void share(int count, const Work& work);
  void transform_weights(const WeightSequence& weights, Level& level);
  void add_square(Level& level);
  void multiply(const Level& level, int chunk);

  int size_, block_;
  bool diagonal_;
  long long steps_, count_ = 0;
  numerics::ThreadPool* pool_;
  Eigen::MatrixXd mass_;
  std::vector<Entry> entries_;                 // of the lower triangle, or the diagonal
  Eigen::MatrixXd near_;                       // (n·n or n, B) weights 0 … B - 1
  Eigen::VectorXd recent_;                     // accelerations of this block, newest first
  Eigen::MatrixXd history_, ahead_;            // (steps + 1, n) accelerations; forces of what lies beyond the block
  std::vector<Level> levels_;                  // L = B, 2B, 4B, …
  Eigen::MatrixXd sequence_, input_, output_;  // (2 L, n) in time, spectra of accelerations and forces
};

}  // namespace sunder::convolution
