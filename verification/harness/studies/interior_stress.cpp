#include "verification/harness/studies/interior_stress.hpp"

#include <cmath>

#include "solver/sbfem/interior_field.hpp"

namespace sunder::verification {

void StressDifference::include(const StressDifference& other) {
  difference = std::fmax(difference, other.difference);
  exact = std::fmax(exact, other.exact);
}

StressDifference interior_stress_difference(const sbfem::Boundary& boundary, const sbfem::Coefficients& coefficients,
                                            const sbfem::PolygonSolution& solution, const Eigen::VectorXd& displacement,
                                            const material::Isotropic& material, const Eigen::Vector2d& centre,
                                            const PlacedField& field) {
  const sbfem::InteriorField inside(boundary, coefficients, solution, material, displacement);
  StressDifference worst;
  for (const double xi : {0.35, 0.9}) {
    const auto ring = inside.ring(xi);
    Eigen::Index start = 0;
    for (std::size_t e = 0; e < boundary.orders.size(); ++e) {
      const Eigen::Vector2d a = boundary.nodes.col(start);
      start += boundary.orders[e];
      const Eigen::Vector2d b = boundary.nodes.col(start % boundary.nodes.cols());
      for (const double s : {0.2, 0.7}) {
        const Eigen::Vector3d exact = stress(field, centre + xi * ((1.0 - s) * a + s * b));
        const Eigen::Vector3d found = inside.stress(ring, static_cast<int>(e), s);
        worst.include({(found - exact).lpNorm<Eigen::Infinity>(), exact.lpNorm<Eigen::Infinity>()});
      }
    }
  }
  return worst;
}

}  // namespace sunder::verification
