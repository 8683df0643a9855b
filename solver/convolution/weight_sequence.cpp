#include "solver/convolution/weight_sequence.hpp"

#include <stdexcept>
#include <string>

namespace sunder::convolution {

Eigen::MatrixXd WeightSequence::weight(long long j) const {
  if (diagonal) return values.col(j).asDiagonal();
  return dense(j);
}

void check(const WeightSequence& weights) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("weights: " + what); };
  if (weights.size < 1) refuse("size " + std::to_string(weights.size) + " must be >= 1");
  const Eigen::Index rows = weights.diagonal ? weights.size : Eigen::Index{weights.size} * weights.size;
  if (weights.values.cols() < 1) refuse("there must be at least W_0");
  if (weights.values.rows() != rows)
    refuse(std::to_string(weights.values.rows()) + " numbers a step must be " + std::to_string(rows));
  if (!weights.values.allFinite()) refuse("every value must be finite");
  if (weights.diagonal) return;
  const double largest = weights.values.cwiseAbs().maxCoeff();
  for (long long j = 0; j <= weights.last(); ++j) {
    const auto W = weights.dense(j);
    for (int c = 0; c < weights.size; ++c)
      for (int r = c + 1; r < weights.size; ++r)
        if (!(std::abs(W(r, c) - W(c, r)) <= 1e-9 * largest))
          refuse("W_" + std::to_string(j) + " must be symmetric to 1e-9 of the largest entry");
  }
}

WeightSequence truncated(const WeightSequence& weights, long long last) {
  if (last < 0 || last > weights.last())
    throw std::invalid_argument("truncated: last = " + std::to_string(last) + " must be 0 … " +
                                std::to_string(weights.last()));
  return {weights.size, weights.diagonal, weights.values.leftCols(last + 1)};
}

}  // namespace sunder::convolution
