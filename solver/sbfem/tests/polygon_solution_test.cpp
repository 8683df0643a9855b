#include "solver/sbfem/polygon_solution.hpp"

#include <gtest/gtest.h>

#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/tests/polygons.hpp"

namespace sunder::sbfem {
namespace {

using namespace testing;

constexpr Route routes[] = {Route::ring_doubling, Route::matrix_sign, Route::ordered_schur};
const material::Isotropic concrete{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0};

/// Largest ‖K u - f‖ / ‖f‖ over the four equilibrium polynomials of degree k.
double force_error(const Boundary& polygon, const material::Isotropic& material, const Eigen::MatrixXd& K, int k) {
  double worst = 0.0;
  for (int which = 0; which < 4; ++which) {
    if (k == 1 && which == 1) continue;  // the rotation: no force to compare with
    const Field field = polynomial_field(material, k, which);
    const Eigen::VectorXd f = nodal_forces(polygon, field);
    worst = std::max(worst, (K * nodal_displacement(polygon, field) - f).norm() / f.norm());
  }
  return worst;
}

TEST(PolygonSolution, ReproducesEveryEquilibriumPolynomialUpToItsOrderByAllRoutes) {
  for (const int p : {1, 2, 3, 5, 8}) {
    const Boundary polygon = boundary(irregular_vertices(), p);
    const Coefficients c = coefficients(polygon, concrete);
    for (const Route route : routes) {
      const PolygonSolution solution = solve_polygon(c, route);
      ASSERT_EQ(solution.status, PolygonStatus::converged);
      // ten times the round-off of a healthy polygon, 1e-12
      for (int k = 1; k <= p; ++k) EXPECT_LT(force_error(polygon, concrete, solution.K, k), 1e-11) << p << ' ' << k;
    }
  }
}

TEST(PolygonSolution, RoutesAgree) {
  for (const int p : {1, 2, 4, 8}) {
    for (const bool open : {false, true}) {
      const Boundary polygon =
          open ? boundary(notch_vertices(8, 2.0 * std::numbers::pi), p, true) : boundary(star_vertices(5, 0.4), p);
      const Coefficients c = coefficients(polygon, concrete);
      const PolygonSolution ring = solve_polygon(c);
      for (const Route route : {Route::matrix_sign, Route::ordered_schur}) {
        const PolygonSolution other = solve_polygon(c, route);
        ASSERT_EQ(other.status, PolygonStatus::converged);
        EXPECT_EQ(other.K, other.K.transpose());
        EXPECT_LT((ring.K - other.K).norm(), 1e-11 * ring.K.norm()) << p << ' ' << open;
        EXPECT_LT(other.asymmetry, 1e-10);
      }
      // The modes are the same field: K Vu = Vq and A Vu = -Vu S.
      const ModalSolution all = modes(c);
      ASSERT_EQ(all.status, PolygonStatus::converged);
      EXPECT_LT((ring.K * all.Vu - all.Vq).norm(), 1e-11 * all.Vq.norm());
      EXPECT_LT((ring.A * all.Vu + all.Vu * all.S).norm(), 1e-11 * (all.Vu * all.S).norm());
    }
  }
}

}  // namespace
}  // namespace sunder::sbfem
