#include "solver/convolution/simple_convolutions.hpp"

#include <stdexcept>

namespace sunder::convolution {

InstantaneousMass::InstantaneousMass(Eigen::MatrixXd mass) : mass_(std::move(mass)) {
  if (mass_.rows() != mass_.cols() || !mass_.allFinite())
    throw std::invalid_argument("InstantaneousMass: the mass must be square and finite");
}

Transformed::Transformed(Eigen::MatrixXd transform, std::unique_ptr<Convolution> inner)
    : transform_(std::move(transform)), inner_(std::move(inner)) {
  if (inner_ == nullptr || transform_.rows() != inner_->size())
    throw std::invalid_argument("Transformed: the transform must have as many rows as the inner convolution has");
  mass_ = transform_.transpose() * inner_->instantaneous_mass() * transform_;
  mass_ = (0.5 * (mass_ + mass_.transpose())).eval();
  inside_.setZero(transform_.rows());
}

void Transformed::history_force(Eigen::Ref<Eigen::VectorXd> force) {
  inner_->history_force(inside_);
  force.noalias() = transform_.transpose() * inside_;
}

void Transformed::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  inside_.noalias() = transform_ * acceleration;
  inner_->append(inside_);
}

}  // namespace sunder::convolution
