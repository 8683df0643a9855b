#pragma once
/// The stiffness of a polygon by gluing similar rings: no eigenvalue is needed.
///
/// In t = ln ξ the polygon is a stack of rings of the same coefficients. One ring of thickness h in t, interpolated
/// linearly with one midpoint, has the stiffness (node set 0 inside, 1 outside)
///     K00 = E0/h + (h/4) E2 - sym F,  K11 = E0/h + (h/4) E2 + sym F,  K01 = (h/4) E2 - E0/h + (Fᵀ - F)/2,  F = E1ᵀ.
/// It is the Cayley transform of the Hamiltonian with the shift 2/h and keeps its decaying subspace exactly, so that
/// any stack, glued ring by ring and condensed, tends to the exact stiffness: h sets the number of merges, not the
/// accuracy. Gluing (A, B, C) inside (A', B', C') with S = B + A' = L Lᵀ:
///     A ← A - C S⁻¹ Cᵀ,  B ← B' - C'ᵀ S⁻¹ C',  C ← -C S⁻¹ C'.
/// Glued to itself again and again, C → 0 quadratically and B → K (a structure-preserving doubling algorithm for the
/// Riccati equation (K - F)ᵀ E0⁻¹ (K - F) = E2; compare [Chu, Fan & Lin 2005]).

#include <Eigen/Core>

namespace sunder::sbfem {

struct RingDoublingOptions {
  /// λ_min of the closed loop: 1 where the boundary is closed, 1/2 at a crack. Only the number of merges depends on it.
  double smallest_exponent = 0.5;
  /// 1 or 2 Wachspress shifts for the first ring, or 0: the solver chooses.
  int shifts = 0;
  int most_merges = 40;
};

struct RiccatiSolution {
  Eigen::MatrixXd K;  ///< (m, m), in the variables of the arguments
  double asymmetry = 0.0;
  int iterations = 0;
  bool positive_definite = true;
  bool converged = false;
};

/// E0, E2 (m, m) symmetric positive definite, F (m, m); the ring energy [E0 F; Fᵀ E2] is positive definite.
RiccatiSolution ring_doubling(const Eigen::MatrixXd& E0, const Eigen::MatrixXd& F, const Eigen::MatrixXd& E2,
                              const RingDoublingOptions& options);

}  // namespace sunder::sbfem
