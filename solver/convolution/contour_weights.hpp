#pragma once
/// Weights of a convolution from its Laplace transform, by trapezoidal convolution quadrature.
///
///     Σ_j W_j ζ^j = M(s(ζ)),    s = 2 (1 - ζ) / (Δt (1 + ζ))          [Lubich 1988]
///
/// The map is that of Newmark's average acceleration, so a medium that takes energy out in continuous time, Re(s M(s))
/// >= 0 where Re s > 0, takes energy out in discrete time as well, whatever the step. Weights that merely sample or
/// interpolate M(t) do not have this, and feed energy in (see `hat_weights`).
///
/// The coefficients of the power series come from values on the circle |ζ| = r by one fast Fourier transform of length
/// F >= m (N + 1). Two errors meet: what aliases is r^F W_{j+F} + …, the rounding is ε max|M| r^-j. With r^(F+N) = ε
/// both are at most ε^(F/(F+N)), about 4e-11 for m = 2, of the largest weight.

#include <complex>
#include <functional>

#include "solver/convolution/weight_sequence.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace sunder::convolution {

/// Fills the lower triangle of `mass` (n, n), complex symmetric, with M(s) [kg/m]; Re s > 0. M(conj s) = conj M(s).
/// Called from several threads at once where there is a pool. `point` counts the contour's points from s ≈ 0 on, so
/// that a caller may carry something from one to the next of the same `run` of points; `first` in each run.
struct ContourPoint {
  std::complex<double> s;  ///< [1/s]
  int point, run;
  bool first;
};
using LaplaceMass = std::function<void(const ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> mass)>;

struct ContourOptions {
  int oversampling = 2;                  ///< m, 1 … 64
  numerics::ThreadPool* pool = nullptr;  ///< the bits are the same for any number of threads
};

/// Number of runs into which the contour is cut, whatever the number of threads.
inline constexpr int contour_runs = 8;

/// W_0 … W_last for a step of `time_step` [s]. Memory: 8 n (n + 1) F/2 bytes beside the weights. Throws
/// std::invalid_argument where size < 1, time_step is not finite and > 0, last is outside 0 … 2^26, an option is out of
/// range, or M is not finite somewhere on the contour.
[[nodiscard]] WeightSequence contour_weights(int size, double time_step, long long last, const LaplaceMass& mass,
                                             const ContourOptions& options = {});

/// For comparison: W_j of piecewise linear accelerations, (P_{j+1} - 2 P_j + P_{j-1})/Δt with W_0 = P_1/Δt, from
/// `twice` (entries, N + 2), the double time integral P of M at 0, Δt, 2Δt, … [kg s²/m]. Second-order accurate, but Im
/// W < 0 where the exact medium radiates nothing: without other damping the energy grows.
[[nodiscard]] Eigen::MatrixXd hat_weights(const Eigen::MatrixXd& twice, double time_step);

}  // namespace sunder::convolution
