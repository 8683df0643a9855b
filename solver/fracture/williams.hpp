#pragma once
/// Williams' fields around a crack tip: what every stress field near a tip is a sum of.
///
/// The field of power λ = n/2 (any integer n ≠ 0) is r^λ times a function of θ, free of traction on both faces θ = ±π,
/// and comes in a symmetric (mode I) and an antimetric (mode II) form [Williams 1957; amplitudes as in Karihaloo & Xiao
/// 2001]. n = 1 holds K_I and K_II, n = 2 the T-stress and the rotation; n < 0 are the fields of the exterior, which
/// measure the others by Betti's theorem.

#include <Eigen/Core>

#include "solver/material/isotropic.hpp"
#include "solver/sbfem/coefficients.hpp"

namespace sunder::fracture {

enum class Mode { I, II };

/// Local axes of a tip: x along the crack's advance, y to its left.
struct TipFrame {
  double direction = 0.0;                                   ///< from global x, counter-clockwise [rad]
  Eigen::Matrix2d to_global = Eigen::Matrix2d::Identity();  ///< columns: local x and y in global axes
  double face_length = 0.0;                                 ///< from the tip to the mouth [m]
};

/// The frame of an open polygon from its two mouth nodes.
/// Throws std::invalid_argument where the polygon is closed or its two faces are more than 1e-6 of their length apart.
TipFrame tip_frame(const sbfem::Boundary& boundary);

/// Polar coordinates (r, θ) (2, n) of the boundary's nodes in the tip's axes; θ of the mouth nodes is exactly -π and π.
Eigen::Matrix2Xd polar_nodes(const sbfem::Boundary& boundary, const TipFrame& frame);

/// Amplitude of the field: n = 1: K_I or K_II = 1 Pa √m; n = 2: T = 1 Pa in mode I, rotation 1 rad in mode II; any
/// other n: the coefficient a_n or b_n = 1.
struct WilliamsField {
  int n = 1;
  Mode mode = Mode::I;
};

/// Displacement (2) [m] and stress {σ_xx, σ_yy, τ_xy} [Pa] in local axes at (r, θ).
Eigen::Vector2d displacement(const WilliamsField& field, const material::Isotropic& material, double r, double theta);
Eigen::Vector3d stress(const WilliamsField& field, double r, double theta);

/// ∂u/∂x (2) along the crack, in local axes at (r, θ).
Eigen::Vector2d displacement_slope(const WilliamsField& field, const material::Isotropic& material, double r,
                                   double theta);

/// Nodal values (2n) [m] on a crack polygon's boundary, in global axes.
Eigen::VectorXd nodal_displacement(const WilliamsField& field, const material::Isotropic& material,
                                   const sbfem::Boundary& boundary, const TipFrame& frame);

}  // namespace sunder::fracture
