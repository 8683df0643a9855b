#pragma once
/// The values of a supernodal Cholesky factor whose shape CHOLMOD has found.
///
/// CHOLMOD hands its dense blocks to BLAS, and a BLAS that does not know the processor falls back to kernels of twenty
/// years ago: OpenBLAS 0.3.21 runs SSE3 code on every Xeon since 2023. The blocks here are Eigen's, compiled with the
/// rest of the solver: the same speed and the same bits whatever BLAS is installed.
///
/// Right-looking: with L_s the columns of supernode s, dense on the rows that they share,
///
///     L_s ← A_s,    [L_d; L_b] with L_d L_dᵀ = D,  L_b ← L_b L_dᵀ⁻¹,    A_t ← A_t - (L_b L_bᵀ)_t
///
/// for all supernodes t above s.

#include <cholmod.h>

#include <Eigen/SparseCore>

namespace sunder::numerics {

/// Fills `factor`, supernodal, of the lower triangle `lower` in the factor's order. Returns -1, or the first column in
/// that order whose pivot is not positive (nor NaN); what stands in the factor is then of no use. Precondition: the
/// values are allocated.
[[nodiscard]] int supernodal_values(const Eigen::SparseMatrix<double>& lower, cholmod_factor& factor);

}  // namespace sunder::numerics
