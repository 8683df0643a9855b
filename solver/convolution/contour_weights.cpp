#include "solver/convolution/contour_weights.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/convolution/real_transform.hpp"
#include "solver/numerics/planted_fault.hpp"

namespace sunder::convolution {
namespace {

constexpr int group = 8;  ///< numbers that fill a line of the cache: matrices are turned over this many at a time

template <class Work>
void share(numerics::ThreadPool* pool, int count, const Work& work) {
  if (pool != nullptr) return pool->parallel_for(count, work);
  for (int i = 0; i < count; ++i) work(i);
}

void check_arguments(int size, double time_step, long long last, const ContourOptions& options) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("contour_weights: " + what); };
  if (size < 1) refuse("size = " + std::to_string(size) + " must be >= 1");
  if (!(time_step > 0.0) || !std::isfinite(time_step))
    refuse("time_step = " + std::to_string(time_step) + " must be finite and > 0");
  if (last < 0 || last > (1LL << 26)) refuse("last = " + std::to_string(last) + " must be 0 … 2^26");
  if (options.oversampling < 1 || options.oversampling > 64)
    refuse("oversampling = " + std::to_string(options.oversampling) + " must be 1 … 64");
}

/// s on the circle: s(ζ) with ζ = r e^{-iφ}, so that the transform's sign makes coefficients of powers. In the variable
/// of half angles, which loses nothing where ζ is close to 1 or -1.
std::complex<double> s_of(double minus_log_radius, double angle, double time_step) {
  const std::complex<double> half(0.5 * minus_log_radius, 0.5 * angle);
  if (numerics::planted_fault("convolution/backward-difference")) return (1.0 - std::exp(-2.0 * half)) / time_step;
  return 2.0 / time_step * std::tanh(half);
}

}  // namespace

WeightSequence contour_weights(int size, double time_step, long long last, const LaplaceMass& mass,
                               const ContourOptions& options) {
  check_arguments(size, time_step, last, options);
  const auto wanted = static_cast<unsigned long long>(options.oversampling * (last + 1));
  const int length = static_cast<int>(std::max<unsigned long long>(std::bit_ceil(wanted), 16));
  const RealTransform transform(length);
  const double minus_log_radius =
      -std::log(std::numeric_limits<double>::epsilon()) / (static_cast<double>(length) + static_cast<double>(last));

  const int points = transform.frequencies(), entries = size * (size + 1) / 2;
  Eigen::MatrixXd spectra(2 * transform.offset(), entries);
  std::vector<char> finite(contour_runs, 1);
  share(options.pool, contour_runs, [&](int run) {
    Eigen::MatrixXcd M = Eigen::MatrixXcd::Zero(size, size);
    Eigen::Matrix<double, group, Eigen::Dynamic> real(group, entries), imaginary(group, entries);
    const int begin = static_cast<int>(static_cast<long long>(points) * run / contour_runs);
    const int end = static_cast<int>(static_cast<long long>(points) * (run + 1) / contour_runs);
    for (int first = begin; first < end; first += group) {
      const int count = std::min(group, end - first);
      for (int i = 0; i < count; ++i) {
        const int k = first + i;
        mass({s_of(minus_log_radius, 2.0 * std::numbers::pi * k / length, time_step), k, run, k == begin}, M);
        int entry = 0;
        for (int c = 0; c < size; ++c)
          for (int r = c; r < size; ++r, ++entry) {
            real(i, entry) = M(r, c).real();
            imaginary(i, entry) = M(r, c).imag();
          }
      }
      spectra.block(first, 0, count, entries) = real.topRows(count);
      spectra.block(transform.offset() + first, 0, count, entries) = imaginary.topRows(count);
      if (!real.topRows(count).allFinite() || !imaginary.topRows(count).allFinite())
        finite[static_cast<std::size_t>(run)] = 0;
    }
  });
  if (std::find(finite.begin(), finite.end(), 0) != finite.end())
    throw std::invalid_argument("contour_weights: M(s) must be finite on the whole contour");

  WeightSequence weights{size, false, Eigen::MatrixXd(Eigen::Index{size} * size, last + 1)};
  Eigen::VectorXd unscale(last + 1);
  for (long long j = 0; j <= last; ++j) unscale[j] = std::exp(minus_log_radius * static_cast<double>(j)) / length;
  share(options.pool, size, [&](int c) {
    // `group` rows of a column at a time: they lie side by side in each weight
    Eigen::MatrixXd series(length, group);
    for (int first = c; first < size; first += group) {
      const int count = std::min(group, size - first);
      for (int i = 0; i < count; ++i)
        transform.backward(spectra.col(c * size - c * (c - 1) / 2 + first + i - c).data(), series.col(i).data());
      for (long long j = 0; j <= last; ++j)
        weights.values.col(j).segment(c * size + first, count) = unscale[j] * series.row(j).head(count).transpose();
    }
  });
  // the upper triangles, weight by weight
  share(options.pool, static_cast<int>(std::min<long long>(last + 1, size)), [&](int part) {
    for (long long j = part; j <= last; j += size) {
      Eigen::Map<Eigen::MatrixXd> W(weights.values.col(j).data(), size, size);
      for (int c = 1; c < size; ++c)
        for (int r = 0; r < c; ++r) W(r, c) = W(c, r);
    }
  });
  return weights;
}

Eigen::MatrixXd hat_weights(const Eigen::MatrixXd& twice, double time_step) {
  if (twice.cols() < 2 || !(time_step > 0.0))
    throw std::invalid_argument("hat_weights: at least two samples and a time_step > 0 are needed");
  const Eigen::Index count = twice.cols() - 1;
  Eigen::MatrixXd weights(twice.rows(), count);
  weights.col(0) = twice.col(1) / time_step;
  for (Eigen::Index j = 1; j < count; ++j)
    weights.col(j) = (twice.col(j + 1) - 2.0 * twice.col(j) + twice.col(j - 1)) / time_step;
  return weights;
}

}  // namespace sunder::convolution
