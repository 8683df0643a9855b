#pragma once
/// The parts of a scene around the dam and in time: reservoir, foundation, ground motion, time integration, the
/// response of an unbounded domain alone, and the field output. All numbers SI.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sunder::scene {

enum class ReservoirModel { hydrostatic, westergaard, incompressible, compressible };

struct Reservoir {
  std::string boundary;                  ///< wet face; empty where `depth` is given
  std::optional<double> level;           ///< y of the free surface [m]
  std::optional<double> depth;           ///< [m], > 0: analysis = "response", instead of boundary and level
  double density = 1000.0;               ///< [kg/m³], > 0
  double sound_speed = 1440.0;           ///< [m/s], > 0
  double reflection_coefficient = 0.75;  ///< α of the bottom [-], 0 … 1 (rigid)
  ReservoirModel model = ReservoirModel::compressible;
  double memory_tolerance = 0.0;  ///< of the water's memory, 0 … 0.1 of its kernel's sum; 0: the exact convolution
};

enum class FoundationShape {
  strip,  ///< rigid strip on the half-plane
  disc,   ///< rigid disc in the full plane
};

/// The polygons of rock between the dam's base and the unbounded rock: a block below level ground.
struct NearField {
  std::optional<double> width;  ///< beside the base on either side [m], > 0; absent: a quarter of the base's length
  std::optional<double> depth;  ///< [m], > 0; absent: a quarter of the base's length
  std::optional<double> size;   ///< of its polygons away from the base [m], > 0; absent: an eighth of that length
};

struct Foundation {
  std::string boundary;              ///< level, under the whole body; empty where analysis = "response"
  double youngs_modulus;             ///< [Pa], > 0
  double poisson_ratio;              ///< [-], >= 0, < 0.5
  double density;                    ///< [kg/m³], >= 0; 0: massless
  std::optional<double> half_width;  ///< of the strip, or radius of the disc [m], > 0: analysis = "response"
  FoundationShape shape = FoundationShape::strip;
  std::optional<NearField> near_field;
};

enum class Baseline {
  none,      ///< the record as it stands
  parabola,  ///< less the parabola in time that leaves the ground's velocity smallest (dynamics/ground_motion.hpp)
};

struct GroundMotion {
  std::filesystem::path horizontal;               ///< table of time [s] and acceleration [m/s²]
  std::optional<std::filesystem::path> vertical;  ///< likewise
  double horizontal_scale = 1.0;                  ///< [-]; -1 reverses the component
  double vertical_scale = 1.0;                    ///< [-]
  Baseline baseline = Baseline::none;             ///< of both components
};

enum class Integrator { newmark, hht_alpha, generalised_alpha };

struct Dynamics {
  double time_step;  ///< [s], > 0
  double duration;   ///< [s], > 0
  Integrator integrator = Integrator::newmark;
  std::optional<double> spectral_radius;  ///< at infinite frequency [-]; alpha integrators only: 0 … 1, hht-alpha ½ … 1
  double damping_ratio = 0.05;            ///< Rayleigh damping at both `damping_modes` [-], >= 0, < 1
  std::array<int, 2> damping_modes{1, 2};  ///< counted from 1, ascending; twice the same: β K alone, matched there
};

struct Response {
  std::vector<double> frequencies;   ///< [rad/s], >= 0
  std::vector<double> times;         ///< [s], >= 0
  std::optional<int> face_elements;  ///< >= 1; absent: the analytic path where there is one
  int face_order = 2;                ///< 1 … 64
};

struct Output {
  int fields_every = 0;               ///< steps between field snapshots; 0: none
  std::vector<double> profile_times;  ///< [s]: the water's pressure along the cracks at these, analysis = "dynamic"
  int checkpoint_every = 0;           ///< steps between checkpoints of a dynamic run; 0: none
};

}  // namespace sunder::scene
