#pragma once
/// Compressible water behind a vertical face: the mass that it is at any complex frequency, and the weights of its
/// convolution.
///
/// The reservoir is a rectangle without an end, free at the surface (p = 0), with a bottom that reflects the part α of
/// a wave, ∂p/∂n = q ∂p/∂t, q c = (1 - α)/(1 + α) [Fenves & Chopra 1984]; the face moves it with the acceleration a
/// into the water, ∂p/∂x = -ρ a. With the pressure discretised along the face, x left exact, and S = s/c,
///
///     p = ρ Φ X^-½ G a,    M(s) = ρ Gᵀ X^-½ G,    X = diag(k²) + S q c b bᵀ + S² I
///
/// in the modes K φ = k² A φ, Φᵀ A Φ = I, of the pressure mesh; G = Φᵀ ∫ Nᵀ N_face dy, b = Φ at the bottom. Re √ > 0.

#include <complex>
#include <memory>

#include "solver/convolution/make_convolution.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/reservoir/face.hpp"

namespace sunder::reservoir {

struct Water {
  double density = 1000.0;               ///< ρ [kg/m³], > 0
  double sound_speed = 1440.0;           ///< c [m/s], > 0
  double reflection_coefficient = 0.75;  ///< α of the bottom [-], 0 … 1; 1: rigid
};

/// Throws std::invalid_argument naming value and bound.
void check(const Water& water);

/// q c = (1 - α)/(1 + α).
[[nodiscard]] double bottom_damping(const Water& water);

struct FaceModes {
  Water water = {};
  double depth = 0.0;                       ///< H [m]
  Eigen::VectorXd wavenumber_squared = {};  ///< k² (m) ascending [1/m²]
  Eigen::MatrixXd load = {};                ///< G (m, n) [√m]
  Eigen::VectorXd bottom = {};              ///< b (m) [1/√m]
  Eigen::MatrixXd shapes = {};              ///< Φ (m, m), modes in columns [1/√m]

  int size() const { return static_cast<int>(load.cols()); }
};

[[nodiscard]] FaceModes face_modes(const PressureMesh& mesh, const Water& water);

/// What unit accelerations of the face do at the complex frequency s [1/s], Re s >= 0.
struct FaceResponse {
  Eigen::MatrixXcd mass;      ///< M (n, n) [kg/m]
  Eigen::MatrixXcd pressure;  ///< (m, n) at the pressure nodes, a unit acceleration each [Pa s²/m]
  bool infinite = false;      ///< s is a natural frequency of water over a rigid bottom: nothing is given
};
[[nodiscard]] FaceResponse face_response(const FaceModes& modes, std::complex<double> s);

/// Weights W_0 … W_last of the trapezoidal convolution quadrature, for all of the face's nodes.
[[nodiscard]] convolution::WeightSequence face_weights(const FaceModes& modes, double time_step, long long last,
                                                       numerics::ThreadPool* pool = nullptr);

/// Over a rigid bottom (α = 1) the modes do not know of each other: the weights of each, to be used with G as
/// convolution::Transformed. In closed form, from 1/√(1 - 2xζ + ζ²) = Σ P_j(x) ζ^j:
///
///     w_j = (ρ Δt c/2) cos(θ/2) (P_j + P_{j-1})(cos θ),    tan(θ/2) = k c Δt/2
[[nodiscard]] convolution::WeightSequence modal_weights(const FaceModes& modes, double time_step, long long last);

/// The convolution of accelerations 0 … `steps`: by modes where α = 1, dense otherwise. `state_space` needs the memory
/// of a few exponentials, whatever `steps`: closed sums where α = 1 (modal_exponentials.hpp), otherwise those of the
/// weights until they have faded to a hundredth of the tolerance. Throws std::invalid_argument
/// where time_step is not finite and > 0 or steps is out of range.
[[nodiscard]] convolution::MadeConvolution face_convolution(const FaceModes& modes, double time_step, long long steps,
                                                            const convolution::ConvolutionOptions& options = {});

}  // namespace sunder::reservoir
