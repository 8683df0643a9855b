#pragma once
/// What pushes on a polygon: surface traction on its edges, weight in its interior, pressure on its two crack faces.
///
/// Traction on an edge is a plain nodal load. Weight and face pressure act along the rays from the scaling centre; they
/// are described by their density p and power k, with virtual work ∫₀¹ v(ξ)ᵀ p ξᵏ dξ, and become the nodal load
///     f_k = ((k + 1) I + Aᵀ)⁻¹ p          (A: the closed loop of the polygon, v(ξ) = ξ^A v_b)
/// [Song 2018, in closed-loop form]. It exists for every k >= 0 and needs neither eigenvalues nor an inverse of
/// modes.
///
/// Signs: forces in global axes; pressure is positive where it pushes into the body, on edges and on both crack faces.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "solver/sbfem/coefficients.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::sbfem {

/// A load along the rays of a polygon, with virtual work ∫₀¹ v(ξ)ᵀ density ξ^power dξ.
struct RadialLoad {
  int power = 0;            ///< k >= 0
  Eigen::VectorXd density;  ///< p (2n) [N/m], unit thickness
};

/// A body force per volume (2) [N/m³], uniform over the polygon: k = 1, p = ∫ Nᵀ b J_b dη. Own weight is {0, -ρ g}.
RadialLoad body_force(const Boundary& boundary, const Eigen::Vector2d& force_density);

/// Pressure p(ξ) = Σ pressure[k] ξᵏ [Pa] on the two side faces of an open polygon, from the tip (ξ = 0) to its mouth (ξ
/// = 1); one load a power. Throws std::invalid_argument where the polygon is closed.
std::vector<RadialLoad> crack_face_pressure(const Boundary& boundary, std::span<const double> pressure);

/// Nodal load (2n) [N/m] of one radial load, or of several.
[[nodiscard]] Eigen::VectorXd load_vector(const PolygonSolution& solution, const RadialLoad& load);
[[nodiscard]] Eigen::VectorXd load_vector(const PolygonSolution& solution, std::span<const RadialLoad> loads);

/// Nodal load (2n) [N/m] of a traction t(s) = Σ traction.col(k) sᵏ [Pa], global axes, on one edge; s runs from 0 at its
/// first node to 1 at its last. Exact for any power. Throws std::invalid_argument where there is no such edge.
[[nodiscard]] Eigen::VectorXd edge_traction(const Boundary& boundary, int edge, const Eigen::Matrix2Xd& traction);

/// The same for a pressure Σ pressure[k] sᵏ [Pa] along the inward normal.
[[nodiscard]] Eigen::VectorXd edge_pressure(const Boundary& boundary, int edge, std::span<const double> pressure);

/// Nodal load (2m) of a traction on a single straight edge with nodes (2, m) [m] in order: what `edge_traction` is made
/// of, for assembling boundary loads without their polygons.
[[nodiscard]] Eigen::VectorXd edge_traction(const Eigen::Matrix2Xd& nodes, const Eigen::Matrix2Xd& traction);
/// Inward is to the left of the edge's direction: the body of a counter-clockwise outline.
[[nodiscard]] Eigen::VectorXd edge_pressure(const Eigen::Matrix2Xd& nodes, std::span<const double> pressure);

/// Re-expands a polynomial Σ c_k sᵏ over s in [0, 1] on the part from s = from to s = to: Σ b_k tᵏ, t in [0, 1].
/// Pressure over a whole crack (s = distance from the tip / crack length) becomes with {0, face length / crack length}
/// the ξ-powers of the tip polygon, and with the s of its two ends the powers of any other piece of the faces.
[[nodiscard]] std::vector<double> restrict_polynomial(std::span<const double> coefficients, double from, double to);

}  // namespace sunder::sbfem
