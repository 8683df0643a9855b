#pragma once
/// The radial loads of each polygon of a static scene: weight, and pressure on the faces inside a tip polygon.

#include <Eigen/Core>
#include <vector>

#include "solver/numerics/thread_pool.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

/// Of polygon `index`, whose boundary is `boundary`; empty where nothing acts inside.
[[nodiscard]] std::vector<sbfem::RadialLoad> polygon_loads(const scene::Scene& scene, const Body& body, int index,
                                                           const sbfem::Boundary& boundary);

/// What the radial loads of all polygons do together.
struct InteriorLoads {
  Eigen::VectorXd force;        ///< (dofs) [N/m]
  double energy = 0.0;          ///< elastic energy of the fields that they cause with resting boundaries [J/m]
  long long polygons = 0;       ///< how many polygons carry such loads
  double worst_residual = 0.0;  ///< of their particular solutions
};

/// Only polygons that carry a load are touched. `formation`: of the body's polygons.
[[nodiscard]] InteriorLoads interior_loads(const scene::Scene& scene, const Body& body,
                                           const sbfem::Formation& formation, numerics::ThreadPool& pool);

}  // namespace sunder::simulation
