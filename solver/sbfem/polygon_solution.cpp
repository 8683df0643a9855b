#include "solver/sbfem/polygon_solution.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/matrix_sign.hpp"
#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/reduced_polygon.hpp"
#include "solver/sbfem/ring_doubling.hpp"

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;

RiccatiSolution riccati(const ReducedPolygon& polygon, Route route) {
  switch (route) {
    case Route::ring_doubling: {
      RiccatiSolution solution = ring_doubling(polygon.E0, polygon.F, polygon.E2);
      // An edge of 1e-9 of the polygon can make the rings indefinite by round-off; the sign function bears two digits
      // more.
      if (!solution.positive_definite) solution = matrix_sign(polygon.E0, polygon.F, polygon.E2);
      return solution;
    }
    case Route::matrix_sign:
      return matrix_sign(polygon.E0, polygon.F, polygon.E2);
    case Route::ordered_schur:
      return schur_stiffness(polygon);
  }
  return {};
}

/// Σ over both components of 1ᵀ M 1: the trace of Tᵀ M T.
double translation_moment(const MatrixXd& M) {
  double sum = 0.0;
  for (Eigen::Index j = 0; j < M.cols(); ++j) {
    for (Eigen::Index i = j % 2; i < M.rows(); i += 2) sum += M(i, j);
  }
  return sum;
}

PolygonSolution failed(const Coefficients& coefficients, PolygonStatus status) {
  PolygonSolution solution;
  const auto N = coefficients.E0.rows();
  solution.K = solution.A = MatrixXd::Constant(N, N, std::numeric_limits<double>::quiet_NaN());
  solution.asymmetry = std::numeric_limits<double>::quiet_NaN();
  solution.status = status;
  return solution;
}

/// A = E0⁻¹ (K - E1ᵀ), solved in the scaled variables, where E0 has a unit diagonal. False where E0 is not definite.
bool close_loop(const Coefficients& coefficients, PolygonSolution& solution) {
  const Eigen::VectorXd scale = coefficients.E0.diagonal().cwiseSqrt().cwiseInverse();
  const auto P = scale.asDiagonal();
  const Eigen::LLT<MatrixXd> E0(P * coefficients.E0 * P);
  if (E0.info() != Eigen::Success) return false;
  solution.A = P * (solution.K - coefficients.E1.transpose()) * P;
  E0.solveInPlace(solution.A);
  solution.A = P * solution.A * scale.cwiseInverse().asDiagonal();
  return true;
}

}  // namespace

PolygonSolution solve_polygon(const Coefficients& coefficients, Route route) {
  const ReducedPolygon polygon = reduce(coefficients);
  if (!polygon.valid) return failed(coefficients, PolygonStatus::not_positive_definite);
  const RiccatiSolution riccati_solution = riccati(polygon, route);
  if (!riccati_solution.positive_definite || !riccati_solution.K.allFinite()) {
    return failed(coefficients, PolygonStatus::not_positive_definite);
  }
  PolygonSolution solution;
  solution.K = expand_stiffness(polygon, riccati_solution.K);
  // Where round-off outweighs the stiffness (a centre at 1e-15 of an edge), the diagonal is one that no solid has.
  if (!(solution.K.diagonal().minCoeff() > 0.0)) return failed(coefficients, PolygonStatus::not_positive_definite);
  solution.asymmetry = riccati_solution.asymmetry;
  solution.iterations = riccati_solution.iterations;
  solution.status = riccati_solution.converged ? PolygonStatus::converged : PolygonStatus::not_converged;
  if (!close_loop(coefficients, solution)) return failed(coefficients, PolygonStatus::not_positive_definite);
  return solution;
}

PolygonSolution solution_of_stiffness(const Coefficients& coefficients, const Eigen::Ref<const MatrixXd>& K) {
  PolygonSolution solution;
  solution.K = K;
  if (!K.allFinite() || !close_loop(coefficients, solution)) {
    return failed(coefficients, PolygonStatus::not_positive_definite);
  }
  return solution;
}

MatrixXd mass(const Coefficients& coefficients, const PolygonSolution& solution) {
  const auto N = coefficients.E0.rows();
  if (coefficients.M0.size() == 0) return MatrixXd::Zero(N, N);
  if (numerics::planted_fault("sbfem/mass-without-closed-loop")) return 0.5 * coefficients.M0;
  // In scaled variables, where I + A has no artificial spread: M - Uᵀ M U = 2γ Rᵀ M0 R with R = (I + A + γ)⁻¹ and
  // U = I - 2γ R; each squaring of U doubles the number of terms of M = Σ U^kᵀ W U^k [Smith 1968].
  const Eigen::VectorXd scale = coefficients.E0.diagonal().cwiseSqrt().cwiseInverse(), stretch = scale.cwiseInverse();
  const MatrixXd A = stretch.asDiagonal() * solution.A * scale.asDiagonal();
  const MatrixXd M0 = scale.asDiagonal() * coefficients.M0 * scale.asDiagonal();
  // The eigenvalues of I + A lie between 1 and 1 + λ_max ≤ 1 + ‖A‖; the trace of A² bounds it far closer.
  const double largest = std::sqrt(std::max(1.0, (A * A).trace()));
  const double gamma = std::sqrt(1.0 + largest);
  const MatrixXd R = (A + (1.0 + gamma) * MatrixXd::Identity(N, N)).partialPivLu().inverse();
  MatrixXd U = MatrixXd::Identity(N, N) - 2.0 * gamma * R;
  MatrixXd M = 2.0 * gamma * R.transpose() * M0 * R;
  constexpr int most_squarings = 60;
  for (int squaring = 0; squaring < most_squarings; ++squaring) {
    const MatrixXd increment = U.transpose() * M * U;
    M += increment;
    if (!(increment.norm() > 0.1 * std::numeric_limits<double>::epsilon() * M.norm())) break;
    U = (U * U).eval();
  }
  M = (stretch.asDiagonal() * M * stretch.asDiagonal()).eval();
  M = (0.5 * (M + M.transpose())).eval();
  // A T = 0 for the translations T, hence 2 Tᵀ M T = Tᵀ M0 T: half a moment of mass that is wrong by 1e-6 has lost all
  // else.
  const double carried = 2.0 * translation_moment(M), expected = translation_moment(coefficients.M0);
  if (!(std::abs(carried - expected) <= 1e-6 * expected)) M.setConstant(std::numeric_limits<double>::quiet_NaN());
  return M;
}

}  // namespace sunder::sbfem
