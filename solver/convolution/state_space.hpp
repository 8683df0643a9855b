#pragma once
/// The convolution by a recurrence: a few states that fade and turn stand for all the past.
///
///     x_n = diag(λ) x_{n-1} + B a_n,    Σ_{j>=1} W_j a_{n-j} ≈ Σ_{j=1}^{d} W_j a_{n-j} + Re C x_{n-1-d}
///
/// so that W_j is replaced by Re C diag(λ)^(j-1-d) B for j > d: a sum of exponentials. Cost and memory of a step do not
/// depend on how many there were: 8 n r operations for r states. The error is known, not guessed: `certify` compares
/// every weight, and whatever the accelerations,
///
///     |R - R~|_2 <= error.absolute · max_m |a_m|_2        as long as the run has no more steps than the weights.

#include <Eigen/Core>

#include "solver/convolution/convolution.hpp"
#include "solver/convolution/weight_sequence.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::convolution {

/// Bounds of Σ_j ‖W_j - W~_j‖_2, summed over all lags, those after the last weight included (W_j = 0 there).
struct KernelError {
  double absolute = 0.0;  ///< [kg/m]
  double relative = 0.0;  ///< of Σ_j ‖W_j‖_F
};

/// A pair of conjugate exponentials is one state.
struct StateSpaceModel {
  Eigen::VectorXcd decay;        ///< λ (r), |λ| < 1
  Eigen::MatrixXcd input;        ///< B (r, n)
  Eigen::MatrixXcd output;       ///< C (n, r) [kg/m]
  Eigen::MatrixXd direct;        ///< (n, n (d + 1)) W_0 … W_d side by side
  KernelError error;             ///< as `certify` says
  long long certified_lags = 0;  ///< N of the weights it was made from
  bool within_tolerance = false;

  int size() const { return static_cast<int>(direct.rows()); }
  int direct_lags() const { return static_cast<int>(direct.cols() / direct.rows()) - 1; }
};

struct ReductionOptions {
  double tolerance = 1e-5;  ///< of KernelError::relative, > 0
  int direct_lags = 0;      ///< d, 0 … 64
  int most_states = 400;    ///< bound of r before conjugates are paired
  numerics::ThreadPool* pool = nullptr;
};

/// The best model that `most_states` allow, by balanced truncation: the block Hankel matrix H_ij = W_{d+1+i+j} is
/// symmetric; its dominant eigenvectors Q V (found with a random start of fixed seed [Halko, Martinsson & Tropp 2011],
/// products by fast Fourier transforms) give the observability matrix O = Q V |Λ|^½, A = O⁺ O shifted by one block
/// [Kung 1978], which is then diagonalised. Where the tolerance is not met `within_tolerance` is false and the error is
/// stated all the same. For dense or diagonal weights. Throws std::invalid_argument as `check(weights)`, or where an
/// option is out of range or there are no lags after the direct ones.
[[nodiscard]] StateSpaceModel reduce(const WeightSequence& weights, const ReductionOptions& options = {});

/// The error of a model against weights, weight by weight; beyond the last by a geometric sum. O(N r n²).
[[nodiscard]] KernelError certify(const StateSpaceModel& model, const WeightSequence& weights,
                                  numerics::ThreadPool* pool = nullptr);

/// Any number of steps in the memory of the model.
class StateSpace final : public Convolution {
 public:
  /// Throws std::invalid_argument where shapes disagree, a number is not finite or some |λ| >= 1.
  explicit StateSpace(const StateSpaceModel& model);

  int size() const override { return static_cast<int>(mass_.rows()); }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override;
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

  const KernelError& error() const { return error_; }
  double bytes() const;  ///< held

 private:
  Eigen::MatrixXd mass_, near_;     // W_0; W_1 … W_d side by side
  Eigen::VectorXd turn_, fade_;     // λ = fade + i turn (r)
  Eigen::MatrixXd input_, output_;  // (2 r, n), (n, 2 r): real parts, imaginary parts
  Eigen::VectorXd state_, kick_;    // (2 r)
  Eigen::VectorXd recent_;          // (n d) newest first, d >= 1
  KernelError error_;
};

}  // namespace sunder::convolution
