#pragma once
/// Which way a crack turns, and how hard it is driven: the criterion of the largest hoop stress.
///
///     θ = 2 atan(-2 K_II / (K_I + √(K_I² + 8 K_II²))),     K_eq = cos(θ/2) (K_I cos²(θ/2) - (3/2) K_II sin θ)
/// [Erdogan and Sih 1963]. θ is measured from the crack's direction, counter-clockwise positive; positive K_II turns
/// the crack clockwise. This form keeps all digits as K_II → 0; the usual (K_I - √…) / (4 K_II) loses them.
///
/// K_I <= 0, where the faces overlap in the linear field: the same field still has a largest hoop stress wherever
/// K_II ≠ 0, and it is returned: ±70.5288° at K_I = 0, tending to ±180° with K_eq → 0 as K_I → -∞ (evaluated as
/// (K_I - √…) / (4 K_II), which is the stable form there). Without K_II no direction is preferred: θ = 0 and K_eq = 0.

#include "solver/fracture/stress_intensity.hpp"

namespace sunder::fracture {

/// θ [rad], in (-π, π).
[[nodiscard]] double kink_angle(const StressIntensityFactors& factors);

/// K_eq [Pa √m] >= 0: the mode I factor with the same largest hoop stress; the crack grows where it reaches the
/// toughness.
[[nodiscard]] double equivalent_factor(const StressIntensityFactors& factors);

}  // namespace sunder::fracture
