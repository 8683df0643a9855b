#pragma once
/// The displacement that carries a radial load inside a polygon: u(ξ) = ξ^{k+1} d.
///
/// With s = k + 1 the amplitude d obeys [Song 2018]
///     L(s) d = [s² E0 + s (E1ᵀ - E1) - E2] d = -p,      L(s) = (s I + Aᵀ) E0 (s I - A),
/// so that (s I - A) d = -E0⁻¹ f_k with the nodal load f_k. Where s is itself an exponent of the polygon (s = 1 always,
/// s = 2 on edges of order >= 2) the equation is singular but consistent: the part of d along that exponent is not
/// determined and cancels against the homogeneous field; the solution of least norm is taken.

#include <span>
#include <vector>

#include "solver/sbfem/loads.hpp"

namespace sunder::sbfem {

struct ParticularSolution {
  int power = 0;          ///< k: u(ξ) = ξ^{k+1} d
  Eigen::VectorXd d;      ///< amplitude (2n) [m]
  double residual = 0.0;  ///< ‖L(s) d + p‖ / (‖p‖ + ‖L(s)‖ ‖d‖), scaled; <= 1e-12 where healthy
};

[[nodiscard]] ParticularSolution particular_solution(const Coefficients& coefficients, const PolygonSolution& solution,
                                                     const RadialLoad& load);

[[nodiscard]] std::vector<ParticularSolution> particular_solutions(const Coefficients& coefficients,
                                                                   const PolygonSolution& solution,
                                                                   std::span<const RadialLoad> loads);

}  // namespace sunder::sbfem
