#pragma once
/// The stress inside one polygon against that of an exact field.

#include "solver/sbfem/polygon_solution.hpp"
#include "verification/harness/studies/exact_fields.hpp"

namespace sunder::verification {

struct StressDifference {
  double difference = 0.0;  ///< largest entry of σ_found - σ_exact [Pa]
  double exact = 0.0;       ///< largest entry of σ_exact [Pa]

  void include(const StressDifference& other);
};

/// At four points of every edge's sector, from the displacements of the boundary's nodes (2n) [m]. The field lies in
/// the coordinates in which the scaling centre is at `centre` [m].
StressDifference interior_stress_difference(const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
                                            const sbfem::PolygonSolution& solution, const Eigen::VectorXd& displacement,
                                            const material::Isotropic& material, const Eigen::Vector2d& centre,
                                            const PlacedField& field);

}  // namespace sunder::verification
