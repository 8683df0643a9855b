#pragma once
/// What a static scene prescribes and applies, as constraints and nodal forces of its body.

#include <Eigen/Core>
#include <vector>

#include "solver/sbfem/loads.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/constraints.hpp"

namespace sunder::simulation {

/// Which degrees of freedom each support prescribes; where two supports meet, the later one holds the node.
struct Supports {
  Constraints constraints;
  std::vector<std::vector<int>> dofs;  ///< one list a support of the scene
};

/// A foundation's near field is held where the unbounded rock begins, unless `rock_moves`: a half-plane has no static
/// stiffness against translation (its displacement grows like the logarithm of the distance), so a static answer needs
/// a distance, and the block's is taken. Throws scene::SceneError where a point support has no node, and, unless
/// `may_float`, where a part of the body could still move.
[[nodiscard]] Supports supports_of(const scene::Scene& scene, const Body& body, bool may_float,
                                   bool rock_moves = false);

/// Tractions and pressures on named boundaries, and the standing water of the reservoir (dofs) [N/m].
[[nodiscard]] Eigen::VectorXd boundary_forces(const scene::Scene& scene, const Body& body);

/// Pressure on the crack faces outside the tip polygons, the scene's own or that of resting water (dofs) [N/m].
[[nodiscard]] Eigen::VectorXd crack_face_forces(const scene::Scene& scene, const Body& body);

/// Pressure on the two faces inside the tip polygon of tip `tip` (index in body.polygons.cracks), in powers of ξ; empty
/// where the crack is dry.
[[nodiscard]] std::vector<sbfem::RadialLoad> tip_pressure(const scene::Scene& scene, const Body& body, int tip,
                                                          const sbfem::Boundary& boundary);

/// The crack of the scene to which a tip belongs: an inner crack has two tips, the first one before the last.
[[nodiscard]] int crack_of_tip(const scene::Scene& scene, int tip);

}  // namespace sunder::simulation
