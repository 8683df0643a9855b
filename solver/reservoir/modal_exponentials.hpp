#pragma once
/// The memory of water over a rigid bottom as sums of exponentials, in closed form.
///
/// The weights of a mode (face_water.hpp: modal_weights) decay like j^-½ only: no truncation is safe and no fit over a
/// window holds beyond it. But their generating function (1 + ζ)/√((1 - ζ e^{iθ})(1 - ζ e^{-iθ})) is regular but for
/// two cuts ζ = e^{±iθ} t, t >= 1; a contour around them gives, with t = e^v,
///
///     (P_j + P_{j-1})(cos θ) = (2/π) Re ∫₀^∞ e^{-j (v + iθ)} (1 + e^{v+iθ}) / (√(e^v - 1) √(1 - e^{v+2iθ})) dv,  j >=
///     1
///
/// which is a sum of decaying exponentials already. The trapezoidal rule in ln v converges as e^{-π²/h} (the nearest
/// singularities lie at |Im ln v| = π/2), whatever θ; the nodes below v₀ with N v₀ small, at which e^{-j v} hardly
/// differs from 1 in N steps, are one node. So a mode needs about ln(N/ε) ln(1/ε)/π² complex numbers.

#include "solver/convolution/exponential_sums.hpp"
#include "solver/reservoir/face_water.hpp"

namespace sunder::reservoir {

/// Of all modes (m), for accelerations 0 … `steps`, to `tolerance` of Σ_j |w_j| of every mode, which is proved by
/// comparing all `steps` weights, made one after the other and not kept. `error.absolute` bounds the nodal forces: with
/// G = modes.load, ‖G‖₂² Σ_j max_k |w_jk - w~_jk|. Throws std::invalid_argument where `time_step` is not finite and >
/// 0, `steps` < 1, or `tolerance` is not 1e-12 … 0.1.
[[nodiscard]] convolution::ExponentialSums modal_exponentials(const FaceModes& modes, double time_step, long long steps,
                                                              double tolerance, numerics::ThreadPool* pool = nullptr);

}  // namespace sunder::reservoir
