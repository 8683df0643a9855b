/// Every way to convolve against the sum as it is written.

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/direct_sum.hpp"

namespace sunder::convolution {
namespace {

struct Motion {
  WeightSequence weights;
  Eigen::MatrixXd acceleration;  // (n, steps + 1)
};

/// Weights that fade like a kernel with memory, and white noise.
Motion noise(int size, long long last, long long steps, bool diagonal = false) {
  std::mt19937_64 generator(7);
  const auto draw = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; };
  Motion motion;
  motion.weights = {size, diagonal, Eigen::MatrixXd(diagonal ? size : size * size, last + 1)};
  for (long long j = 0; j <= last; ++j) {
    Eigen::MatrixXd W(size, size);
    for (double& w : W.reshaped()) w = draw() / std::sqrt(1.0 + static_cast<double>(j));
    W = (W + W.transpose()).eval();
    if (diagonal) {
      motion.weights.values.col(j) = W.diagonal();
    } else {
      motion.weights.values.col(j) = W.reshaped();
    }
  }
  motion.acceleration.resize(size, steps + 1);
  for (double& a : motion.acceleration.reshaped()) a = draw();
  return motion;
}

/// Σ_{j>=1} W_j a_{n-j}, pair by pair.
Eigen::MatrixXd as_written(const Motion& motion) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(motion.acceleration.rows(), motion.acceleration.cols());
  for (Eigen::Index n = 0; n < forces.cols(); ++n)
    for (Eigen::Index j = 1; j <= std::min<Eigen::Index>(n, motion.weights.last()); ++j)
      forces.col(n) += motion.weights.weight(j) * motion.acceleration.col(n - j);
  return forces;
}

Eigen::MatrixXd run(Convolution& convolution, const Eigen::MatrixXd& acceleration) {
  Eigen::MatrixXd forces(acceleration.rows(), acceleration.cols());
  for (Eigen::Index n = 0; n < forces.cols(); ++n) {
    convolution.history_force(forces.col(n));
    convolution.append(acceleration.col(n));
  }
  return forces;
}

/// Round-off of a sum of N terms by pairs or by transforms: far below 1e-12 of the largest force.
constexpr double round_off = 1e-12;

TEST(Convolution, EveryWayGivesTheSumAsItIsWritten) {
  struct Case {
    const char* description;
    int size;
    long long last, steps;
    bool diagonal;
  };
  for (const Case& c :
       {Case{"one step", 3, 1, 1, false}, Case{"no step", 2, 0, 0, false},
        Case{"as many weights as steps", 3, 300, 300, false}, Case{"weights end before the steps", 4, 57, 300, false},
        Case{"more weights than steps", 2, 300, 70, false}, Case{"a power of two", 3, 256, 256, false},
        Case{"diagonal", 5, 300, 300, true}, Case{"one degree of freedom", 1, 130, 130, false}}) {
    SCOPED_TRACE(c.description);
    const Motion motion = noise(c.size, c.last, c.steps, c.diagonal);
    const Eigen::MatrixXd exact = as_written(motion);
    const double bound = round_off * std::max(1.0, exact.cwiseAbs().maxCoeff());
    for (const int block : {1, 2, 7, 32}) {
      DirectSum direct(motion.weights, c.steps, {.block = block});
      EXPECT_LE((run(direct, motion.acceleration) - exact).cwiseAbs().maxCoeff(), bound) << "direct, block " << block;
      BlockFft fast(motion.weights, c.steps, {.block = block});
      EXPECT_LE((run(fast, motion.acceleration) - exact).cwiseAbs().maxCoeff(), bound) << "fft, block " << block;
      EXPECT_EQ(fast.instantaneous_mass(), motion.weights.weight(0));
    }
  }
}

TEST(Convolution, SameBitsForOneAndTwoThreadsAndFromRunToRun) {
  const Motion motion = noise(6, 400, 400);
  numerics::ThreadPool pool(2);
  DirectSum direct(motion.weights, 400, {.block = 16}), direct_2(motion.weights, 400, {.block = 16, .pool = &pool});
  EXPECT_EQ(run(direct, motion.acceleration), run(direct_2, motion.acceleration));
  BlockFft fast(motion.weights, 400), fast_2(motion.weights, 400, {.pool = &pool}), again(motion.weights, 400);
  const Eigen::MatrixXd forces = run(fast, motion.acceleration);
  EXPECT_EQ(forces, run(fast_2, motion.acceleration));
  EXPECT_EQ(forces, run(again, motion.acceleration));
}

TEST(Convolution, HistoryForceStaysTheSameUntilAppend) {
  const Motion motion = noise(3, 50, 50);
  BlockFft fast(motion.weights, 50, {.block = 4});
  run(fast, motion.acceleration.leftCols(21));
  Eigen::VectorXd first(3), second(3);
  fast.history_force(first);
  fast.history_force(second);
  EXPECT_EQ(first, second);
}

TEST(Convolution, RefusesWhatItCannotHold) {
  const Motion motion = noise(2, 5, 5);
  DirectSum direct(motion.weights, 5);
  BlockFft fast(motion.weights, 5);
  for (Convolution* c : {static_cast<Convolution*>(&direct), static_cast<Convolution*>(&fast)}) {
    run(*c, motion.acceleration);
    EXPECT_THROW(c->append(motion.acceleration.col(0)), std::length_error);
  }
  EXPECT_THROW(DirectSum(motion.weights, -1), std::invalid_argument);
  EXPECT_THROW(BlockFft(motion.weights, 5, {.block = 0}), std::invalid_argument);
  WeightSequence skew = motion.weights;
  skew.values(1, 3) += 1.0;
  EXPECT_THROW(DirectSum(skew, 5), std::invalid_argument);
  skew.values(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(BlockFft(skew, 5), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::convolution
