#pragma once
/// Fast Fourier transforms of real sequences with FFTW. Private to this module.
///
/// A spectrum is one array: `frequencies()` real parts, from `offset()` on as many imaginary parts.
///
/// Plans are estimated, never measured: a measured plan depends on the machine's mood, and its rounding with it.

#include <memory>

namespace sunder::convolution {

/// One length; transforms any arrays that are aligned as Eigen aligns its own.
class RealTransform {
 public:
  explicit RealTransform(int length);
  RealTransform(RealTransform&&) noexcept;
  RealTransform& operator=(RealTransform&&) noexcept;
  ~RealTransform();

  int length() const { return length_; }
  int frequencies() const { return length_ / 2 + 1; }

  /// Of the imaginary parts behind the real ones: frequencies() rounded up to whole chunks of 32. A spectrum has twice
  /// as many numbers.
  int offset() const { return (frequencies() + 31) / 32 * 32; }

  /// X_k = Σ x_j exp(-2πi jk/length), k = 0 … length/2. Keeps x.
  void forward(double* x, double* spectrum) const;
  /// x_j = Σ_k X_k exp(2πi jk/length) over all k, X_{length-k} = conj X_k. Spoils the spectrum.
  void backward(double* spectrum, double* x) const;

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
  int length_;
};

}  // namespace sunder::convolution
