#include "solver/foundation/rock_weights.hpp"

#include "solver/convolution/contour_weights.hpp"

namespace sunder::foundation {
namespace {

using Complex = std::complex<double>;

/// The contour's points, from s ≈ 0 outwards: a quadrature of one unknown is asked for them.
std::vector<Complex> contour(double time_step, long long last, int oversampling) {
  std::vector<Complex> points;
  (void)convolution::contour_weights(1, time_step, last,
                                     [&points](const convolution::ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> mass) {
                                       points.push_back(at.s);
                                       mass.setZero();
                                     },
                                     {.oversampling = oversampling});
  return points;
}

}  // namespace

RockWeights rock_weights(const UnboundedDomain& domain, double time_step, long long last,
                         const RockWeightOptions& options) {
  std::vector<Complex> inwards = contour(time_step, last, options.oversampling);
  std::reverse(inwards.begin(), inwards.end());
  const Eigen::Index n = domain.size();
  // Lower triangles of M, one column a point, from s ≈ 0 outwards.
  Eigen::MatrixXcd triangles(n * (n + 1) / 2, std::ssize(inwards));
  RockWeights result;
  result.path = dynamic_stiffness(
      domain, inwards,
      [&](std::size_t i, const Eigen::MatrixXcd& S) {
        const Complex factor = 1.0 / (inwards[i] * inwards[i]);
        auto column = triangles.col(std::ssize(inwards) - 1 - static_cast<Eigen::Index>(i));
        for (Eigen::Index c = 0, entry = 0; c < n; ++c) {
          for (Eigen::Index r = c; r < n; ++r, ++entry) column[entry] = factor * S(r, c);
        }
      },
      options.stiffness);
  if (result.path.status != StiffnessStatus::converged) return result;
  result.weights =
      convolution::contour_weights(static_cast<int>(n), time_step, last,
                                   [&](const convolution::ContourPoint& at, Eigen::Ref<Eigen::MatrixXcd> mass) {
                                     for (Eigen::Index c = 0, entry = 0; c < n; ++c) {
                                       for (Eigen::Index r = c; r < n; ++r, ++entry)
                                         mass(r, c) = mass(c, r) = triangles(entry, at.point);
                                     }
                                   },
                                   {.oversampling = options.oversampling, .pool = options.pool});
  return result;
}

}  // namespace sunder::foundation
