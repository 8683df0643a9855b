#pragma once
/// The line of a body at which the unbounded rock of its foundation begins.

#include <Eigen/Core>
#include <vector>

#include "solver/foundation/unbounded_domain.hpp"
#include "solver/sbfem/coefficients.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

struct FoundationLine {
  sbfem::Boundary boundary;  ///< from the upper left corner to the upper right one, about the middle of its ends [m]
  std::vector<int> dofs;     ///< (2 nodes) of the body: 2·node + component, in the order of the boundary's nodes
};

/// The line of mesh::block_interface. The body must have a near field (assert).
[[nodiscard]] FoundationLine foundation_line(const Body& body);

/// The rock beyond it; material::Isotropic with density > 0, else std::invalid_argument.
[[nodiscard]] foundation::UnboundedDomain rock_beyond(const FoundationLine& line, const material::Isotropic& rock);

}  // namespace sunder::simulation
