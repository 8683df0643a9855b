#include "solver/numerics/natural_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

namespace sunder::numerics {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::VectorXd;

// The two operator types whose shape Spectra prescribes.
class Inverse {
 public:
  using Scalar = double;
  Inverse(Index rows, const Operator& solve, int& applications)
      : rows_(rows), solve_(&solve), applications_(&applications) {}
  Index rows() const { return rows_; }
  Index cols() const { return rows_; }
  void set_shift(const Scalar& /*shift*/) {}  // `solve` already holds the shifted matrix
  void perform_op(const double* x, double* y) const {
    ++*applications_;
    Map<VectorXd> result(y, rows_);
    (*solve_)(Map<const VectorXd>(x, rows_), result);
  }

 private:
  Index rows_;
  const Operator* solve_;
  int* applications_;
};

class Mass {
 public:
  using Scalar = double;
  Mass(Index rows, const Operator& apply) : rows_(rows), apply_(&apply) {}
  Index rows() const { return rows_; }
  Index cols() const { return rows_; }
  void perform_op(const double* x, double* y) const {
    Map<VectorXd> result(y, rows_);
    (*apply_)(Map<const VectorXd>(x, rows_), result);
  }

 private:
  Index rows_;
  const Operator* apply_;
};

/// All at once for a few unknowns, where a Krylov space would exhaust itself: with (K + s M)⁻¹ = L Lᵀ,
/// Lᵀ M L y = ν y, φ = L y / √ν, λ = 1/ν - s.
void solve_densely(NaturalModes& modes, int n, int count, double shift, const Operator& solve,
                   const Operator& apply_mass) {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd flexibility(n, n), mass_times_root(n, n);
  for (Index i = 0; i < n; ++i) solve(identity.col(i), flexibility.col(i));
  modes.iterations = n;
  const Eigen::LLT<Eigen::MatrixXd> factor(flexibility);
  if (factor.info() != Eigen::Success) {
    modes.status = ModesStatus::not_converged;
    return;
  }
  const Eigen::MatrixXd root = factor.matrixL();
  for (Index i = 0; i < n; ++i) apply_mass(root.col(i), mass_times_root.col(i));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(root.transpose() * mass_times_root);
  const VectorXd nu = eigen.eigenvalues().tail(count).reverse();
  if (!(nu.minCoeff() > 0.0)) {  // fewer modes than asked for: the mass has too little rank
    modes.status = ModesStatus::not_converged;
    return;
  }
  modes.eigenvalues = nu.cwiseInverse().array() - shift;
  modes.shapes =
      root * eigen.eigenvectors().rightCols(count).rowwise().reverse() * nu.cwiseSqrt().cwiseInverse().asDiagonal();
}

void iterate(NaturalModes& modes, int n, int count, double shift, const Operator& solve, const Operator& apply_mass) {
  // Twice the modes and a few: restarts become rare and the cost stays in the back-substitutions.
  const int basis = std::min(n, std::max(2 * count + 8, 24));
  constexpr int restarts = 300;
  constexpr double tolerance = 1e-12;  // of the Ritz values 1 / (λ + shift)
  Inverse inverse(n, solve, modes.iterations);
  Mass mass(n, apply_mass);
  Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(inverse, mass, count, basis,
                                                                                      -shift);
  try {
    solver.init();  // a fixed start vector: the same modes every time
    solver.compute(Spectra::SortRule::LargestMagn, restarts, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const std::exception&) {  // Spectra throws where its small eigenproblem breaks down
    modes.status = ModesStatus::not_converged;
    return;
  }
  modes.eigenvalues = solver.eigenvalues();
  modes.shapes = solver.eigenvectors();
  if (solver.info() != Spectra::CompInfo::Successful) modes.status = ModesStatus::not_converged;
}

double largest_residual(const NaturalModes& modes, double shift, const Operator& solve, const Operator& apply_mass) {
  VectorXd inertia(modes.shapes.rows()), back(modes.shapes.rows());
  double largest = 0.0;
  for (Index i = 0; i < modes.shapes.cols(); ++i) {
    apply_mass(modes.shapes.col(i), inertia);
    solve(inertia, back);
    const double residual = (modes.shapes.col(i) - (modes.eigenvalues[i] + shift) * back).norm();
    largest = std::max(largest, residual / modes.shapes.col(i).norm());
  }
  return largest;
}

}  // namespace

NaturalModes lowest_modes(int n, int count, double shift, const Operator& solve, const Operator& apply_mass) {
  if (count < 1 || count >= n) throw std::invalid_argument("lowest_modes: count must lie in 1 … n - 1");
  constexpr int few = 150;  // n³ of a dense solution is then below a millisecond
  NaturalModes modes;
  if (n <= few) {
    solve_densely(modes, n, count, shift, solve, apply_mass);
  } else {
    iterate(modes, n, count, shift, solve, apply_mass);
  }
  for (Index i = 0; i < modes.shapes.cols(); ++i) {  // a sign that does not depend on the start vector
    Index largest = 0;
    modes.shapes.col(i).cwiseAbs().maxCoeff(&largest);
    if (modes.shapes(largest, i) < 0.0) modes.shapes.col(i) *= -1.0;
  }
  modes.residual = largest_residual(modes, shift, solve, apply_mass);
  return modes;
}

}  // namespace sunder::numerics
