#include "solver/sbfem/loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/sbfem/tests/area.hpp"

namespace sunder::sbfem {
namespace {

using testing::integral;
using testing::nodal;
using testing::pentagon;

constexpr material::Isotropic concrete{.youngs_modulus = 3.0, .poisson_ratio = 0.2};
// Sums of at most a few hundred terms of order one: 1e-13 is some hundred units of round-off.
constexpr double round_off = 1e-13;

PolygonSolution solved(const Boundary& boundary) {
  return solve_polygon(coefficients(boundary, concrete));
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

TEST(EdgeTraction, HasTheForceAndMomentOfAnyPolynomial) {
  const Eigen::Vector2d first(0.3, -0.2), last(1.1, 0.7), t(2.0, -5.0);
  const double length = (last - first).norm();
  for (const int order : {1, 2, 5}) {
    const Boundary boundary = testing::boundary({first, last, {-0.5, 0.5}}, order);
    for (int k = 0; k < 7; ++k) {
      Eigen::Matrix2Xd traction = Eigen::Matrix2Xd::Zero(2, k + 1);
      traction.col(k) = t;
      const Eigen::VectorXd load = edge_traction(boundary, 0, traction);
      const Eigen::VectorXd x = nodal(boundary, [](const Eigen::Vector2d&) { return Eigen::Vector2d(1.0, 0.0); });
      const Eigen::VectorXd turn =
          nodal(boundary, [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); });
      // ∫ sᵏ ds = 1/(k+1), ∫ s sᵏ ds = 1/(k+2)
      EXPECT_NEAR(load.dot(x), length * t.x() / (k + 1), round_off) << "order " << order << ", power " << k;
      EXPECT_NEAR(load.dot(turn), length * (cross(first, t) / (k + 1) + cross(last - first, t) / (k + 2)), round_off)
          << "order " << order << ", power " << k;
    }
  }
}

TEST(EdgePressure, OnAClosedOutlineSqueezesByTwiceItsAreaAndHoldsItself) {
  const Boundary boundary = testing::boundary(pentagon(), 3);
  const double pressure[] = {7.0};
  Eigen::VectorXd load = Eigen::VectorXd::Zero(boundary.nodes.size());
  for (int edge = 0; edge < 5; ++edge) load += edge_pressure(boundary, edge, pressure);
  const double area = integral(pentagon(), [](const Eigen::Vector2d&) { return 1.0; });
  // ∮ -p n · x ds = -2 p A; a positive pressure resists swelling.
  EXPECT_NEAR(load.dot(nodal(boundary, [](const Eigen::Vector2d& p) { return p; })), -2.0 * 7.0 * area,
              100 * round_off);
  EXPECT_NEAR(load.dot(nodal(boundary, [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); })), 0.0,
              100 * round_off);
  EXPECT_NEAR(load.reshaped(2, load.size() / 2).rowwise().sum().norm(), 0.0, 100 * round_off);
}

TEST(BodyForce, HasTheWeightAndMomentOfThePolygon) {
  const Eigen::Vector2d weight(0.5, -9.0);
  for (const int order : {1, 2, 4}) {
    const Boundary boundary = testing::boundary(pentagon(), order);
    const Eigen::VectorXd load = load_vector(solved(boundary), body_force(boundary, weight));
    const double area = integral(pentagon(), [](const Eigen::Vector2d&) { return 1.0; });
    const double moment = integral(pentagon(), [&](const Eigen::Vector2d& p) { return cross(p, weight); });
    // Translations and the rotation are exact modes of any polygon (exponents 0 and 1), so work on them is exact; the
    // stiffness they come from carries 1e-14 of round-off.
    EXPECT_NEAR((load.reshaped(2, load.size() / 2).rowwise().sum() - area * weight).norm(), 0.0, 1e-11);
    EXPECT_NEAR(load.dot(nodal(boundary, [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); })),
                moment, 1e-11);
  }
}

TEST(CrackFacePressure, HasTheForceAndMomentOfAWedgesFaces) {
  // A notch, so that the faces' forces do not cancel: lower face to (-1, -0.5), upper face to (-0.8, 0.6).
  const std::vector<Eigen::Vector2d> corners{{-1.0, -0.5}, {0.2, -1.0}, {1.0, 0.0}, {0.3, 0.9}, {-0.8, 0.6}};
  const Boundary boundary = testing::boundary(corners, 2, true);
  const PolygonSolution solution = solved(boundary);
  const double powers[] = {0.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < 4; ++k) {
    std::vector<double> pressure(powers, powers + 4);
    pressure[k] = 2.0;
    const Eigen::VectorXd load = load_vector(solution, crack_face_pressure(boundary, pressure));
    // The body lies above the lower face, on its left seen from the tip outwards, and below the upper one.
    const Eigen::Vector2d m0 = corners.front(), m1 = corners.back();
    const Eigen::Vector2d on_lower(-m0.y(), m0.x()), on_upper(m1.y(), -m1.x());
    EXPECT_NEAR((load.reshaped(2, load.size() / 2).rowwise().sum() - 2.0 / (k + 1) * (on_lower + on_upper)).norm(), 0.0,
                1e-11);
    EXPECT_NEAR(load.dot(nodal(boundary, [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); })),
                2.0 / (k + 2) * (cross(m0, on_lower) + cross(m1, on_upper)), 1e-11);
  }
}

TEST(CrackFacePressure, PushesTheFacesApart) {
  const std::vector<Eigen::Vector2d> corners{{-1, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}};
  const Boundary boundary = testing::boundary(corners, 2, true);
  const double pressure[] = {1.0};
  const std::vector<RadialLoad> loads = crack_face_pressure(boundary, pressure);
  ASSERT_EQ(loads.size(), 1u);
  EXPECT_EQ(loads[0].density.head<2>(), Eigen::Vector2d(0.0, -1.0));
  EXPECT_EQ(loads[0].density.tail<2>(), Eigen::Vector2d(0.0, 1.0));
}

TEST(RestrictPolynomial, TakesTheSameValuesOnThePart) {
  const std::vector<double> whole{1.0, -2.0, 0.5, 3.0};
  const auto value = [](const std::vector<double>& c, double s) {
    double sum = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * s + c[k];
    return sum;
  };
  for (const auto& [from, to] :
       {std::pair{0.0, 0.25}, std::pair{0.25, 1.0}, std::pair{1.0, 0.5}, std::pair{0.3, 0.3}}) {
    const std::vector<double> part = restrict_polynomial(whole, from, to);
    for (const double t : {0.0, 0.4, 1.0}) {
      EXPECT_NEAR(value(part, t), value(whole, from + (to - from) * t), 10 * round_off) << from << " to " << to;
    }
  }
  EXPECT_TRUE(restrict_polynomial({}, 0.0, 1.0).empty());
}

TEST(Loads, RefuseWhatIsNotThere) {
  const Boundary closed = testing::boundary(pentagon(), 1);
  const double pressure[] = {1.0};
  EXPECT_THROW(crack_face_pressure(closed, pressure), std::invalid_argument);
  EXPECT_THROW((void)edge_pressure(closed, 5, pressure), std::invalid_argument);
  EXPECT_THROW((void)edge_pressure(closed, -1, pressure), std::invalid_argument);
  EXPECT_THROW((void)load_vector(solved(closed), RadialLoad{.power = -1, .density = Eigen::VectorXd::Zero(10)}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sunder::sbfem
