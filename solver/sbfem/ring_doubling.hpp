#pragma once
/// The stiffness of a polygon by gluing similar rings: no eigenvalue is needed.
///
/// In t = ln ξ the polygon is a stack of rings of the same coefficients. One ring of thickness h in t, interpolated
/// linearly with one midpoint, has the stiffness (node set 0 inside, 1 outside)
///     K00 = E0/h + (h/4) E2 - sym F,  K11 = E0/h + (h/4) E2 + sym F,  K01 = (h/4) E2 - E0/h + (Fᵀ - F)/2,  F = E1ᵀ.
/// It is the Cayley transform of the Hamiltonian with the shift s = 2/h and keeps its decaying subspace exactly, so
/// that any stack, glued ring by ring and condensed, tends to the exact stiffness: h sets the number of merges and the
/// round-off. Gluing a ring (A, B, C) = (K00, K11, K01) to itself, with S = A + B = L Lᵀ:
///     A ← A - C S⁻¹ Cᵀ,  B ← B - Cᵀ S⁻¹ C,  C ← -C S⁻¹ C.
/// C → 0 quadratically and B → K (a structure-preserving doubling algorithm for the Riccati equation
/// (K - F)ᵀ E0⁻¹ (K - F) = E2; compare [Chu, Fan & Lin 2005]).
///
/// Choice of the shift: s = √λ_max needs the fewest merges where the exponents λ lie between 1 and λ_max, but a thin
/// ring cancels digits of its stiff terms E0/h: with slivers and near incompressibility (λ_max = 1e3 … 1e6) it lost up
/// to four digits more than s = 10, which costs at most some more merges. Hence s = min(√λ_max, 10). A second
/// Wachspress shift would be thinner still and is left out.

#include <Eigen/Core>

namespace sunder::sbfem {

inline constexpr double ring_doubling_largest_shift = 10.0;
/// ‖C‖ ≤ finished ‖B‖: another merge would change B by less than round-off.
inline constexpr double ring_doubling_finished = 1e-11;
/// ‖C‖ ≤ (nearly / λ_max) ‖B‖: after one more merge, of B alone, the error is (‖C‖ λ_max / ‖B‖)⁴ in the softest
/// direction.
inline constexpr double ring_doubling_nearly = 1e-4;
inline constexpr int ring_doubling_most_merges = 50;

struct RiccatiSolution {
  Eigen::MatrixXd K;  ///< (m, m), in the variables of the arguments
  double asymmetry = 0.0;
  int iterations = 0;
  bool positive_definite = true;
  bool converged = false;
};

/// E0, E2 (m, m) symmetric positive definite, F (m, m); the ring energy [E0 F; Fᵀ E2] is positive definite.
RiccatiSolution ring_doubling(const Eigen::MatrixXd& E0, const Eigen::MatrixXd& F, const Eigen::MatrixXd& E2);

}  // namespace sunder::sbfem
