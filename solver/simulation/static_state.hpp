#pragma once
/// A body in equilibrium under the loads of its scene, and what the summary says of it.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <string>

#include "solver/numerics/thread_pool.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/ledger.hpp"
#include "solver/simulation/polygon_loads.hpp"
#include "solver/simulation/static_contact.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/static_solution.hpp"

namespace sunder::simulation {

struct StaticState {
  Eigen::SparseMatrix<double> stiffness;  ///< (dofs, dofs), lower triangle
  Eigen::VectorXd force;                  ///< (dofs) [N/m]
  InteriorLoads interior;
  std::optional<StaticContact> contact;  ///< where the scene has [contact]
  StaticSolution solution;               ///< its status says whether the numbers came out

  double strain_energy() const;  ///< [J/m]
  /// Strain energy less the work of the loads [J/m]: its decrease over growth is what the growth has released.
  double potential_energy() const;
};

/// `formation`: of the body's polygons; `earlier`: loads of the body before a growth.
[[nodiscard]] StaticState static_state(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                                       const Supports& supports, numerics::ThreadPool& pool, Ledger& ledger,
                                       const std::optional<EarlierLoads>& earlier = {});

/// "stopped: …" where the equations could not be solved.
[[nodiscard]] std::string stopping_reason(const Body& body, const StaticSolution& solution);

/// Energy, displacements, reactions and, where there are cracks, tips and openings. May set the status.
void add_static_quantities(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                           const Supports& supports, const StaticState& state, Ledger& ledger,
                           results::RunSummary& summary);

}  // namespace sunder::simulation
