#include "solver/simulation/free_vibration.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "solver/numerics/symmetric_factor.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;
using Eigen::Lower;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr Index inertia_counted_up_to = 20'000;  // dofs: the LDLᵀ factorisation for it costs a second there

/// The constrained matrices, the bubbles condensed into K + shift M.
struct ShiftedBody {
  Sparse mass;      // constrained, lower
  Sparse coupling;  // rows of prescribed dofs empty
  VectorXd omega_squared;
  Sparse shifted;  // K + s M - s² C (Ω² + s)⁻¹ Cᵀ, lower
  double shift = 0.0;

  Index boundary() const { return mass.rows(); }
  Index bubbles() const { return omega_squared.size(); }
};

Sparse without_rows(const Sparse& matrix, const Constraints& constraints) {
  Sparse kept = matrix;
  kept.prune([&](Index row, Index, double) { return !constraints.fixed[row]; });
  return kept;
}

Sparse condensed(const Sparse& stiffness, const ShiftedBody& body, double shift) {
  if (shift == 0.0) return stiffness;
  Sparse matrix = stiffness + shift * body.mass;
  if (body.bubbles() > 0) {
    const VectorXd weight = shift * shift * (body.omega_squared.array() + shift).inverse();
    const Sparse correction = body.coupling * weight.asDiagonal() * Sparse(body.coupling.transpose());
    matrix -= Sparse(correction.triangularView<Lower>());
  }
  matrix.makeCompressed();
  return matrix;
}

/// y = (K + s M)⁻¹ x on boundary dofs and bubbles together.
void solve_shifted(const ShiftedBody& body, const numerics::SymmetricFactor& factor, Eigen::Ref<const VectorXd> x,
                   Eigen::Ref<VectorXd> y) {
  const Index n = body.boundary(), b = body.bubbles();
  y = x;
  if (b == 0) {
    factor.solve_in_place(y);
    return;
  }
  const VectorXd flexibility = (body.omega_squared.array() + body.shift).inverse();
  if (body.shift != 0.0) y.head(n) -= body.shift * (body.coupling * flexibility.cwiseProduct(x.tail(b)));
  factor.solve_in_place(y.head(n));
  if (body.shift != 0.0) y.tail(b) -= body.shift * (body.coupling.transpose() * y.head(n));
  y.tail(b).array() *= flexibility.array();
}

void apply_mass(const ShiftedBody& body, Eigen::Ref<const VectorXd> x, Eigen::Ref<VectorXd> y) {
  const Index n = body.boundary(), b = body.bubbles();
  y.head(n).noalias() = body.mass.selfadjointView<Lower>() * x.head(n);
  if (b == 0) return;
  y.head(n).noalias() += body.coupling * x.tail(b);
  y.tail(b) = x.tail(b);
  y.tail(b).noalias() += body.coupling.transpose() * x.head(n);
}

/// How many eigenvalues lie below σ = -shift of `below`: negative pivots of K - σM (Sylvester). Bubbles that lie below
/// σ count for themselves, the condensed matrix for the rest.
Index modes_below(const Sparse& shifted, const ShiftedBody& body, double sigma) {
  const Eigen::SimplicialLDLT<Sparse, Lower> factor(shifted);
  return (factor.vectorD().array() < 0.0).count() + (body.omega_squared.array() < sigma).count();
}

/// Effective modal mass of a ground motion in x and y over the total mass.
Eigen::Matrix2Xd participation(const VibratingBody& body, const Eigen::MatrixXd& shapes) {
  const Index dofs = body.mass.rows(), count = shapes.cols();
  Eigen::Matrix2Xd shares(2, count);
  for (int component = 0; component < 2; ++component) {
    VectorXd ground = VectorXd::Zero(dofs);
    for (Index dof = component; dof < dofs; dof += 2) ground[dof] = 1.0;
    const VectorXd inertia = body.mass.selfadjointView<Lower>() * ground;
    const double total = ground.dot(inertia);
    VectorXd factors = shapes.topRows(dofs).transpose() * inertia;
    if (body.bubble_omega_squared.size() > 0) {
      factors += shapes.bottomRows(shapes.rows() - dofs).transpose() * (body.bubble_coupling.transpose() * ground);
    }
    shares.row(component) = factors.cwiseAbs2().transpose() / total;
  }
  return shares;
}

/// A frequency scale of the body from its diagonals [rad²/s²]: far below the first elastic mode, far above round-off.
double small_shift(const Sparse& stiffness, const Sparse& mass) {
  double lowest = INFINITY;
  for (Index i = 0; i < mass.rows(); ++i) {
    const double inertia = mass.coeff(i, i);
    if (inertia > 0.0) lowest = std::min(lowest, stiffness.coeff(i, i) / inertia);
  }
  // The ratio is that of one polygon, about (c/h)²; a body of N polygons across has modes down to (c/h)²/N².
  return lowest / static_cast<double>(mass.rows());
}

}  // namespace

FreeVibration free_vibration(const VibratingBody& body, const Constraints& constraints, int count, bool floating) {
  FreeVibration vibration;
  Sparse stiffness = body.stiffness;
  ShiftedBody shifted{.mass = body.mass,
                      .coupling = without_rows(body.bubble_coupling, constraints),
                      .omega_squared = body.bubble_omega_squared,
                      .shifted = {}};
  VectorXd no_force = VectorXd::Zero(stiffness.rows());
  Constraints at_rest = constraints;
  at_rest.displacement.setZero();
  eliminate(at_rest, stiffness.diagonal().cwiseAbs().mean(), stiffness, no_force);
  remove_inertia(at_rest, shifted.mass);
  shifted.shift = floating ? small_shift(body.stiffness, body.mass) : 0.0;
  shifted.shifted = condensed(stiffness, shifted, shifted.shift);

  const numerics::SymmetricFactor factor(shifted.shifted, {.block = 2});
  vibration.factor_entries = factor.entries();
  if (factor.status() != numerics::FactorStatus::factorised) {
    vibration.status = VibrationStatus::not_positive_definite;
    return vibration;
  }
  const numerics::NaturalModes modes = numerics::lowest_modes(
      static_cast<int>(shifted.boundary() + shifted.bubbles()), count, shifted.shift,
      [&](auto x, auto y) { solve_shifted(shifted, factor, x, y); },
      [&](auto x, auto y) { apply_mass(shifted, x, y); });
  vibration.solves = modes.iterations;
  if (modes.status != numerics::ModesStatus::converged) vibration.status = VibrationStatus::not_converged;

  // What shift-and-invert returns as a rigid motion is round-off of the shift.
  const double rigid = 1e-9 * shifted.shift;
  vibration.omega = (modes.eigenvalues.array() < rigid).select(0.0, modes.eigenvalues.cwiseMax(0.0)).cwiseSqrt();
  vibration.participation = participation(body, modes.shapes);
  vibration.shapes = modes.shapes.topRows(shifted.boundary());

  if (vibration.status == VibrationStatus::converged && shifted.boundary() <= inertia_counted_up_to) {
    // Just below the last one found, so that a cluster cut at `count` is not taken for a missed mode.
    const double sigma = modes.eigenvalues[count - 1] * (1.0 - 1e-6) - rigid;
    const Index found = (modes.eigenvalues.array() < sigma).count();
    const Index there = modes_below(condensed(stiffness, shifted, -sigma), shifted, sigma);
    vibration.counted = true;
    if (there != found) vibration.status = VibrationStatus::mode_missed;
  }
  return vibration;
}

}  // namespace sunder::simulation
