#include "solver/convolution/state_space.hpp"

#include <stdexcept>

namespace sunder::convolution {

StateSpace::StateSpace(const StateSpaceModel& model) : error_(model.error) {
  const Eigen::Index r = model.decay.size();
  const int n = model.size(), direct = model.direct_lags();
  if (n < 1 || direct < 0 || model.input.rows() != r || model.input.cols() != n || model.output.rows() != n ||
      model.output.cols() != r)
    throw std::invalid_argument("StateSpace: the shapes of decay, input, output and direct must agree");
  if (!model.input.allFinite() || !model.output.allFinite() || !model.direct.allFinite())
    throw std::invalid_argument("StateSpace: every number must be finite");
  for (const std::complex<double>& lambda : model.decay)
    if (!(std::abs(lambda) < 1.0)) throw std::invalid_argument("StateSpace: every |decay| must be < 1");
  mass_ = model.direct.leftCols(n);
  near_ = model.direct.rightCols(direct * n);
  fade_ = model.decay.real();
  turn_ = model.decay.imag();
  input_.resize(2 * r, n);
  input_ << model.input.real(), model.input.imag();
  output_.resize(n, 2 * r);
  output_ << model.output.real(), -model.output.imag();
  state_.setZero(2 * r);
  kick_.setZero(2 * r);
  recent_.setZero(direct * n);
}

void StateSpace::history_force(Eigen::Ref<Eigen::VectorXd> force) {
  force.noalias() = output_ * state_;
  if (recent_.size() > 0) force.noalias() += near_ * recent_;
}

void StateSpace::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  const Eigen::Index n = size(), kept = recent_.size();
  if (kept > 0) {
    kick_.noalias() = input_ * recent_.tail(n);
    for (Eigen::Index i = kept - 1; i >= n; --i) recent_[i] = recent_[i - n];
    recent_.head(n) = acceleration;
  } else {
    kick_.noalias() = input_ * acceleration;
  }
  const Eigen::Index r = fade_.size();
  for (Eigen::Index k = 0; k < r; ++k) {
    const double real = state_[k], imaginary = state_[r + k];
    state_[k] = fade_[k] * real - turn_[k] * imaginary + kick_[k];
    state_[r + k] = fade_[k] * imaginary + turn_[k] * real + kick_[r + k];
  }
}

double StateSpace::bytes() const {
  return 8.0 * static_cast<double>(mass_.size() + near_.size() + 2 * fade_.size() + input_.size() + output_.size() +
                                   state_.size() + kick_.size() + recent_.size());
}

}  // namespace sunder::convolution
