#pragma once
/// The water on a rigid vertical face, as series in the modes of its depth: what a discretised face is held against.
///
/// Everything is scaled: κ = ω H/c, T = c t/H; force per ρ a H², pressure per ρ a H, impulse response per ρ c H.

#include <complex>

namespace sunder::reservoir {

enum class SeriesStatus {
  converged,
  infinite,        ///< κ is a natural frequency (odd multiple of π/2) of water over a rigid bottom: no value
  root_not_found,  ///< an eigenvalue z cot z = -iκ q c was not found: no value
};

struct RigidFaceResponse {
  std::complex<double> force;          ///< F / (ρ a H²) = Σ I²/(N √(z² - κ²)) [-]
  std::complex<double> base_pressure;  ///< p(0) / (ρ a H) [-]
  SeriesStatus status = SeriesStatus::converged;
};

/// [Fenves & Chopra 1984] with z cot z = -iκ qc, I = (1 - cos z)/z, N = (1 - sin 2z / 2z)/2; `terms` of the series and
/// the rest 1/(π³ terms²) of the force. κ >= 0, qc >= 0 (0: rigid bottom). Throws std::invalid_argument otherwise.
[[nodiscard]] RigidFaceResponse rigid_face_response(double kappa, double bottom_damping, int terms = 4000);

/// First `count` eigenvalues z of the depth into `z`; false where one was not found.
[[nodiscard]] bool depth_eigenvalues(double kappa, double bottom_damping, int count, std::complex<double>* z);

/// The force on the face after an impulse of acceleration, rigid bottom: Σ (2/z_n²) J0(z_n T), z_n = (2n - 1) π/2, per
/// ρ c H; 1 - 2T/π exactly before the first echo, T <= 2. To 2e-9. T >= 0.
[[nodiscard]] double rigid_face_impulse(double T);

/// The same over an absorbing bottom until the first wave has crossed the depth, 0 <= T <= 1, where it is exactly
/// 1 - (2/π)(1 + β) T with β = ∫₀^∞ qc du / ((1 + u²)^{3/2} (√(1 + u²) + qc)). Throws std::invalid_argument for T > 1.
[[nodiscard]] double absorbing_face_impulse(double T, double bottom_damping);

}  // namespace sunder::reservoir
