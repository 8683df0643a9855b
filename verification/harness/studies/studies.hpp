#pragma once
/// The studies, one source file each. A new one is declared here and listed in studies.cpp.

#include "verification/harness/study.hpp"

namespace sunder::verification {

/// "scene": reads the scene with the setting's keys in place, runs it, and hands on its summary.
StudyOutput run_scene(const StudyInput& input);

/// "polygon": one polygon under the exact polynomial fields, its mass, its exponents and its three routes. Parameters:
/// shape = "regular" (corners), "star" (corners, inner_radius), "rectangle" (aspect), "short-edge" (edge); order (1),
/// degree of the fields (order), youngs_modulus (1), poisson_ratio (0.2), plane ("strain"), route ("ring-doubling",
/// "matrix-sign", "ordered-schur"), scale (1), rotation (0), shift (0), centre_distance (1: the mean of the corners;
/// towards 0: the first edge). Quantities, all relative: force_error = ‖K u - f‖ / ‖f‖, backward_error = ‖K u - f‖ /
/// (‖K‖ ‖u‖), stress_error inside, rigid_motion_error, mass_error, exponent_error, sign_difference and schur_difference
/// of K; zero_stiffness_modes.
StudyOutput run_polygon(const StudyInput& input);

}  // namespace sunder::verification
