/// What round-off does to a polygon at the ends of its range: slivers, short edges, a centre near an edge, near
/// incompressibility, high order, unfortunate units, NaN.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/polygon_solution.hpp"
#include "solver/sbfem/tests/polygons.hpp"

namespace sunder::sbfem {
namespace {

using namespace testing;
using Eigen::MatrixXd;

struct PatchError {
  double force = 0.0;     ///< largest ‖K u - f‖ / ‖f‖ over all equilibrium polynomials up to the order
  double backward = 0.0;  ///< largest ‖K u - f‖ / (‖K‖ ‖u‖)
};

PatchError patch_error(const Boundary& polygon, const material::Isotropic& material, const MatrixXd& K, int order) {
  PatchError worst;
  for (int k = 1; k <= order; ++k) {
    for (int which = 0; which < 4; ++which) {
      if (k == 1 && which == 1) continue;  // the rotation has no force to compare with
      const Field field = polynomial_field(material, k, which);
      const Eigen::VectorXd u = nodal_displacement(polygon, field), f = nodal_forces(polygon, field);
      const double residual = (K * u - f).norm();
      worst.force = std::max(worst.force, residual / f.norm());
      worst.backward = std::max(worst.backward, residual / (K.norm() * u.norm()));
    }
  }
  return worst;
}

std::vector<Eigen::Vector2d> with_short_edge(double length) {
  std::vector<Eigen::Vector2d> vertices = rectangle_vertices(1.6, 1.2);
  vertices.insert(vertices.begin() + 2, Eigen::Vector2d(0.8, 0.6 - length));
  return vertices;
}

std::vector<Eigen::Vector2d> centre_above_lower_edge(double distance) {
  std::vector<Eigen::Vector2d> vertices = rectangle_vertices(1.6, 1.2);
  for (Eigen::Vector2d& vertex : vertices) vertex.y() += 0.6 - distance;
  return vertices;
}

struct Extreme {
  const char* description;
  std::vector<Eigen::Vector2d> vertices;
  double poisson_ratio;
  std::vector<int> orders;
  double force_bar, backward_bar;
};

// Force bars: 1e-10 and 1e-6 at slivers 1:100 and 1:1e4 are the project's acceptance bars. Elsewhere round-off is at
// best ε λ_max (slivers, short edges: λ_max grows as the ratio), ε / distance² in K (centre near an edge: J_b in E0 and
// 1 / J_b in E2) or ε / (1 - 2ν)·(1 … 100) (the modulus ratio), and the bar leaves another factor of about 10.
const Extreme extremes[] = {
    {"sliver 1:100", rectangle_vertices(1.0, 1e-2), 0.2, {1, 2, 4}, 1e-11, 1e-13},
    {"sliver 1:1e4", rectangle_vertices(1.0, 1e-4), 0.2, {1, 2, 4}, 1e-9, 1e-13},
    {"sliver 1:1e6", rectangle_vertices(1.0, 1e-6), 0.2, {1, 2, 4}, 1e-7, 1e-13},
    {"short edge 1e-4", with_short_edge(1e-4), 0.2, {1, 2, 4}, 1e-9, 1e-11},
    {"short edge 1e-8", with_short_edge(1e-8), 0.2, {1, 2, 4}, 1e-5, 1e-9},
    {"centre at 1e-6 of an edge", centre_above_lower_edge(1e-6), 0.2, {1, 2, 4}, 1e-8, 1e-9},
    {"concave star with 16 points", star_vertices(16, 0.15), 0.2, {1, 2, 4}, 2e-12, 1e-14},
    {"nu = 0", irregular_vertices(), 0.0, {1, 2, 5}, 1e-12, 1e-13},
    {"nu = 0.49", irregular_vertices(), 0.49, {1, 2, 5}, 1e-11, 1e-12},
    {"nu = 0.4999", irregular_vertices(), 0.4999, {1, 2, 5}, 1e-9, 1e-11},
    {"nu = 0.499999", irregular_vertices(), 0.499999, {1, 2, 5}, 1e-7, 1e-10},
    {"nu = 0.49999999", irregular_vertices(), 0.49999999, {1, 2, 5}, 1e-5, 1e-7},
    {"nu = 0.4999999999", irregular_vertices(), 0.4999999999, {1, 2, 5}, 1e-3, 1e-6},
    {"high order", rectangle_vertices(1.6, 1.2), 0.2, {8, 16, 32}, 2e-11, 1e-13},
};

void expect_patch(const Extreme& extreme, Route route) {
  const material::Isotropic material{.youngs_modulus = 1.0, .poisson_ratio = extreme.poisson_ratio, .density = 1.0};
  for (const int p : extreme.orders) {
    const Boundary polygon = boundary(extreme.vertices, p);
    const PolygonSolution solution = solve_polygon(coefficients(polygon, material), route);
    ASSERT_EQ(solution.status, PolygonStatus::converged) << extreme.description << ", order " << p;
    const PatchError error = patch_error(polygon, material, solution.K, p);
    EXPECT_LT(error.force, extreme.force_bar) << extreme.description << ", order " << p;
    EXPECT_LT(error.backward, extreme.backward_bar) << extreme.description << ", order " << p;
  }
}

TEST(PolygonExtremes, RingDoublingPassesThePatchTestOfItsOrder) {
  for (const Extreme& extreme : extremes) expect_patch(extreme, Route::ring_doubling);
}

TEST(PolygonExtremes, MatrixSignPassesThePatchTestOfItsOrder) {
  for (const Extreme& extreme : extremes) expect_patch(extreme, Route::matrix_sign);
}

TEST(PolygonExtremes, OrderedSchurIsBackwardStableOnSlivers) {
  const material::Isotropic material{.youngs_modulus = 1.0, .poisson_ratio = 0.2};
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    const Boundary polygon = boundary(rectangle_vertices(1.0, height), 2);
    const PolygonSolution solution = solve_polygon(coefficients(polygon, material), Route::ordered_schur);
    ASSERT_EQ(solution.status, PolygonStatus::converged);
    // the balanced form's acceptance bar
    EXPECT_LT(patch_error(polygon, material, solution.K, 2).backward, 1e-11) << height;
  }
}

TEST(PolygonExtremes, AStiffnessLostToRoundOffIsRefused) {
  // J_b of the near edge is 1e-15 … 1e-17, its coefficients as large as 1 / J_b: a stiffness of order one drowns.
  const material::Isotropic material{.youngs_modulus = 1.0, .poisson_ratio = 0.2, .density = 1.0};
  int refused = 0;
  for (const double distance : {1e-15, 1e-16, 1e-17}) {
    for (const int p : {1, 2, 4, 8}) {
      const std::vector<Eigen::Vector2d> vertices = {{-0.8, -distance}, {0.8, -distance}, {0.8, 1.2}, {-0.8, 1.2}};
      const PolygonSolution solution = solve_polygon(coefficients(boundary(vertices, p), material));
      if (solution.status == PolygonStatus::converged) {
        EXPECT_GT(solution.K.diagonal().minCoeff(), 0.0) << distance << ' ' << p;
      } else {
        ++refused;
        EXPECT_TRUE(solution.K.hasNaN());
      }
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(PolygonExtremes, RigidMotionsAreFreeAndNothingElseIs) {
  const material::Isotropic material{.youngs_modulus = 25e9, .poisson_ratio = 0.2};
  for (const auto& vertices : {irregular_vertices(), star_vertices(5, 0.3), rectangle_vertices(100.0, 1.0)}) {
    const Boundary polygon = boundary(vertices, 3);
    const MatrixXd K = solve_polygon(coefficients(polygon, material)).K;
    const Eigen::VectorXd spectrum = Eigen::SelfAdjointEigenSolver<MatrixXd>(K).eigenvalues();
    const double largest = spectrum[spectrum.size() - 1];
    // three zeros to round-off; the fourth belongs to bending, (height / length)³ of the largest and never near it
    EXPECT_LT(spectrum.head(3).cwiseAbs().maxCoeff(), 1e-13 * largest);
    EXPECT_GT(spectrum[3], 1e-9 * largest);
    MatrixXd rigid = MatrixXd::Zero(K.rows(), 3);
    for (Eigen::Index i = 0; i < polygon.nodes.cols(); ++i) {
      rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1.0;
      rigid.block<2, 1>(2 * i, 2) << -polygon.nodes(1, i), polygon.nodes(0, i);
    }
    EXPECT_LT((K * rigid.leftCols(2)).norm(), 1e-14 * K.norm() * rigid.leftCols(2).norm());
    EXPECT_LT((K * rigid.col(2)).norm(), 1e-13 * K.norm() * rigid.col(2).norm());
  }
}

TEST(PolygonExtremes, UnitsPlaceTurnAndNumberingDoNotMatter) {
  // 100 m and 25e9 Pa against 1 and 1; turned by 1 radian; numbered from another node.
  const std::vector<Eigen::Vector2d> vertices = irregular_vertices();
  const int p = 2, n = 2 * static_cast<int>(vertices.size()), first = 4;
  const Boundary plain = boundary(vertices, p);
  const MatrixXd K = solve_polygon(coefficients(plain, {.youngs_modulus = 1.0, .poisson_ratio = 0.2})).K;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(1.0).toRotationMatrix();
  Boundary other = plain;
  for (int i = 0; i < n; ++i) other.nodes.col(i) = 100.0 * turn * plain.nodes.col((i + first) % n);
  const MatrixXd turned = solve_polygon(coefficients(other, {.youngs_modulus = 25e9, .poisson_ratio = 0.2})).K / 25e9;
  MatrixXd map = MatrixXd::Zero(2 * n, 2 * n);
  for (int i = 0; i < n; ++i) map.block<2, 2>(2 * i, 2 * ((i + first) % n)) = turn;
  EXPECT_LT((map.transpose() * turned * map - K).norm(), 1e-13 * K.norm());
}

TEST(PolygonExtremes, NaNBecomesAStatus) {
  for (const Route route : {Route::ring_doubling, Route::matrix_sign, Route::ordered_schur}) {
    for (int which = 0; which < 3; ++which) {
      Coefficients c = coefficients(boundary(irregular_vertices(), 1),
                                    {.youngs_modulus = 1.0, .poisson_ratio = 0.2, .density = 1.0});
      MatrixXd& poisoned = which == 0 ? c.E0 : which == 1 ? c.E1 : c.E2;
      poisoned(3, 5) = std::numeric_limits<double>::quiet_NaN();
      const PolygonSolution solution = solve_polygon(c, route);
      EXPECT_EQ(solution.status, PolygonStatus::not_positive_definite);
      EXPECT_TRUE(mass(c, solution).hasNaN());
    }
  }
  Coefficients c = coefficients(boundary(irregular_vertices(), 1), {.youngs_modulus = 1.0, .poisson_ratio = 0.2});
  c.E2 = -c.E2;  // no solid
  EXPECT_NE(solve_polygon(c).status, PolygonStatus::converged);
}

TEST(Modes, ExponentsOfAClosedPolygonAreItsPolynomials) {
  // A homogeneous closed polygon of order p holds the four equilibrium polynomials of each degree 1 … p, and
  // translations.
  for (const int p : {1, 3, 6}) {
    const ModalSolution all =
        modes(coefficients(boundary(irregular_vertices(), p), {.youngs_modulus = 1.0, .poisson_ratio = 0.3}));
    ASSERT_EQ(all.status, PolygonStatus::converged);
    Eigen::VectorXd exponents = -all.S.eigenvalues().real();
    std::sort(exponents.begin(), exponents.end());
    EXPECT_EQ(exponents.head(2).norm(), 0.0);
    // acceptance bar 1e-10 on eigenvalues of multiplicity four that are not defective
    for (int i = 0; i < 4 * p; ++i) EXPECT_NEAR(exponents[2 + i], 1 + i / 4, 1e-10) << p;
    EXPECT_GT(exponents[2 + 4 * p], p + 1e-3);
  }
}

TEST(Modes, CrackHasTwoSingularAndTwoUnitExponents) {
  const ModalSolution all = modes(coefficients(boundary(notch_vertices(16, 2.0 * std::numbers::pi), 6, true),
                                               {.youngs_modulus = 1.0, .poisson_ratio = 0.2}));
  ASSERT_EQ(all.status, PolygonStatus::converged);
  Eigen::VectorXd exponents = -all.S.eigenvalues().real();
  std::sort(exponents.begin(), exponents.end());
  const double expected[] = {0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.5, 1.5};
  // exponents converge as the square of the displacements: beyond 1e-8 with 16 edges of order 6
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(exponents[i], expected[i], 1e-7);
}

TEST(Modes, NotchWhereTheRotationMergesStaysWellConditioned) {
  // At 257.4534 degrees the exponent of the antisymmetric mode meets that of the rotation, 1: a Jordan block, where
  // eigenvectors have condition 1e7 and more. The Schur basis must stay below 1e3.
  const Coefficients c = coefficients(boundary(notch_vertices(12, 257.4534 * std::numbers::pi / 180.0), 4, true),
                                      {.youngs_modulus = 1.0, .poisson_ratio = 0.2, .density = 1.0});
  const ModalSolution all = modes(c);
  ASSERT_EQ(all.status, PolygonStatus::converged);
  const Eigen::VectorXd scale = c.E0.diagonal().cwiseSqrt();
  const Eigen::VectorXd singular = Eigen::JacobiSVD<MatrixXd>(scale.asDiagonal() * all.Vu).singularValues();
  EXPECT_LT(singular[0] / singular[singular.size() - 1], 1e3);
  const PolygonSolution ring = solve_polygon(c), schur = solve_polygon(c, Route::ordered_schur);
  EXPECT_LT((ring.K - schur.K).norm(), 1e-11 * ring.K.norm());
  EXPECT_LT((mass(c, ring) - mass(c, schur)).norm(), 1e-10 * mass(c, ring).norm());
}

TEST(Coefficients, RefusesAnEdgeThatTheCentreDoesNotSee) {
  std::vector<Eigen::Vector2d> vertices = irregular_vertices();
  for (Eigen::Vector2d& vertex : vertices) vertex.y() += 5.0;
  try {
    coefficients(boundary(vertices, 1), {.youngs_modulus = 1.0, .poisson_ratio = 0.2});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("edge 0 "), std::string::npos) << error.what();
  }
  // a centre on an edge sees it edgewise: J_b = 0
  EXPECT_THROW(coefficients(boundary(centre_above_lower_edge(0.0), 1), {.youngs_modulus = 1.0, .poisson_ratio = 0.2}),
               std::invalid_argument);
  Boundary wrong = boundary(irregular_vertices(), 2);
  wrong.orders.pop_back();
  EXPECT_THROW(coefficients(wrong, {.youngs_modulus = 1.0, .poisson_ratio = 0.2}), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::sbfem
