#pragma once
/// Real Schur form with the wanted eigenvalues first: orthonormal bases of invariant subspaces.
///
/// Eigen's RealSchur neither balances nor reorders. Here neighbouring blocks of order 1 or 2 are exchanged by
/// orthogonal similarity: A11 X - X A22 = γ A12, QR of [-X; γ I] [Bai & Demmel 1993].

#include <Eigen/Core>
#include <functional>

namespace sunder::numerics {

enum class SchurStatus {
  converged,
  not_converged,  ///< QR iteration gave up, or the matrix is not finite
  swap_refused,   ///< two blocks are too close to be exchanged to round-off; T and U are valid, their order is not
};

struct OrderedSchur {
  Eigen::MatrixXd T;  ///< (n, n) quasi-upper triangular, blocks of order 1 and 2 on the diagonal
  Eigen::MatrixXd U;  ///< (n, n) orthogonal, A = U T Uᵀ
  int selected = 0;   ///< number of eigenvalues that were wanted; they are those of the leading block
  SchurStatus status = SchurStatus::converged;
};

/// `wanted(re, im)` is asked once for every eigenvalue; of a complex pair with im > 0 only, and the pair stays
/// together.
[[nodiscard]] OrderedSchur ordered_schur(const Eigen::MatrixXd& A, const std::function<bool(double, double)>& wanted);

/// Makes rows and columns of A alike in size by powers of two: A ← D⁻¹ A D. Returns the diagonal of D
/// [Parlett & Reinsch 1969; in the 2-norm as James, Langou & Lowery 2014].
Eigen::VectorXd balance(Eigen::MatrixXd& A);

}  // namespace sunder::numerics
