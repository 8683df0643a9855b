#include "solver/convolution/real_transform.hpp"

#include <fftw3.h>

#include <Eigen/Core>
#include <mutex>
#include <new>

namespace sunder::convolution {
namespace {

/// FFTW's planner is the one part of it that threads may not share.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct RealTransform::Plans {
  fftw_plan forward = nullptr, backward = nullptr;
  ~Plans() {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
};

RealTransform::RealTransform(int length) : plans_(std::make_unique<Plans>()), length_(length) {
  // FFTW wants the distance from real to imaginary parts to be that of the plan
  Eigen::VectorXd x(length), spectrum(2 * offset());
  double *real = spectrum.data(), *imaginary = real + offset();
  const fftw_iodim dimension{.n = length, .is = 1, .os = 1};
  const std::lock_guard lock(planner());
  plans_->forward = fftw_plan_guru_split_dft_r2c(1, &dimension, 0, nullptr, x.data(), real, imaginary,
                                                 FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  plans_->backward = fftw_plan_guru_split_dft_c2r(1, &dimension, 0, nullptr, real, imaginary, x.data(),
                                                  FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  if (plans_->forward == nullptr || plans_->backward == nullptr) throw std::bad_alloc();
}

RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;
RealTransform::~RealTransform() = default;

void RealTransform::forward(double* x, double* spectrum) const {
  fftw_execute_split_dft_r2c(plans_->forward, x, spectrum, spectrum + offset());
}

void RealTransform::backward(double* spectrum, double* x) const {
  fftw_execute_split_dft_c2r(plans_->backward, spectrum, spectrum + offset(), x);
}

}  // namespace sunder::convolution
