#pragma once
/// How the crack water answers a small change of the faces' motion: derivatives of a solved pressure profile with
/// respect to apertures, aperture rates and mouth pressures, for a step that solves water and structure together.
///
/// In a wet region δp(s) = δp(start) - ∫ [∂g/∂q (δc - δV) + ∂g/∂w δw] ds; the change δc of its constant follows from
/// the pressure that is kept at its end, or from continuity at a closed tip. A front contributes nothing by moving: p
/// and dp/ds vanish there. So the derivatives stay continuous when a front passes a node, which then has p = 0 and,
/// from either side, δp = 0. Where |q| passes the critical flux, g jumps by Δφ/w³ and the place of the jump moves with
/// the flux: ∂g/∂q holds Δφ/(w³ |v|) there, which grows without bound as the crack comes to rest. In the band without a
/// root (`at_regime_jump`) the mixture of both profiles is differentiated with the regimes frozen and the flux held; in
/// a march it follows the water beyond the segment that jumps. Rates towards the future at a resting bound
/// (aperture.hpp) multiply by the factors of `apertures(…)`.

#include <Eigen/Core>

#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/pressure_profile.hpp"

namespace sunder::crackwater {

/// Rows: nodes (n + 1). Columns: apertures (n + 1), aperture rates (n + 1), upstream pressure, downstream pressure.
struct PressureTangent {
  explicit PressureTangent(int segments);

  Eigen::MatrixXd pressure;     ///< ∂p_i/∂x_j [Pa/m], [Pa s/m], [1], [1]
  Eigen::MatrixXd nodal_force;  ///< ∂f_i/∂x_j of the consistent nodal forces [Pa], [Pa s], [m], [m]

  /// Room to work: a row a segment (a node), see pressure_tangent.cpp.
  Eigen::ArrayXXd segments;
  Eigen::ArrayXd by_change, by_constant, running;
};

/// The tangent of the last `solve` of `solver`; allocates nothing. Zero after a solve with unusable input and after
/// `uniform`, whose pressure does not follow the faces.
void differentiate(const PressureSolver& solver, PressureTangent& tangent);

/// The tangent of the last trial of `march` with respect to the apertures at the end of the step, which also set how
/// much water must move; the columns of rates are zero. Allocates nothing.
void differentiate(const FillingMarch& march, PressureTangent& tangent);

}  // namespace sunder::crackwater
