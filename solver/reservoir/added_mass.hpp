#pragma once
/// Water that answers at once: at rest, after Westergaard, and incompressible.

#include <Eigen/Core>

#include "solver/reservoir/face.hpp"

namespace sunder::reservoir {

/// ρ g (level - y) below the surface, 0 above [Pa]. Density [kg/m³] > 0, gravity [m/s²] >= 0.
[[nodiscard]] double hydrostatic_pressure(double density, double gravity, double level, double height);

/// ∫ Nᵀ p dy (n) [N/m] of that pressure. Exact.
[[nodiscard]] Eigen::VectorXd hydrostatic_force(const Face& face, double level, double density, double gravity);

/// ∫ Nᵀ (7/8) ρ √(H (level - y)) N dy (n, n) [kg/m], H the depth [Westergaard 1933]. Integrated exactly: the total is
/// (7/12) ρ H².
[[nodiscard]] Eigen::MatrixXd westergaard_mass(const Face& face, double level, double density);

/// Incompressible water in the endless reservoir [Westergaard 1933; Chopra 1967],
///
///     M = 2 ρ Σ_k c_k c_kᵀ / (λ_k H),    λ_k = (2k - 1) π / (2H),    c_k = ∫ N cos(λ_k y) dy  (y from the bottom)
///
/// (n, n) [kg/m]. c_k is exact; the sum ends where λ_k is 400 over the shortest wet element, at most at k = 20 000, and
/// what is left of the acceleration at the surface, Σ 1/λ_k³, is added. The total of a rigid face is 14 ζ(3)/π³ ρ H².
[[nodiscard]] Eigen::MatrixXd incompressible_mass(const Face& face, double level, double density);

}  // namespace sunder::reservoir
