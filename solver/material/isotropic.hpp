#pragma once
/// An isotropic linear elastic solid of unit thickness.

#include <Eigen/Core>

namespace sunder::material {

enum class Plane { strain, stress };

struct Isotropic {
  double youngs_modulus;  ///< E [Pa], > 0
  double poisson_ratio;   ///< ν [-], 0 <= ν < 0.5
  double density = 0.0;   ///< ρ [kg/m³], >= 0; needed only where inertia or gravity is present
  Plane plane = Plane::strain;
};

/// Throws std::invalid_argument naming the value and its bound where a value is out of range or not finite.
void check(const Isotropic& material);

/// D (3, 3) [Pa] with {σ_xx, σ_yy, τ_xy} = D {ε_xx, ε_yy, γ_xy}.
Eigen::Matrix3d elasticity_matrix(const Isotropic& material);

/// G = E / (2 (1 + ν)) [Pa].
double shear_modulus(const Isotropic& material);

/// E' [Pa]: E in plane stress, E / (1 - ν²) in plane strain.
double effective_modulus(const Isotropic& material);

/// Kolosov's constant κ [-]: 3 - 4ν in plane strain, (3 - ν) / (1 + ν) in plane stress.
double kolosov_constant(const Isotropic& material);

/// c_p and c_s [m/s] of the plane state. Density must be > 0.
double longitudinal_wave_speed(const Isotropic& material);
double shear_wave_speed(const Isotropic& material);

}  // namespace sunder::material
