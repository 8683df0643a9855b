#include "solver/sbfem/mean_strain.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "solver/sbfem/interior_field.hpp"
#include "solver/sbfem/tests/area.hpp"

namespace sunder::sbfem {
namespace {

const material::Isotropic solid{.youngs_modulus = 2.5, .poisson_ratio = 0.3};

/// A crack polygon without symmetry whose faces lie on the negative x axis.
std::vector<Eigen::Vector2d> crack() {
  return {{-1, 0}, {-1, -1}, {1.2, -0.7}, {1.1, 0.9}, {-1, 0.8}, {-1, 0}};
}

struct Tip {
  Boundary boundary;
  Coefficients coefficients;
  PolygonSolution solution;
};

Tip tip(int order) {
  Tip made{.boundary = testing::boundary(crack(), order, true), .coefficients = {}, .solution = {}};
  made.coefficients = coefficients(made.boundary, solid);
  made.solution = solve_polygon(made.coefficients);
  return made;
}

TEST(MeanStrain, IsThatOfEveryEquilibriumPolynomialUpToTheOrder) {
  const double area = testing::integral(testing::pentagon(), [](const Eigen::Vector2d&) { return 1.0; });
  for (const int order : {1, 2, 3, 5}) {
    const Boundary boundary = testing::boundary(testing::pentagon(), order);
    for (int degree = 1; degree <= order; ++degree) {
      for (int which = 0; which < 4; ++which) {
        const testing::Field exact = testing::polynomial_field(solid, degree, which);
        const Eigen::Vector3d stress =
            material::elasticity_matrix(solid) * mean_strain(boundary) * testing::nodal_displacement(boundary, exact);
        for (int component = 0; component < 3; ++component) {
          const double mean = testing::integral(testing::pentagon(),
                                                [&](const Eigen::Vector2d& x) { return exact.stress(x)[component]; }) /
                              area;
          EXPECT_NEAR(stress[component], mean, 1e-13 * 10.0 * solid.youngs_modulus)  // a few sums of round-off
              << "order " << order << ", degree " << degree << ", field " << which;
        }
      }
    }
  }
}

TEST(TipField, OfAUniformStressAlongTheFacesIsThatStress) {
  for (const int order : {1, 2, 4}) {
    const Tip p = tip(order);
    const TipField field = tip_field(p.boundary, p.coefficients, p.solution);
    // σ_xx = 1 leaves both faces free of traction; moved by (3, -2) and turned by 0.7.
    const Eigen::Matrix3d compliance = material::elasticity_matrix(solid).inverse();
    const Eigen::Vector3d strain = compliance.col(0);
    const Eigen::VectorXd u = testing::nodal(p.boundary, [&](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(3.0 + strain[0] * x.x() - 0.7 * x.y(), -2.0 + strain[1] * x.y() + 0.7 * x.x());
    });
    EXPECT_LE((field.mean_strain * u - strain).norm(), 1e-12) << "order " << order;
    EXPECT_LE((field.tip * u - Eigen::Vector2d(3.0, -2.0)).norm(), 1e-12) << "order " << order;
  }
}

TEST(TipField, OfUniformFacePressureIsThatPressure) {
  const Tip p = tip(2);
  const double pressure[] = {4.0};
  const TipField field = tip_field(p.boundary, p.coefficients, p.solution, crack_face_pressure(p.boundary, pressure));
  // σ = -p I satisfies both faces, with a linear displacement that leaves the tip where it is.
  const Eigen::Vector3d strain = material::elasticity_matrix(solid).inverse() * Eigen::Vector3d(-4.0, -4.0, 0.0);
  const Eigen::VectorXd u =
      testing::nodal(p.boundary, [&](const Eigen::Vector2d& x) { return Eigen::Vector2d(strain[0] * x); });
  EXPECT_LE((field.mean_strain * u + field.mean_strain_of_loads - strain).norm(), 1e-11);
  EXPECT_LE((field.tip * u + field.tip_of_loads).norm(), 1e-11);
}

// By virtual work with a linear displacement v = E x, A σ̄ : E = v_bᵀ (K u_b - Σ f_k + Σ p_k / (k + 2)): the same mean
// from the stiffness, whatever the field is, and without the closed loop.
TEST(TipField, IsWhatVirtualWorkSaysAlsoWithWeightAndPressure) {
  for (const int order : {1, 2, 4}) {
    const Tip p = tip(order);
    const Eigen::VectorXd u = testing::nodal(p.boundary, [](const Eigen::Vector2d& x) {
      return Eigen::Vector2d(std::sin(3.0 * x.y()) + x.x(), std::exp(x.x()) * (x.y() > 0.0 ? 1.0 : -1.0));
    });
    const double pressure[] = {1.0, -0.5};
    std::vector<RadialLoad> loads = crack_face_pressure(p.boundary, pressure);
    loads.push_back(body_force(p.boundary, {0.3, -0.8}));
    for (const bool loaded : {false, true}) {
      const std::span<const RadialLoad> carried = loaded ? std::span<const RadialLoad>(loads) : std::span<RadialLoad>();
      const TipField field = tip_field(p.boundary, p.coefficients, p.solution, carried);
      Eigen::VectorXd forces = p.solution.K * u;
      for (const RadialLoad& load : carried) {
        forces += load.density / (load.power + 2.0) - load_vector(p.solution, load);
      }
      double area = 0.0;
      for (std::size_t i = 0; i + 1 < crack().size(); ++i) {
        area += 0.5 * (crack()[i].x() * crack()[i + 1].y() - crack()[i].y() * crack()[i + 1].x());
      }
      const Eigen::Matrix2d moment = p.boundary.nodes * forces.reshaped(2, forces.size() / 2).transpose() / area;
      const Eigen::Vector3d stress =
          material::elasticity_matrix(solid) * (field.mean_strain * u + field.mean_strain_of_loads);
      EXPECT_LE((stress - Eigen::Vector3d(moment(0, 0), moment(1, 1), moment(0, 1))).norm(), 1e-10 * stress.norm())
          << "order " << order;
      EXPECT_NEAR(moment(0, 1), moment(1, 0), 1e-10 * stress.norm()) << "the moments are in equilibrium";

      const InteriorField interior(p.boundary, p.coefficients, p.solution, solid, u, carried);
      const Eigen::Vector2d at_tip = interior.displacement({.edge = 1, .position = 0.5, .xi = 0.0});
      EXPECT_LE((field.tip * u + field.tip_of_loads - at_tip).norm(), 1e-11 * u.norm()) << "order " << order;
    }
  }
}

TEST(TipField, IsOfOpenPolygonsOnlyAndTheMeanOfClosedOnes) {
  const Tip p = tip(1);
  EXPECT_THROW(static_cast<void>(mean_strain(p.boundary)), std::invalid_argument);
  const Boundary closed = testing::boundary(testing::pentagon(), 1);
  EXPECT_THROW(static_cast<void>(tip_field(closed, p.coefficients, p.solution)), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::sbfem
