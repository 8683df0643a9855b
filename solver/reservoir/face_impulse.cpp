#include "solver/reservoir/face_impulse.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/convolution/contour_weights.hpp"
#include "solver/reservoir/rank_one_root.hpp"

namespace sunder::reservoir {
namespace {

using Complex = std::complex<double>;

/// m at the times, by weights of steps of t_max/steps; cubic between the samples.
std::vector<double> sampled(const FaceModes& modes, const Eigen::VectorXd& g, const std::vector<double>& times,
                            double end, int steps) {
  const double dt = end / steps, c = modes.water.sound_speed, damping = bottom_damping(modes.water);
  std::vector<RankOneRoot> roots(convolution::contour_runs, RankOneRoot(modes.wavenumber_squared, modes.bottom));
  const convolution::WeightSequence weights = convolution::contour_weights(
      1, dt, steps + 2, [&](const convolution::ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> M) {
        RankOneRoot& root = roots[static_cast<std::size_t>(at.run)];
        const Complex S = at.s / c;
        root.decompose(S * damping, at.first);
        const Eigen::VectorXcd along = root.vectors().transpose() * g.cast<Complex>();
        M(0, 0) = 0.0;
        for (Eigen::Index j = 0; j < along.size(); ++j)
          M(0, 0) += along[j] * along[j] * modes.water.density / std::sqrt(S * S + root.values()[j]);
      });
  const auto sample = [&](long long j) {
    return j == 0 ? modes.water.density * c * g.squaredNorm() : weights.values(0, j) / dt;
  };
  std::vector<double> result;
  for (const double t : times) {
    const long long j = std::clamp<long long>(static_cast<long long>(std::floor(t / dt)), 1, steps);
    const double x = t / dt - static_cast<double>(j);  // -1 … 1, between samples j - 1 … j + 2
    result.push_back(-x * (x - 1.0) * (x - 2.0) / 6.0 * sample(j - 1) +
                     (x + 1.0) * (x - 1.0) * (x - 2.0) / 2.0 * sample(j) -
                     (x + 1.0) * x * (x - 2.0) / 2.0 * sample(j + 1) + (x + 1.0) * x * (x - 1.0) / 6.0 * sample(j + 2));
  }
  return result;
}

}  // namespace

std::vector<double> face_impulse(const FaceModes& modes, const std::vector<double>& times) {
  double end = 0.0;
  for (const double t : times) {
    if (!(t >= 0.0) || !std::isfinite(t))
      throw std::invalid_argument("face_impulse: a time of " + std::to_string(t) + " s must be finite and >= 0");
    end = std::fmax(end, t);
  }
  const Eigen::VectorXd g = modes.load.rowwise().sum();
  const double front = modes.water.density * modes.water.sound_speed;
  if (end == 0.0) return std::vector<double>(times.size(), front * g.squaredNorm());
  if (modes.water.reflection_coefficient == 1.0) {
    std::vector<double> result;
    for (const double t : times) {
      double sum = 0.0;
      for (Eigen::Index k = 0; k < g.size(); ++k)
        sum += g[k] * g[k] * ::j0(std::sqrt(modes.wavenumber_squared[k]) * modes.water.sound_speed * t);
      result.push_back(front * sum);
    }
    return result;
  }
  constexpr int steps = 8192;
  std::vector<double> coarse = sampled(modes, g, times, end, steps), fine = sampled(modes, g, times, end, 2 * steps);
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] += (fine[i] - coarse[i]) / 3.0;
  return fine;
}

}  // namespace sunder::reservoir
