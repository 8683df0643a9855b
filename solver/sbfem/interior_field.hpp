#pragma once
/// Displacement, strain and stress anywhere inside a polygon, from the displacements of its boundary.
///
///     u(ξ) = ξ^A (u_b - Σ d_k) + Σ ξ^{k+1} d_k,      ε = B1 u,ξ + B2 u / ξ,      σ = D ε
/// [Song 2018, Eq. (3.51) in closed-loop form]. ξ^A is taken on the complement of the two translations as the
/// exponential of A ln ξ, so that equal or defective exponents and the rotation need no care, and stresses stay bounded
/// towards the centre wherever the exponents allow it. Made for post-processing and tests, not for the step loop: one
/// matrix exponential a value of ξ.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/sbfem/particular.hpp"

namespace sunder::sbfem {

/// A place in a polygon: on the ray at `position` of an edge, at the fraction `xi` of the way from the centre.
struct RayPoint {
  int edge = 0;           ///< of the boundary
  double position = 0.0;  ///< s in [0, 1] from the edge's first node to its last
  double xi = 1.0;        ///< ξ in (0, 1]
};

/// The ray through a point (2) [m] relative to the scaling centre; none where the point lies outside by more than
/// 1e-9 of the polygon's size. The centre itself is on every ray, ξ = 0 on edge 0.
std::optional<RayPoint> locate(const Boundary& boundary, const Eigen::Vector2d& point);

class InteriorField {
 public:
  /// The polygon with its boundary displacements u_b (2n) [m] and the radial loads it carries. Copies what it needs.
  InteriorField(const Boundary& boundary, const Coefficients& coefficients, const PolygonSolution& solution,
                const material::Isotropic& material, const Eigen::VectorXd& boundary_displacement,
                std::span<const RadialLoad> loads = {});

  /// The displaced ring at one ξ in [0, 1]: nodal u and ξ u,ξ, for many points of the same ξ.
  struct Ring {
    double xi = 1.0;
    Eigen::VectorXd displacement;  ///< u(ξ) at the boundary's directions (2n) [m]
    Eigen::VectorXd offset;        ///< (u(ξ) - u(0)) / ξ (2n) [m]
    Eigen::VectorXd slope;         ///< du/dξ (2n) [m]
  };
  [[nodiscard]] Ring ring(double xi) const;

  [[nodiscard]] Eigen::Vector2d displacement(const Ring& ring, int edge, double position) const;  ///< [m]
  [[nodiscard]] Eigen::Vector3d strain(const Ring& ring, int edge, double position) const;  ///< {ε_xx, ε_yy, γ_xy}
  [[nodiscard]] Eigen::Vector3d stress(const Ring& ring, int edge, double position) const;  ///< {σ_xx, σ_yy, τ_xy} [Pa]

  [[nodiscard]] Eigen::Vector2d displacement(const RayPoint& point) const;
  [[nodiscard]] Eigen::Vector3d strain(
      const RayPoint& point) const;  ///< at ξ = 0 only where it is bounded; else not finite
  [[nodiscard]] Eigen::Vector3d stress(const RayPoint& point) const;

  /// Elastic energy of the polygon [J/m]: ½ ∫ ε : σ dV, in closed form.
  [[nodiscard]] double strain_energy() const;

  [[nodiscard]] const std::vector<ParticularSolution>& particular() const { return particular_; }

 private:
  Boundary boundary_;
  Eigen::Matrix3d elasticity_;
  Eigen::MatrixXd K_, rotation_, reduced_,
      coupling_;  ///< complement of the translations, A on it, and its feed to them
  Eigen::VectorXd boundary_displacement_, amplitude_;  ///< u_b, and u_b - Σ d_k
  std::vector<RadialLoad> loads_;
  std::vector<ParticularSolution> particular_;
  std::vector<Eigen::VectorXd> load_vectors_;
  std::vector<int> first_node_;
};

}  // namespace sunder::sbfem
