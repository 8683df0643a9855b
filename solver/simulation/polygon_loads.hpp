#pragma once
/// The radial loads of each polygon of a static scene: weight, and pressure on the faces inside a tip polygon.

#include <Eigen/Core>
#include <optional>
#include <span>
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

/// What the radial loads of one polygon do.
struct PolygonShare {
  Eigen::VectorXd force = {};  ///< (2n) [N/m]; empty where nothing acts inside
  double energy = 0.0;         ///< elastic energy of the fields that they cause with a resting boundary [J/m]
  double residual = 0.0;       ///< of their particular solutions
};

/// What the radial loads of all polygons do together.
struct InteriorLoads {
  Eigen::VectorXd force;             ///< (dofs) [N/m]
  double energy = 0.0;               ///< elastic energy of the fields that they cause with resting boundaries [J/m]
  long long polygons = 0;            ///< how many polygons carry such loads
  double worst_residual = 0.0;       ///< of their particular solutions
  std::vector<PolygonShare> shares;  ///< (polygons)
};

/// Loads of an earlier body, of which polygon i of the present one is polygon same[i], -1: of none. The loads on it
/// must be the same too: weight, or pressure on the faces of a crack that has not grown.
struct EarlierLoads {
  const InteriorLoads& loads;
  std::span<const int> same;
};

enum class LoadDetail {
  forces,  ///< no energies and residuals: they ask for the fields inside the polygons
  with_energies,
};

/// Only polygons that carry a load are touched. `formation`: of the body's polygons.
[[nodiscard]] InteriorLoads interior_loads(const scene::Scene& scene, const Body& body,
                                           const sbfem::Formation& formation, numerics::ThreadPool& pool,
                                           const std::optional<EarlierLoads>& earlier = {},
                                           LoadDetail detail = LoadDetail::with_energies);

}  // namespace sunder::simulation
