#pragma once
/// M(t): the forces on the line of an unbounded domain for a unit impulse of acceleration, R(t) = ∫ M(t - τ) ü(τ) dτ.
///
/// Two routes that share the coefficient matrices and nothing else.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "solver/foundation/dynamic_stiffness.hpp"
#include "solver/foundation/unbounded_domain.hpp"

namespace sunder::foundation {

struct ImpulseSamples {
  StiffnessStatus status = StiffnessStatus::converged;
  std::vector<Eigen::MatrixXd> M;  ///< one a time, (n, n) [kg/(m s)], symmetric; empty where the path did not converge
};

/// M at `times` [s], > 0 or 0 (M(0) = C, the radiation): the inverse Laplace transform of S(s)/s² on the line Re s = γ
/// by a Fourier sum of period P = 2 max(times), e^{-γP} = 1e-10. Five terms of the asymptotic series are transformed by
/// hand, so that the rest falls like |s|⁻⁶. Error about 1e-8 of the largest M at the latest time. Throws
/// std::invalid_argument where a time is < 0 or not finite.
[[nodiscard]] ImpulseSamples impulse_response(const UnboundedDomain& domain, std::span<const double> times,
                                              const StiffnessOptions& options = {});

/// M at j · time_step, j = 0 … count, by marching the equation in time [Wolf & Song 1996, here differentiated once, a
/// Volterra equation of the second kind: the first kind blows up]:
///     m(0) m + m' * m + e1' ∫m + ∫m e1'ᵀ + t m - t²/2 e2' - m0 = 0,  e1' = e1 - 1,  e2' = e2 - e1 e1ᵀ,
/// m linear between the steps; each step is one Lyapunov equation whose matrix changes by t/2 only: one Schur form for
/// all. Second order in time_step [s] > 0; O(count² n³) work. A check, not the default: weights from S(s) cost
/// O(count n³). Throws std::invalid_argument where time_step is not > 0 or count < 1.
[[nodiscard]] ImpulseSamples march_impulse_response(const UnboundedDomain& domain, double time_step, int count);

}  // namespace sunder::foundation
