#pragma once
/// S(s) of an unbounded domain at many s: the forces that hold its line, per displacement.
///
/// The equation of unbounded_domain.hpp is an ordinary differential equation in s. It is started from the asymptotic
/// series at a large |s| and integrated towards smaller |s|: errors of ŝ then die out like e^{(c_i + c_j) σ}, whereas
/// outwards they grow. Only the difference to the radiation term, t = ŝ - σ c - k, is integrated,
///     σ dt/dσ = σ (c t + t c) + (g + t)(g + t)ᵀ - e2,  g = k + e1,
/// along straight lines in ln σ, with Dormand & Prince's pair of orders 5 and 4. S is analytic for Re s >= 0 but s = 0,
/// so any path there leads to the same value.

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "solver/foundation/unbounded_domain.hpp"

namespace sunder::foundation {

struct StiffnessOptions {
  double tolerance = 1e-10;    ///< local error of a step ≤ tolerance · ‖g + t‖ (Frobenius), > 0
  long max_steps = 1'000'000;  ///< accepted and rejected ones of the whole path, >= 1
};

enum class StiffnessStatus {
  converged,
  too_many_steps,  ///< max_steps was reached, or a step became too small to change s
  not_finite,      ///< the matrices overflowed
};

struct StiffnessPath {
  StiffnessStatus status = StiffnessStatus::converged;
  std::size_t reached = 0;  ///< how many of the places were visited
  long steps = 0, rejected = 0;
  double start = 0.0;  ///< |s| [1/s] from which on upwards the series was used
};

/// Calls visit(i, S) with S(s_i) (n, n) [Pa], complex symmetric, for i = 0, 1, …. The places s [1/s]: Re s >= 0, s ≠ 0,
/// |s| never growing by more than round-off from one to the next. Throws std::invalid_argument where they are not so.
[[nodiscard]] StiffnessPath dynamic_stiffness(const UnboundedDomain& domain, std::span<const std::complex<double>> s,
                                              const std::function<void(std::size_t, const Eigen::MatrixXcd&)>& visit,
                                              const StiffnessOptions& options = {});

}  // namespace sunder::foundation
