#pragma once
/// Displacement, strain and stress anywhere inside a polygon, from the displacements of its boundary.
///
///     u(ξ) = ξ^A (u_b - Σ d_k) + Σ ξ^{k+1} d_k,      ε = B1 u,ξ + B2 u / ξ,      σ = D ε
/// [Song 2018, in closed-loop form]. On the complement of the two translations ξ^A is the exponential of
/// A ln ξ, so that equal or defective exponents and the rotation need no care, and stresses stay bounded towards the
/// centre wherever the exponents allow it. Made for post-processing and tests, not for the step loop: one matrix
/// exponential a value of ξ.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/sbfem/edge_element.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/sbfem/particular.hpp"

namespace sunder::sbfem {

/// A place in a polygon: on the ray at `position` of an edge, at the fraction `xi` of the way from the centre.
struct RayPoint {
  int edge = 0;           ///< of the boundary
  double position = 0.0;  ///< s in [0, 1] from the edge's first node to its last
  double xi = 1.0;        ///< ξ in [0, 1]
};

/// The ray through a point (2) [m] relative to the scaling centre; none where the point lies outside by more than
/// 1e-9 of the polygon's size. The centre itself is ξ = 0 on edge 0.
std::optional<RayPoint> locate(const Boundary& boundary, const Eigen::Vector2d& point);

class InteriorField {
 public:
  /// The polygon with its boundary displacements u_b (2n) [m] and the radial loads it carries. Copies what it needs.
  InteriorField(const Boundary& boundary, const Coefficients& coefficients, const PolygonSolution& solution,
                const material::Isotropic& material, const Eigen::VectorXd& boundary_displacement,
                std::span<const RadialLoad> loads = {});

  /// Nodal amplitudes at one ξ, for many points of the same ξ.
  struct Ring {
    double xi = 1.0;
    Eigen::VectorXd displacement;  ///< u(ξ) on the rays of the boundary's nodes (2n) [m]
    Eigen::VectorXd offset;        ///< (u(ξ) - u(0)) / ξ (2n) [m]: bounded where stresses are
    Eigen::VectorXd slope;         ///< u,ξ (2n) [m]
  };

  /// 0 <= ξ <= 1, else std::invalid_argument. At ξ = 0 offset and slope are the limits where every exponent is >= 1,
  /// and not numbers where stresses are singular (a crack tip, a notch).
  [[nodiscard]] Ring ring(double xi) const;

  [[nodiscard]] Eigen::Vector2d displacement(const Ring& ring, int edge, double position) const;  ///< [m]
  [[nodiscard]] Eigen::Vector3d strain(const Ring& ring, int edge, double position) const;  ///< {ε_xx, ε_yy, γ_xy}
  [[nodiscard]] Eigen::Vector3d stress(const Ring& ring, int edge, double position) const;  ///< {σ_xx, σ_yy, τ_xy} [Pa]

  [[nodiscard]] Eigen::Vector2d displacement(const RayPoint& point) const;
  [[nodiscard]] Eigen::Vector3d strain(const RayPoint& point) const;
  [[nodiscard]] Eigen::Vector3d stress(const RayPoint& point) const;

  /// Elastic energy of the polygon [J/m], ½ ∫ ε : σ dV, in closed form.
  [[nodiscard]] double strain_energy() const { return strain_energy_; }

  /// The particular solutions of the loads, with their residuals.
  [[nodiscard]] const std::vector<ParticularSolution>& particular() const { return particular_; }

 private:
  std::vector<EdgeElement> edges_;
  Eigen::Matrix3d elasticity_;
  std::vector<ParticularSolution> particular_;
  double strain_energy_ = 0.0;
  // With v(ξ) = ξ^(reduced_ - I) start_ on the complement of the translations, the homogeneous field is
  // u = centre_ + ξ to_offset_ v and u,ξ = to_slope_ v.
  Eigen::MatrixXd reduced_;
  Eigen::MatrixXd to_offset_, to_slope_;
  Eigen::VectorXd start_, centre_;
};

}  // namespace sunder::sbfem
