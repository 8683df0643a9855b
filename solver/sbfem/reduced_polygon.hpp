#pragma once
/// A polygon in scaled variables with its two translations taken out: what the three routes to the stiffness work on.
///
/// u = P û with P = diag(E0)^-1/2 makes moduli and lengths cancel. In these variables the translations T̂ = P⁻¹ T are
/// orthogonal (they touch different components), and u = Q v + T̂ w with [T̂ Q] orthogonal. The energy of a ring,
///     ½ ∫ [u'ᵀ E0 u' + 2 u'ᵀ E1ᵀ u + uᵀ E2 u] dξ/ξ,  ' = ξ d/dξ,
/// does not hold w itself, because E1ᵀ T = E2 T = 0; minimising over its rate leaves a polygon in v alone,
///     Ẽ0 = Qᵀ (E0 - R Rᵀ) Q,  F̃ = Qᵀ (E1ᵀ - R Sᵀ) Q,  Ẽ2 = Qᵀ (E2 - S Sᵀ) Q,
///     R = E0 T̂ L⁻ᵀ,  S = E1 T̂ L⁻ᵀ,  L Lᵀ = T̂ᵀ E0 T̂,
/// whose Hamiltonian has no eigenvalue near 0: the four numerical zeros ±1e-8 are gone exactly, without any shift.

#include <Eigen/Core>

#include "solver/sbfem/coefficients.hpp"

namespace sunder::sbfem {

struct ReducedPolygon {
  Eigen::VectorXd scale;  ///< P (2n) [Pa^-1/2]
  Eigen::MatrixXd
      mirror;  ///< (2n, 2): v_x, v_y of the reflections H = I - v vᵀ, ‖v‖² = 2, that carry T̂ to components 0 and 1
  Eigen::MatrixXd E0, F, E2;         ///< (m, m), m = 2n - 2; F stands for E1ᵀ
  Eigen::MatrixXd translation_rate;  ///< (2, 2m): w' = -translation_rate {v'; v}, so that no net force acts inside
  bool valid = false;                ///< false where the coefficients are not finite or E0 has no positive diagonal
};

ReducedPolygon reduce(const Coefficients& coefficients);

/// Stiffness (2n, 2n) in the polygon's own variables of a stiffness (m, m) in the reduced ones.
Eigen::MatrixXd expand_stiffness(const ReducedPolygon& polygon, const Eigen::MatrixXd& reduced);

/// X ← H X: back from the variables {w; v} to scaled displacements, columns of (2n, …); H is its own inverse.
void reflect_rows(const ReducedPolygon& polygon, Eigen::Ref<Eigen::MatrixXd> X);

}  // namespace sunder::sbfem
