#pragma once
/// Convolutions that add nothing of their own: a mass without memory, and a change of the degrees of freedom.

#include <memory>

#include "solver/convolution/convolution.hpp"

namespace sunder::convolution {

/// R_n = W_0 a_n: no history, nothing stored.
class InstantaneousMass final : public Convolution {
 public:
  /// `mass` (n, n) [kg/m], symmetric. Throws std::invalid_argument where it is not square or not finite.
  explicit InstantaneousMass(Eigen::MatrixXd mass);

  int size() const override { return static_cast<int>(mass_.rows()); }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override { force.setZero(); }
  void append(const Eigen::Ref<const Eigen::VectorXd>& /*acceleration*/) override {}

 private:
  Eigen::MatrixXd mass_;
};

/// R = Gᵀ r with r the forces that `inner` answers to G a.
class Transformed final : public Convolution {
 public:
  /// `transform` G (m, n), m = inner->size(). Throws std::invalid_argument where shapes disagree.
  Transformed(Eigen::MatrixXd transform, std::unique_ptr<Convolution> inner);

  int size() const override { return static_cast<int>(transform_.cols()); }
  const Eigen::MatrixXd& instantaneous_mass() const override { return mass_; }
  void history_force(Eigen::Ref<Eigen::VectorXd> force) override;
  void append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) override;

 private:
  Eigen::MatrixXd transform_, mass_;
  std::unique_ptr<Convolution> inner_;
  Eigen::VectorXd inside_;
};

}  // namespace sunder::convolution
