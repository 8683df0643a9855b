#include "solver/sbfem/interior_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/sbfem/tests/area.hpp"

namespace sunder::sbfem {
namespace {

using testing::nodal;
using testing::pentagon;

struct Polygon {
  Boundary boundary;
  material::Isotropic material;
  Coefficients coefficients;
  PolygonSolution solution;
};

Polygon polygon(Boundary boundary, const material::Isotropic& material) {
  Polygon made{std::move(boundary), material, {}, {}};
  made.coefficients = coefficients(made.boundary, material);
  made.solution = solve_polygon(made.coefficients);
  return made;
}

InteriorField field_of(const Polygon& p, const Eigen::VectorXd& u, std::span<const RadialLoad> loads = {}) {
  return InteriorField(p.boundary, p.coefficients, p.solution, p.material, u, loads);
}

Eigen::Vector2d place(const Boundary& boundary, const RayPoint& at) {
  Eigen::Index start = 0;
  for (int e = 0; e < at.edge; ++e) start += boundary.orders[e];
  const Eigen::Vector2d a = boundary.nodes.col(start);
  const Eigen::Vector2d b = boundary.nodes.col((start + boundary.orders[at.edge]) % boundary.nodes.cols());
  return at.xi * ((1.0 - at.position) * a + at.position * b);
}

struct PatchCase {
  const char* description;
  double poisson_ratio;
  material::Plane plane;
  double displacement_bar, stress_bar;  // relative to the largest on the boundary
};

TEST(InteriorField, ReproducesEveryEquilibriumPolynomialUpToItsOrder) {
  // Round-off of a double route grows by λ/μ = 2ν/(1 - 2ν), which is 5e3 at ν = .4999, and once more for stresses.
  const PatchCase cases[] = {{"plane strain", 0.2, material::Plane::strain, 1e-11, 1e-10},
                             {"plane stress", 0.3, material::Plane::stress, 1e-11, 1e-10},
                             {"nearly incompressible", 0.4999, material::Plane::strain, 1e-9, 1e-6}};
  for (const PatchCase& c : cases) {
    const material::Isotropic solid{.youngs_modulus = 2.5, .poisson_ratio = c.poisson_ratio, .plane = c.plane};
    for (const int order : {1, 2, 3, 5}) {
      const Polygon p = polygon(testing::boundary(pentagon(), order), solid);
      for (int degree = 1; degree <= order; ++degree) {
        for (int which = 0; which < 4; ++which) {
          const testing::Field exact = testing::polynomial_field(solid, degree, which);
          const InteriorField field = field_of(p, testing::nodal_displacement(p.boundary, exact));
          const double u_scale = exact.displacement({1.0, 1.0}).norm();
          const double s_scale = solid.youngs_modulus * u_scale;  // the polygon measures one metre
          for (const double xi : {1.0, 0.6, 1e-3, 1e-9, 0.0}) {
            const InteriorField::Ring ring = field.ring(xi);
            for (int edge = 0; edge < 5; ++edge) {
              const Eigen::Vector2d x = place(p.boundary, {.edge = edge, .position = 0.3, .xi = xi});
              EXPECT_LE((field.displacement(ring, edge, 0.3) - exact.displacement(x)).norm(),
                        c.displacement_bar * u_scale)
                  << c.description << ", order " << order << ", degree " << degree << ", xi " << xi;
              EXPECT_LE((field.stress(ring, edge, 0.3) - exact.stress(x)).norm(), c.stress_bar * s_scale)
                  << c.description << ", order " << order << ", degree " << degree << ", xi " << xi;
            }
          }
        }
      }
    }
  }
}

TEST(InteriorField, IsNotMovedByRigidMotion) {
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const Polygon p = polygon(testing::boundary(pentagon(), 2), solid);
  const auto rigid = [](const Eigen::Vector2d& x) { return Eigen::Vector2d(3.0 - 0.7 * x.y(), -2.0 + 0.7 * x.x()); };
  const InteriorField field = field_of(p, nodal(p.boundary, rigid));
  for (const double xi : {1.0, 0.5, 1e-12, 0.0}) {
    const RayPoint at{.edge = 2, .position = 0.8, .xi = xi};
    EXPECT_LE((field.displacement(at) - rigid(place(p.boundary, at))).norm(), 1e-12);
    EXPECT_LE(field.stress(at).norm(), 1e-12);
  }
  EXPECT_NEAR(field.strain_energy(), 0.0, 1e-12);
}

/// A column that carries its own weight γ downwards: σ_yy = γ y, exactly quadratic displacements for any ν.
struct OwnWeight {
  material::Isotropic solid;
  double gamma = 0.8;
  Eigen::Vector2d displacement(const Eigen::Vector2d& x) const {
    const double E = material::effective_modulus(solid);
    const double nu = solid.plane == material::Plane::strain ? solid.poisson_ratio / (1.0 - solid.poisson_ratio)
                                                             : solid.poisson_ratio;
    return gamma / E * Eigen::Vector2d(-nu * x.x() * x.y(), 0.5 * (x.y() * x.y() + nu * x.x() * x.x()));
  }
};

TEST(InteriorField, CarriesOwnWeightExactlyFromOrderTwo) {
  for (const auto plane : {material::Plane::strain, material::Plane::stress}) {
    const OwnWeight exact{.solid = {.youngs_modulus = 2.0, .poisson_ratio = 0.25, .plane = plane}};
    for (const int order : {2, 3, 6}) {
      const Polygon p = polygon(testing::boundary(pentagon(), order), exact.solid);
      const RadialLoad weight = body_force(p.boundary, {0.0, -exact.gamma});
      const Eigen::VectorXd u = nodal(p.boundary, [&](const Eigen::Vector2d& x) { return exact.displacement(x); });
      const InteriorField field = field_of(p, u, std::span(&weight, 1));
      // s = 2 is an exponent of the polygon here: the singular but consistent case.
      EXPECT_LE(field.particular()[0].residual, 1e-12) << "order " << order;
      for (const double xi : {1.0, 0.4, 1e-6, 0.0}) {
        const RayPoint at{.edge = 3, .position = 0.6, .xi = xi};
        const Eigen::Vector2d x = place(p.boundary, at);
        EXPECT_LE((field.displacement(at) - exact.displacement(x)).norm(), 1e-12) << "order " << order << ", xi " << xi;
        EXPECT_LE((field.stress(at) - Eigen::Vector3d(0.0, exact.gamma * x.y(), 0.0)).norm(), 1e-11)
            << "order " << order << ", xi " << xi;
      }
      // ½ ∫ σ_yy² / E' dA
      const double energy = testing::integral(pentagon(), [&](const Eigen::Vector2d& x) {
        return 0.5 * std::pow(exact.gamma * x.y(), 2) / material::effective_modulus(exact.solid);
      });
      EXPECT_NEAR(field.strain_energy(), energy, 1e-12);
      // The boundary is held by K u - f, which are the tractions of σ_yy = γ y.
      Eigen::VectorXd tractions = Eigen::VectorXd::Zero(u.size());
      for (int edge = 0; edge < 5; ++edge) {
        const Eigen::Vector2d a = pentagon()[edge], b = pentagon()[(edge + 1) % 5];
        const Eigen::Vector2d normal = Eigen::Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
        Eigen::Matrix2Xd t = Eigen::Matrix2Xd::Zero(2, 2);
        t(1, 0) = exact.gamma * a.y() * normal.y();
        t(1, 1) = exact.gamma * (b.y() - a.y()) * normal.y();
        tractions += edge_traction(p.boundary, edge, t);
      }
      EXPECT_LE((p.solution.K * u - load_vector(p.solution, weight) - tractions).norm(), 1e-12) << "order " << order;
    }
  }
}

TEST(ParticularSolution, CarriesItsLoadWithTheForcesOfTheLoadVector) {
  // u = ξ^s d with boundary forces (s E0 + E1ᵀ) d must need the same nodal load: K d - f = (s E0 + E1ᵀ) d.
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const std::vector<Eigen::Vector2d> crack{{-1, 0}, {-1, -1}, {1.2, -1}, {1.2, 0.9}, {-1, 0.9}, {-1, 0}};
  for (const int order : {1, 2, 4}) {
    const Polygon p = polygon(testing::boundary(crack, order, true), solid);
    const double pressure[] = {1.0, -0.5, 2.0, 0.3};
    for (const RadialLoad& load : crack_face_pressure(p.boundary, pressure)) {
      const ParticularSolution part = particular_solution(p.coefficients, p.solution, load);
      const double s = load.power + 1.0;
      EXPECT_LE(part.residual, 1e-12) << "order " << order << ", power " << load.power;
      const Eigen::VectorXd forces = s * p.coefficients.E0 * part.d + p.coefficients.E1.transpose() * part.d;
      const Eigen::VectorXd needed = p.solution.K * part.d - load_vector(p.solution, load);
      EXPECT_LE((forces - needed).norm(), 1e-11 * (forces.norm() + needed.norm() + 1.0));
    }
  }
}

TEST(ParticularSolution, OfUniformFacePressureIsThatPressureEverywhere) {
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const std::vector<Eigen::Vector2d> crack{{-1, 0}, {-1, -1}, {1.2, -1}, {1.2, 0.9}, {-1, 0.9}, {-1, 0}};
  const Polygon p = polygon(testing::boundary(crack, 2, true), solid);
  const double pressure[] = {4.0};
  const std::vector<RadialLoad> loads = crack_face_pressure(p.boundary, pressure);
  // σ = -p I satisfies both faces; on the boundary its displacement is linear, so the homogeneous part is what is left.
  const double contraction = -4.0 * (1.0 + 0.3) * (1.0 - 2.0 * 0.3);
  const InteriorField field =
      field_of(p, nodal(p.boundary, [&](const Eigen::Vector2d& x) { return Eigen::Vector2d(contraction * x); }), loads);
  for (const double xi : {1.0, 0.3, 1e-8}) {
    EXPECT_LE((field.stress({.edge = 1, .position = 0.5, .xi = xi}) - Eigen::Vector3d(-4.0, -4.0, 0.0)).norm(), 1e-10);
  }
}

TEST(InteriorField, IsItsOwnContinuationAtDefectiveExponents) {
  // In a notch of 257.4534° of solid an exponent 1 meets the rotation in a Jordan block. ξ^A obeys
  // ξ₁^A ξ₂^A = (ξ₁ ξ₂)^A, whatever the exponents are.
  const std::vector<Eigen::Vector2d> corners = testing::notch_vertices(8, 257.4534 * std::numbers::pi / 180.0);
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const Polygon p = polygon(testing::boundary(corners, 4, true), solid);
  const Eigen::VectorXd u = nodal(
      p.boundary, [](const Eigen::Vector2d& x) { return Eigen::Vector2d(std::sin(3.0 * x.y()), std::exp(x.x())); });
  const InteriorField::Ring half_way = field_of(p, u).ring(0.5);
  const InteriorField::Ring quarter = field_of(p, u).ring(0.25), again = field_of(p, half_way.displacement).ring(0.5);
  EXPECT_LE((quarter.displacement - again.displacement).norm(), 1e-12 * u.norm());
  EXPECT_LE((0.5 * again.slope - 0.25 * quarter.slope).norm(), 1e-11 * u.norm());
}

TEST(InteriorField, SaysThatStressAtACrackTipIsNotANumber) {
  const std::vector<Eigen::Vector2d> crack{{-1, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const Polygon p = polygon(testing::boundary(crack, 2, true), solid);
  const Eigen::VectorXd u =
      nodal(p.boundary, [](const Eigen::Vector2d& x) { return Eigen::Vector2d(x.y() * x.y(), 1.0); });
  const InteriorField field = field_of(p, u);
  EXPECT_TRUE(std::isnan(field.stress({.edge = 1, .position = 0.5, .xi = 0.0}).norm()));
  EXPECT_TRUE(field.displacement({.edge = 1, .position = 0.5, .xi = 0.0}).allFinite());
  EXPECT_TRUE(field.stress({.edge = 1, .position = 0.5, .xi = 1e-200}).allFinite());
}

TEST(InteriorField, RefusesArgumentsOutOfRange) {
  const material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};
  const Polygon p = polygon(testing::boundary(pentagon(), 1), solid);
  EXPECT_THROW(field_of(p, Eigen::VectorXd::Zero(8)), std::invalid_argument);
  EXPECT_THROW((void)field_of(p, Eigen::VectorXd::Zero(10)).ring(1.5), std::invalid_argument);
  EXPECT_THROW((void)field_of(p, Eigen::VectorXd::Zero(10)).ring(std::nan("")), std::invalid_argument);
}

TEST(Locate, FindsTheRayThroughAPoint) {
  const Boundary boundary = testing::boundary(pentagon(), 3);
  for (int edge = 0; edge < 5; ++edge) {
    for (const double s : {0.0, 0.2, 0.9}) {
      for (const double xi : {1e-9, 0.4, 1.0}) {
        const Eigen::Vector2d point = place(boundary, {.edge = edge, .position = s, .xi = xi});
        const auto found = locate(boundary, point);
        ASSERT_TRUE(found.has_value());
        EXPECT_LE((place(boundary, *found) - point).norm(), 1e-15);
      }
    }
  }
  EXPECT_EQ(locate(boundary, {0.0, 0.0})->xi, 0.0);
  EXPECT_FALSE(locate(boundary, {2.0, 0.0}).has_value());
  EXPECT_FALSE(locate(boundary, 1.0001 * pentagon()[1]).has_value());
}

TEST(Locate, TellsTheTwoFacesOfACrackApart) {
  const std::vector<Eigen::Vector2d> crack{{-1, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  const Boundary boundary = testing::boundary(crack, 1, true);
  EXPECT_EQ(locate(boundary, {-0.5, -1e-3})->edge, 0);
  EXPECT_EQ(locate(boundary, {-0.5, 1e-3})->edge, 4);
}

}  // namespace
}  // namespace sunder::sbfem
