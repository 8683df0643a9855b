#pragma once
/// The water's kernel on a rigid face over a rigid bottom as the convolution studies use it: ρ = c = H = 1.

#include <Eigen/Core>

#include "solver/reservoir/face_water.hpp"

namespace sunder::verification {

/// m(t) = Σ g_k² J0(k t).
struct WaterKernel {
  Eigen::VectorXd frequency;  ///< k, ascending
  Eigen::VectorXd weight;     ///< g_k²

  double sample(double t) const;
};

/// Modes of a face of `elements` elements of `order`.
reservoir::FaceModes unit_face_modes(int elements, int order, double reflection_coefficient);
WaterKernel water_kernel(const reservoir::FaceModes& modes);

/// ∫∫ m at 0, Δt, …, (count - 1) Δt; each step integrated by Gauss's rule in pieces of a few radians.
Eigen::RowVectorXd twice_integrated(const WaterKernel& kernel, double time_step, int count);

}  // namespace sunder::verification
