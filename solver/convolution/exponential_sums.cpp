#include "solver/convolution/exponential_sums.hpp"

#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::convolution {

using Eigen::Index;

DiagonalStateSpace::DiagonalStateSpace(const ExponentialSums& sums)
    : mass_(sums.mass.asDiagonal()),
      fade_(sums.decay.real()),
      turn_(sums.decay.imag()),
      weight_real_(sums.weight.real()),
      weight_imaginary_(sums.weight.imag()) {
  if (sums.mass.size() < 1 || sums.decay.cols() != sums.mass.size() || sums.weight.rows() != sums.decay.rows() ||
      sums.weight.cols() != sums.decay.cols())
    throw std::invalid_argument("DiagonalStateSpace: the shapes of mass, decay and weight must agree");
  if (!sums.mass.allFinite() || !sums.weight.allFinite())
    throw std::invalid_argument("DiagonalStateSpace: every number must be finite");
  if (sums.decay.size() > 0 && !(sums.decay.cwiseAbs().maxCoeff() < 1.0))
    throw std::invalid_argument("DiagonalStateSpace: every |decay| must be < 1");
  if (numerics::planted_fault("convolution/exponentials-without-phase")) weight_imaginary_.setZero();
  state_real_.setZero(fade_.rows(), fade_.cols());
  state_imaginary_.setZero(fade_.rows(), fade_.cols());
}

void DiagonalStateSpace::history_force(Eigen::Ref<Eigen::VectorXd> force) {
  for (Index d = 0; d < fade_.cols(); ++d) {
    force[d] = weight_real_.col(d).dot(state_real_.col(d)) - weight_imaginary_.col(d).dot(state_imaginary_.col(d));
  }
}

void DiagonalStateSpace::append(const Eigen::Ref<const Eigen::VectorXd>& acceleration) {
  const Index r = fade_.rows();
  for (Index d = 0; d < fade_.cols(); ++d) {
    const double kick = acceleration[d];
    const double *fade = fade_.col(d).data(), *turn = turn_.col(d).data();
    double *real = state_real_.col(d).data(), *imaginary = state_imaginary_.col(d).data();
    for (Index k = 0; k < r; ++k) {
      const double x = real[k], y = imaginary[k];
      real[k] = fade[k] * x - turn[k] * y + kick;
      imaginary[k] = fade[k] * y + turn[k] * x;
    }
  }
}

double DiagonalStateSpace::bytes() const {
  return 8.0 * static_cast<double>(mass_.size() + 6 * fade_.size());
}

}  // namespace sunder::convolution
