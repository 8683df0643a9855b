#pragma once
/// The mean strain of a polygon, which is finite at a crack tip too, and the displacement of the tip itself: what a
/// picture shows of a polygon. Linear in the displacements u_b of its boundary, so given as matrices, once a mesh.
///
///     ε̄ = (1/A) ∮ sym(u ⊗ n) ds                                     (divergence theorem; n outward)
///
/// Along a closed boundary u is known. A crack polygon has its two faces as well: with u = ξ^A (u_b - Σ d_k) +
/// Σ ξ^(k+1) d_k their mean displacement is ∫₀¹ u dξ = (I + A)⁻¹ (u_b - Σ d_k) + Σ d_k / (k + 2).

#include <Eigen/Core>
#include <span>

#include "solver/sbfem/loads.hpp"

namespace sunder::sbfem {

/// (3, 2n) [1/m]: ε̄ = {ε_xx, ε_yy, γ_xy} from u_b (2n) [m]. Exact. Throws std::invalid_argument where the polygon is
/// open.
[[nodiscard]] Eigen::Matrix3Xd mean_strain(const Boundary& boundary);

struct TipField {
  Eigen::Matrix3Xd mean_strain;                                    ///< (3, 2n) [1/m], from u_b
  Eigen::Matrix2Xd tip;                                            ///< (2, 2n) [-]: displacement of the tip from u_b
  Eigen::Vector3d mean_strain_of_loads = Eigen::Vector3d::Zero();  ///< to be added [-]
  Eigen::Vector2d tip_of_loads = Eigen::Vector2d::Zero();          ///< likewise [m]
};

/// Of an open polygon with the radial loads it carries. Throws std::invalid_argument where the polygon is closed.
[[nodiscard]] TipField tip_field(const Boundary& boundary, const Coefficients& coefficients,
                                 const PolygonSolution& solution, std::span<const RadialLoad> loads = {});

}  // namespace sunder::sbfem
