#pragma once
/// A static body whose crack faces press on each other where they would penetrate.

#include "solver/contact/contact_solver.hpp"
#include "solver/results/quantity.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/face_compliance.hpp"
#include "solver/simulation/static_solution.hpp"

namespace sunder::simulation {

struct StaticContact {
  FacePairs faces;
  contact::ContactResult contact;
  Eigen::VectorXd force;         ///< (dofs) [N/m]: B λ, what the pairs do to the body
  StaticSolution solution;       ///< under the loads and the pair forces; its reactions and residual count both
  crack::CrackMotion motion;     ///< of the pairs in this solution
  double tolerance = 0.0;        ///< of the penetration [m]
  long long matrix_entries = 0;  ///< of B, X and F

  double penetration() const;  ///< largest, in this solution [m], >= 0
  /// The contact has converged, and its penetration is within the tolerance in the solution itself.
  bool holds() const;
  std::string reason() const;  ///< what does not hold, in words
};

[[nodiscard]] contact::ContactOptions contact_options(const scene::Contact& wanted);

/// `force` (dofs) [N/m]: the loads. Precondition: the equations are ready.
[[nodiscard]] StaticContact solve_with_contact(const scene::Contact& wanted, const Body& body,
                                               const StaticEquations& equations, const Eigen::VectorXd& force);

/// The table `contact` of the summary.
[[nodiscard]] results::Quantity contact_quantity(const StaticContact& solved);

}  // namespace sunder::simulation
