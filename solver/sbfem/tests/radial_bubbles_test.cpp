#include "solver/sbfem/radial_bubbles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/numerics/quadrature.hpp"

namespace sunder::sbfem {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr material::Isotropic unit_shear{
    .youngs_modulus = 2.4, .poisson_ratio = 0.2, .density = 1.0};  // G = 1, c_s = 1

/// A unit square with one element of order p on each side, centred.
Boundary unit_square(int p) {
  const Eigen::Vector2d corners[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const auto rule = numerics::gauss_lobatto(p + 1);
  Boundary square{.nodes = Eigen::Matrix2Xd(2, 4 * p), .orders = std::vector<int>(4, p)};
  for (int edge = 0; edge < 4; ++edge) {
    for (int k = 0; k < p; ++k) {
      const double t = 0.5 * (rule.points[k] + 1.0);
      square.nodes.col(edge * p + k) = (1.0 - t) * corners[edge] + t * corners[(edge + 1) % 4];
    }
  }
  return square;
}

/// Lowest ω² of the unit square on rollers all round: the normal displacement of every side is held. Exact: 2 π² c_s².
double roller_square(int p, int interior_order) {
  const Boundary square = unit_square(p);
  const Coefficients c = coefficients(square, unit_shear);
  const PolygonSolution solution = solve_polygon(c);
  const MatrixXd M = mass(c, solution);
  RadialBubbles bubbles;
  if (interior_order > 0) bubbles = radial_bubbles(c, solution, M, interior_order);
  std::vector<int> free;
  for (int node = 0; node < square.nodes.cols(); ++node) {
    for (int component = 0; component < 2; ++component) {
      if (std::abs(std::abs(square.nodes(component, node)) - 0.5) > 1e-9) free.push_back(2 * node + component);
    }
  }
  const Eigen::Index n = std::ssize(free), b = bubbles.omega_squared.size();
  MatrixXd stiffness = MatrixXd::Zero(n + b, n + b), inertia = MatrixXd::Identity(n + b, n + b);
  stiffness.topLeftCorner(n, n) = solution.K(free, free);
  inertia.topLeftCorner(n, n) = M(free, free);
  if (b > 0) {
    stiffness.bottomRightCorner(b, b).diagonal() = bubbles.omega_squared;
    inertia.topRightCorner(n, b) = bubbles.coupling(free, Eigen::all);
    inertia.bottomLeftCorner(b, n) = inertia.topRightCorner(n, b).transpose();
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(stiffness, inertia, Eigen::EigenvaluesOnly);
  return modes.eigenvalues()[0];
}

TEST(RadialBubbles, BringTheFrequencyOfOnePolygonFromThirtySixPercentToItsPolynomialOrder) {
  const double exact = 2.0 * std::numbers::pi * std::numbers::pi;
  EXPECT_GT(roller_square(6, 0) / exact - 1.0, 0.3);  // static modes alone do not converge with p
  struct Row {
    const char* description;
    int order;
    double largest_error;
  };
  // Rayleigh-Ritz in polynomials of degree p errs by the squared first term that they leave of sin(πx) on [-½, ½],
  // 2 (2p + 3) j_{p+1}(π/2)² with the spherical Bessel function: 1.5e-2, 1.5e-5, 3.5e-9; twice to three times that.
  for (const Row& row : {Row{"p = m = 2", 2, 3e-2}, {"p = m = 4", 4, 3e-5}, {"p = m = 6", 6, 1e-8}}) {
    const double error = roller_square(row.order, row.order) / exact - 1.0;
    EXPECT_LT(error, row.largest_error) << row.description;
    EXPECT_GT(error, -1e-10) << row.description << ": Rayleigh-Ritz comes from above";
  }
}

TEST(RadialBubbles, MoreOfThemNeverRaiseTheFrequency) {
  double previous = roller_square(4, 0);
  for (int order = 2; order <= highest_interior_order; ++order) {
    const double now = roller_square(4, order);
    EXPECT_LE(now, previous * (1.0 + 1e-9)) << order;  // nested spaces; half of the digits may go (see the header)
    previous = now;
  }
}

TEST(RadialBubbles, LeaveOutTheEquilibriumPolynomials) {
  // Powers 2 … m hold 2n (m - 1) functions; for each k <= p four of them are static fields.
  const int p = 3, m = 3;
  const Coefficients c = coefficients(unit_square(p), unit_shear);
  const PolygonSolution solution = solve_polygon(c);
  const RadialBubbles bubbles = radial_bubbles(c, solution, mass(c, solution), m);
  EXPECT_EQ(bubbles.omega_squared.size(), 2 * 4 * p * (m - 1) - 4 * (m - 1));
  EXPECT_GT(bubbles.omega_squared[0], 0.0);
}

TEST(RadialBubbles, OrderOutOfRangeIsNamed) {
  const Coefficients c = coefficients(unit_square(1), unit_shear);
  const PolygonSolution solution = solve_polygon(c);
  EXPECT_THROW((void)radial_bubbles(c, solution, mass(c, solution), 1), std::invalid_argument);
  EXPECT_THROW((void)radial_bubbles(c, solution, mass(c, solution), highest_interior_order + 1), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::sbfem
