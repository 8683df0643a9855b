#pragma once
/// The force on a rigid face after an impulse of acceleration, from the discretised face.

#include <vector>

#include "solver/reservoir/face_water.hpp"

namespace sunder::reservoir {

/// [N s/m² per m/s²·s → kg/(m s)] at each of `times` [s] >= 0. Over a rigid bottom exact, ρ c Σ g_k² J0(k c t); else
/// from trapezoidal weights at two steps, Δt = t_max/8192 and half of it, whose errors of order Δt² cancel: what is
/// left is of order Δt⁴ for the modes that the step resolves. Throws std::invalid_argument where a time is negative or
/// not finite.
[[nodiscard]] std::vector<double> face_impulse(const FaceModes& modes, const std::vector<double>& times);

}  // namespace sunder::reservoir
