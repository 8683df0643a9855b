#pragma once
/// The studies, one source file each. A new one is declared here and listed in studies.cpp.

#include "verification/harness/study.hpp"

namespace sunder::verification {

/// "scene": reads the scene with the setting's keys in place, runs it, and hands on its summary.
StudyOutput run_scene(const StudyInput& input);

/// "scene-jitter": the scene as it is and `runs` (30) times with every number of it one unit in the last place up, down
/// or as it was (samples of records: by the numbers that scale them): the quantities of the plain run, and in the same
/// shape `spread`, the largest change of each, and `digits`, the decimal digits that it keeps.
StudyOutput run_scene_jitter(const StudyInput& input);

/// "polynomial-patch": the patch test of order p. Meshes the scene, prescribes every equilibrium polynomial up to the
/// parameter `degree` (and their sum) on the whole outer boundary and compares with it: displacement_error over all
/// nodes, reaction_error of the boundary's forces, and of the sum energy_error and stress_error inside every polygon;
/// residual, rigid_error, and rank_deficiency on small meshes. Parameters that move the body first: `scale`, `rotation`
/// [degrees], `shift` [m], `renumber` = 1.
StudyOutput run_polynomial_patch(const StudyInput& input);

/// "one-polygon": a polygon at the ends of its range (shapes and places in polygon_shape.hpp; `route`): force_error and
/// backward_error of its polynomials, rigid_error, largest_rigid and smallest_elastic eigenvalue, area_error,
/// moment_error and mass_difference (against a second solution of the closed loop); with `modes` = 1 exponent_error or,
/// where open, exponents, and condition_of_modes; with `compare` = 1 route_difference, asymmetry, formation_difference;
/// with `stress` = 1 (it is 0 otherwise) stress_error of its polynomials inside.
StudyOutput run_one_polygon(const StudyInput& input);

/// "crack-water-motion": a uniform crack with a closed tip (`aperture`, `length`, `segments`, `pressure` at its mouth,
/// `viscosity`), full up to `start`, that breathes (`motion` = "breathing": aperture · (1 + amplitude · sin 2 π t)) or
/// moves by `rate` · time_step to and fro ("flipping") for `duration`. With a `time_step` it is marched:
/// front_position, water_volume_error (of the water moved), water_error (of that moved and held), least_pressure,
/// least_void, pressure_times_void, most_water (relative to the capacity of a node). Without one its front is tracked
/// to `tolerance`: front_position.
StudyOutput run_crack_water_motion(const StudyInput& input);

/// "jitter": the same polygon `runs` times with every coordinate moved by one unit in the last place or not: spread and
/// decimal digits that stiffness and mass keep.
StudyOutput run_jitter(const StudyInput& input);

/// "state-transfer": grows the first crack `steps` times by `increment` [m], turning by `turn` [rad] to the left and
/// to the right in turns, each time from the equilibrium of the scene: reuse_difference (polygons taken over against
/// all formed anew) and reused_share; linear_error of rigid motions and tension along the crack, rigid_energy;
/// new_opening of the new faces and old_opening, the least of the old ones over a square root profile; and
/// strain_energy_change and kinetic_energy_change of the equilibrium itself, one an event.
StudyOutput run_state_transfer(const StudyInput& input);

/// "convolve": the water's convolution of white noise on a face of `elements` quadratic elements (ρ = c = H = 1) for
/// `steps` of `step`, by `method` (automatic, direct, blocked-direct, block-fft, state-space with `tolerance`, or
/// water-memory: what reservoir.memory_tolerance asks for; `truncation` H/c) against the plain sum: error (largest, of
/// the largest force), relative_error (of norms), stated_error, share_of_bound of the stated absolute error; with
/// `passivity` = 1 least_power on the unit circle.
StudyOutput run_convolve(const StudyInput& input);

/// "coupled-oscillator": an undamped oscillator (`mass_ratio`, `dry` frequency) on a rigid face over a rigid bottom for
/// `duration` H/c in steps of `step`, with weights of `scheme` (trapezoidal, contour, hat, sampled, load-side,
/// backward-difference of order two, or the trapezoidal ones as exponentials of `tolerance`), cut at
/// `truncation`: growth (largest displacement of the last tenth over that of the first), mass_share W_0/m, frequency.
StudyOutput run_coupled_oscillator(const StudyInput& input);

/// "kernel-march": J0 from M * M = G by `scheme` = first-kind, second-kind or piecewise-constant over `steps` of
/// `step`: kernel_error at the steps' ends; piecewise-constant also kernel_error_in_middle, refused where it has no
/// real root.
StudyOutput run_kernel_march(const StudyInput& input);

/// "long-memory": a sudden constant acceleration of the face over a rigid bottom for `steps` of `step` by the sum of
/// exponentials of `tolerance`: largest error against the sum of the weights in closed form, one after the other, as a
/// share of Σ|w|; its stated_error; megabytes held, numbers a mode.
StudyOutput run_long_memory(const StudyInput& input);

/// "time-step": `steps` steps of `time_step` (or of `duration` / steps) by `integrator` (`spectral_radius`) of a `body`
/// with known motion, then as many of `step_jump` times the length. "oscillator": mass 1, `omega`, Rayleigh `damping`
/// ("stiffness" or "both") with `damping_ratio` at omega; "rod": length and wave speed 1 of `elements`. `drive`: "free"
/// (let go at 1), "force" and "ground" (`amplitude` · sin(`forcing` t)), "pulse" (base moves by exact/oscillator.hpp).
/// Gives displacement and velocity at the end (of the free end), largest_displacement, and of a free motion
/// energy_drift.
StudyOutput run_time_step(const StudyInput& input);

/// "resumed": the scene in one piece against the same in `pieces`, each begun from the checkpoint of the one before
/// (every `checkpoint_every` steps); the first is killed, the second interrupted, and so on: different_values of
/// history and summary, bit for bit; killed; growths of the run in one piece, growths_after and steps_after the last
/// checkpoint.
StudyOutput run_resumed(const StudyInput& input);

/// "contact-history": the faces of one crack under a history of loads, solved warm: difference of the forces from exact
/// contact by another method, largest penetration, restless states.
StudyOutput run_contact_history(const StudyInput& input);

}  // namespace sunder::verification
