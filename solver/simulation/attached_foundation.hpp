#pragma once
/// The unbounded rock of the scene's [foundation] in a dynamic run: what resists the near field's line, and what a
/// vertically rising wave does to it.
///
/// The run's unknowns w are relative to the rigid motion of the ground's free surface, u = w + r u_g. The rock answers
/// to the difference from its free field, u - u_ff, and its free field pulls with t_ff on the line:
///     force on the body = -W * (ẅ + k) + t_ff,   k = r a_g - ü_ff.
/// W * ẅ is the attached medium, driven by the relative acceleration; -W * k + t_ff is known beforehand: `load`. As the
/// rock stiffens, k → 0 and what is left is the dam on a shaken rigid base.

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "solver/foundation/free_field.hpp"
#include "solver/simulation/attached_medium.hpp"

namespace sunder::simulation {

/// The wave that rises to the surface, as seen by the body.
struct RisingWave {
  int delay = 0;             ///< steps by which the surface's record is late: the wave starts below
  std::vector<int> dofs;     ///< (n) of the body, ascending
  Eigen::MatrixXd load;      ///< (n, steps + 1) [N/m] at the end of each step, step 0 is the start
  Eigen::Matrix2Xd surface;  ///< (2, steps + 1) acceleration of the free surface in x and y [m/s²]
};

/// The record as the surface shows it, sampled at equal steps; empty: no motion in this direction.
struct SurfaceMotion {
  std::vector<double> horizontal = {}, vertical = {};  ///< [m/s²]
  double step = 0.0;                                   ///< [s], > 0
};

struct AttachedFoundation {
  std::unique_ptr<AttachedMedium> medium;  ///< nullptr where the rock has no density: then its near field is held
  RisingWave wave;                         ///< of `medium`; load and surface are zero where the motion is empty
  std::string failure;                     ///< what stopped the response of the rock; empty where nothing did
};

/// Weights come from `cache` where it has them (a folder; empty: none) and are left there; a file that cannot be used
/// is replaced, with a warning in the medium.
[[nodiscard]] AttachedFoundation attach_foundation(const Body& body, const SurfaceMotion& motion, const StepPlan& plan,
                                                   const std::filesystem::path& cache, numerics::ThreadPool& pool,
                                                   Ledger& ledger);

}  // namespace sunder::simulation
