#include "solver/sbfem/particular.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::sbfem {

ParticularSolution particular_solution(const Coefficients& coefficients, const PolygonSolution& solution,
                                       const RadialLoad& load) {
  const double s = load.power + 1.0;
  ParticularSolution result{.power = load.power, .d = Eigen::VectorXd::Zero(load.density.size())};
  if (numerics::planted_fault("sbfem/particular-part-dropped")) return result;

  // Displacements in units of diag(E0)^-1/2, so that short and long edges weigh alike in the norm that is minimised.
  const Eigen::VectorXd scale = coefficients.E0.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd right = -coefficients.E0.llt().solve(load_vector(solution, load));
  Eigen::MatrixXd shifted = scale.cwiseInverse().asDiagonal() * (-solution.A) * scale.asDiagonal();
  shifted.diagonal().array() += s;

  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor;
  // Round-off leaves the pivots of a true exponent s at 1e-13 or below of the largest; the next pivots are about
  // ½ / λ_max of it, which is 1e-7 for a sliver of 1 : 1e6.
  factor.setThreshold(1e-10);
  factor.compute(shifted);
  const Eigen::VectorXd scaled = factor.solve(scale.cwiseInverse().cwiseProduct(right));
  result.d = scale.cwiseProduct(scaled);

  const Eigen::MatrixXd skew = coefficients.E1.transpose() - coefficients.E1;
  const Eigen::MatrixXd L =
      scale.asDiagonal() * (s * s * coefficients.E0 + s * skew - coefficients.E2) * scale.asDiagonal();
  const Eigen::VectorXd p = scale.cwiseProduct(load.density);
  const double reference = p.norm() + L.norm() * scaled.norm();
  if (reference > 0.0) result.residual = (L * scaled + p).norm() / reference;
  return result;
}

std::vector<ParticularSolution> particular_solutions(const Coefficients& coefficients, const PolygonSolution& solution,
                                                     std::span<const RadialLoad> loads) {
  std::vector<ParticularSolution> results;
  results.reserve(loads.size());
  for (const RadialLoad& load : loads) results.push_back(particular_solution(coefficients, solution, load));
  return results;
}

}  // namespace sunder::sbfem
