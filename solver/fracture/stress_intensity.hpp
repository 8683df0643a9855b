#pragma once
/// Stress intensity factors and T-stress at a crack tip, from the displacements around its crack polygon.
///
/// They are linear in the boundary displacements u_b and in the radial loads (weight, pressure on the two faces):
///     {K_I, K_II, T} = F u_b + Σ g(load).
/// F is made once when the tip has moved; a time step then costs one product. The loads' share is not small: leaving it
/// out for a uniform face pressure gives K_I 21 % too low on an edge-cracked plate of one polygon.
///
/// Local axes at the tip: x along the crack's direction, away from the mouth; y to its left; the faces at θ = ±π.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <span>

#include "solver/fracture/extraction.hpp"
#include "solver/material/isotropic.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::fracture {

struct StressIntensityFactors {
  double K_I = 0.0;   ///< [Pa √m], negative where the faces overlap
  double K_II = 0.0;  ///< [Pa √m], positive where the upper (left) face slides ahead of the lower one
};

struct CrackTipOptions {
  Extraction extraction = Extraction::reciprocity;
  bool exponents =
      true;  ///< also take the exponents near ½ (they tell the resolution); needed by all but `reciprocity`
};

enum class TipStatus {
  ready,
  not_a_crack,  ///< the polygon has no pair of exponents near ½: F is zero, no factors
};

/// A crack polygon prepared for asking K_I, K_II and T of any displacement.
struct CrackTip {
  double direction = 0.0;                           ///< of the crack at its tip, from global x, counter-clockwise [rad]
  double face_length = 0.0;                         ///< from the tip to the polygon's mouth [m]
  std::array<std::complex<double>, 2> exponents{};  ///< of the singular group, near ½ each; 0 where not asked for
  Eigen::Matrix3Xd of_displacement;  ///< F (3, 2n): {K_I, K_II, T} a boundary displacement; [Pa √m / m] and [Pa / m]
  TipStatus status = TipStatus::ready;

  // What `load_share` needs. By reciprocity the share is `dual` (f - p / (k + 1 - λ)); by modes (k + 1 - S)⁻¹ of the
  // shares of E0⁻¹ f.
  Extraction extraction = Extraction::reciprocity;
  Eigen::Matrix3Xd dual;                 ///< (3, 2n) exterior fields r^-½ I, r^-½ II, r^-1 I, scaled to F
  Eigen::Matrix2d singular_exponents;    ///< S of the singular group in the basis {K_I, K_II}
  Eigen::Matrix2d unit_exponents;        ///< S of the unit group in the basis {T, rotation}
  Eigen::RowVectorXd rotation;           ///< (2n): rotation of the unit group a boundary displacement [1/m]
  Eigen::RowVectorXd T_of_linear_field;  ///< (2n): σ_xx in local axes of a displacement ξ d at the tip [Pa / m]
};

/// Throws std::invalid_argument where the polygon is not open, or its two faces do not lie on each other.
[[nodiscard]] CrackTip crack_tip(const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
                                 const sbfem::PolygonSolution& solution, const material::Isotropic& material,
                                 const CrackTipOptions& options = {});

/// g (3): what one radial load adds to F u_b for {K_I, K_II, T}. Linear in the load: for pressure that changes with
/// time ask once for each power of a unit pressure.
[[nodiscard]] Eigen::Vector3d load_share(const CrackTip& tip, const sbfem::Coefficients& coefficients,
                                         const sbfem::PolygonSolution& solution, const sbfem::RadialLoad& load);

/// What is known at a tip for one state of displacement and load.
struct TipState {
  StressIntensityFactors factors;
  double T_stress = 0.0;  ///< σ_xx in local axes without the singular part, at the tip [Pa]
};

/// For boundary displacements u_b (2n) [m] and the sum of the load shares.
[[nodiscard]] TipState tip_state(const CrackTip& tip, const Eigen::VectorXd& boundary_displacement,
                                 const Eigen::Vector3d& load_shares = Eigen::Vector3d::Zero());

}  // namespace sunder::fracture
