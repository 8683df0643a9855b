#include "solver/numerics/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace sunder::numerics {
namespace {

/// Σ w_i T_k(x_i) against ∫ T_k = 2 / (1 - k²) (k even), 0 (k odd). Chebyshev polynomials stay within ±1, so that every
/// degree is judged on the same scale.
double worst_moment(const QuadratureRule& rule, int degree) {
  double worst = 0.0;
  for (int k = 0; k <= degree; ++k) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < rule.points.size(); ++i)
      sum += rule.weights[i] * std::cos(k * std::acos(rule.points[i]));
    worst = std::max(worst, std::abs(sum - (k % 2 == 0 ? 2.0 / (1.0 - static_cast<double>(k) * k) : 0.0)));
  }
  return worst;
}

TEST(Quadrature, GaussLegendreIsExactToDegreeTwoNMinusOne) {
  for (const int n : {1, 2, 3, 5, 10, 33, 64, 80, 128}) {
    // cos(k acos x) loses k roundings of its argument
    EXPECT_LT(worst_moment(gauss_legendre(n), 2 * n - 1), 1e-15 * (2 + n)) << n;
    EXPECT_GT(worst_moment(gauss_legendre(n), 2 * n), 1e-3 / n) << n;  // and not beyond
  }
}

TEST(Quadrature, GaussLobattoIsExactToDegreeTwoNMinusThreeAndHoldsTheEnds) {
  for (const int n : {2, 3, 4, 9, 33, 65, 81, 128}) {
    const QuadratureRule rule = gauss_lobatto(n);
    EXPECT_LT(worst_moment(rule, 2 * n - 3), 1e-15 * (2 + n)) << n;
    EXPECT_GT(worst_moment(rule, 2 * n - 2), 1e-3 / n) << n;
    EXPECT_EQ(rule.points[0], -1.0);
    EXPECT_EQ(rule.points[n - 1], 1.0);
  }
}

TEST(Quadrature, PointsAreSymmetricAndAscend) {
  for (const int n : {2, 7, 80}) {
    for (const QuadratureRule& rule : {gauss_legendre(n), gauss_lobatto(n)}) {
      EXPECT_EQ(rule.points, -rule.points.reverse());
      EXPECT_EQ(rule.weights, rule.weights.reverse());
      for (int i = 1; i < n; ++i) EXPECT_GT(rule.points[i], rule.points[i - 1]);
    }
  }
}

TEST(Quadrature, KnownPoints) {
  const QuadratureRule gauss = gauss_legendre(3), lobatto = gauss_lobatto(5);
  EXPECT_DOUBLE_EQ(gauss.points[2], std::sqrt(0.6));
  EXPECT_DOUBLE_EQ(gauss.weights[1], 8.0 / 9.0);
  EXPECT_DOUBLE_EQ(lobatto.points[3], std::sqrt(3.0 / 7.0));
  EXPECT_DOUBLE_EQ(lobatto.weights[4], 0.1);
}

TEST(Quadrature, RefusesSizesOutOfRange) {
  EXPECT_THROW(gauss_legendre(0), std::invalid_argument);
  EXPECT_THROW(gauss_legendre(129), std::invalid_argument);
  EXPECT_THROW(gauss_lobatto(1), std::invalid_argument);
}

TEST(Lagrange, InterpolatesAndDifferentiatesPolynomialsUpToOrder64) {
  for (const int p : {1, 2, 5, 16, 32, 64}) {
    const LagrangeBasis basis = lagrange_basis(gauss_lobatto(p + 1).points);
    Eigen::VectorXd T(p + 1);  // the Chebyshev polynomial of degree p at the points
    for (int i = 0; i <= p; ++i) T[i] = std::cos(p * std::acos(basis.points[i]));
    for (const double x : {-1.0, -0.999, -0.3, 0.0, 0.123456, 0.77, 1.0}) {
      const double angle = std::acos(x);
      // the sum of |ℓ_j| is below 4, the values carry p roundings of the angle
      EXPECT_NEAR(values(basis, x).dot(T), std::cos(p * angle), 4e-16 * (4 + p)) << p << ' ' << x;
      EXPECT_NEAR(values(basis, x).sum(), 1.0, 1e-15);
      double previous = 0.0, second_kind = 1.0;  // T_p' = p U_(p-1), by U_(k+1) = 2x U_k - U_(k-1)
      for (int k = 1; k < p; ++k) previous = std::exchange(second_kind, 2.0 * x * second_kind - previous);
      const double slope = p * second_kind;
      // ‖derivative‖ grows as p²
      EXPECT_NEAR(derivatives(basis, x).dot(T), slope, 4e-16 * (4 + p) * (p * p + 1)) << p << ' ' << x;
      EXPECT_NEAR(derivatives(basis, x).sum(), 0.0, 1e-15 * (p * p + 1));
    }
  }
}

TEST(Lagrange, IsOneAtItsOwnPointAndZeroAtTheOthers) {
  const LagrangeBasis basis = lagrange_basis(gauss_lobatto(9).points);
  for (Eigen::Index i = 0; i < 9; ++i) EXPECT_EQ(values(basis, basis.points[i]), Eigen::VectorXd::Unit(9, i));
}

}  // namespace
}  // namespace sunder::numerics
