#pragma once
/// The body of a dynamic scene between two growth events: everything that is made once and stepped many times.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "solver/faces/face_step.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/crack_face_loads.hpp"
#include "solver/simulation/polygon_loads.hpp"
#include "solver/simulation/static_loads.hpp"
#include "solver/simulation/step_equations.hpp"

namespace sunder::simulation {

struct DynamicBody {
  Body body;
  sbfem::Formation formation;
  Supports supports{.constraints = Constraints(0), .dofs = {}};
  Eigen::SparseMatrix<double> stiffness, mass;  ///< lower triangles (dofs, dofs)
  Eigen::VectorXd dead_load;                    ///< (dofs) [N/m] weight, standing water, other constant loads
  InteriorLoads interior;                       ///< the part of it that acts inside polygons
  std::vector<CrackFaceLoads> cracks;           ///< one a tip
  Eigen::SparseMatrix<double> loads;            ///< (dofs, m): those of all cracks
  std::vector<Eigen::Index> first_load;         ///< of each crack

  bool cracked() const { return !cracks.empty(); }
};

/// Assembles what was formed. `scene` tells the loads; water in the cracks is not among them. `rock_moves`: the line of
/// the foundation's near field is free, an attached medium holds it. `earlier`: the loads of the body before it grew.
[[nodiscard]] DynamicBody dynamic_body(const scene::Scene& scene, Body body, sbfem::Formation formation,
                                       bool rock_moves, numerics::ThreadPool& pool,
                                       const std::optional<EarlierLoads>& earlier = {});

/// The condensed answer of the body to forces between its faces: `X` (dofs, m) [m²/N] of `loads`, `added_mass` (cracks,
/// m) what a unit force adds to each mouth's pressure.
[[nodiscard]] faces::FaceStructure face_structure(const DynamicBody& body, const Eigen::MatrixXd& X,
                                                  Eigen::MatrixXd mouth,
                                                  std::span<const std::unique_ptr<faces::FaceWater>> waters);

/// For each degree of freedom on a named boundary of `before` that of the same place and side of `after`; -1 elsewhere,
/// and where the boundary has changed.
[[nodiscard]] std::vector<int> same_boundary_dofs(const Body& before, const Body& after);

}  // namespace sunder::simulation
