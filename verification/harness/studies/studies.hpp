#pragma once
/// The studies, one source file each. A new one is declared here and listed in studies.cpp.

#include "verification/harness/study.hpp"

namespace sunder::verification {

/// "scene": reads the scene with the setting's keys in place, runs it, and hands on its summary.
StudyOutput run_scene(const StudyInput& input);

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

/// "time-step": `steps` steps of `time_step` (or of `duration` / steps) by `integrator` (`spectral_radius`) of a `body`
/// with known motion, then as many of `step_jump` times the length. "oscillator": mass 1, `omega`, Rayleigh `damping`
/// ("stiffness" or "both") with `damping_ratio` at omega; "rod": length and wave speed 1 of `elements`. `drive`: "free"
/// (let go at 1), "force" and "ground" (`amplitude` · sin(`forcing` t)), "pulse" (base moves by exact/oscillator.hpp).
/// Gives displacement and velocity at the end (of the free end), largest_displacement, and of a free motion
/// energy_drift.
StudyOutput run_time_step(const StudyInput& input);

/// "contact-history": the faces of one crack under a history of loads, solved warm: difference of the forces from exact
/// contact by another method, largest penetration, restless states.
StudyOutput run_contact_history(const StudyInput& input);

}  // namespace sunder::verification
