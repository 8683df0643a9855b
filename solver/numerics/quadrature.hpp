#pragma once
/// Gauss rules on [-1, 1] and Lagrange polynomials on their points: how edges are integrated and interpolated.
///
/// Everything is a pure function of its arguments; keep the returned value where it is used often.

#include <Eigen/Core>

namespace sunder::numerics {

/// ∫₋₁¹ f(η) dη ≈ Σ weights_i f(points_i); points ascending, symmetric about 0.
struct QuadratureRule {
  Eigen::VectorXd points;   ///< (n)
  Eigen::VectorXd weights;  ///< (n), > 0, sum 2
};

/// n points, 1 <= n <= 128, exact to degree 2n - 1. Points and weights to the last bit or two (iterated in extended
/// precision). Throws std::invalid_argument where n is out of range.
QuadratureRule gauss_legendre(int n);

/// n points, 2 <= n <= 128, both ends included, exact to degree 2n - 3. Throws std::invalid_argument where n is out of
/// range.
QuadratureRule gauss_lobatto(int n);

/// Lagrange polynomials ℓ_j of given points in barycentric form, which is stable for points that gather at the ends
/// [Berrut & Trefethen 2004, Eqs. (4.2) and (9.4)].
struct LagrangeBasis {
  Eigen::VectorXd points;      ///< (n), distinct
  Eigen::VectorXd weights;     ///< (n), 1 / Π_k≠j (x_j - x_k) up to a common factor
  Eigen::MatrixXd derivative;  ///< (n, n), ℓ_j'(x_i) in row i, column j; rows sum to 0
};

LagrangeBasis lagrange_basis(const Eigen::VectorXd& points);

/// ℓ_j(x), (n).
Eigen::VectorXd values(const LagrangeBasis& basis, double x);

/// ℓ_j'(x), (n).
Eigen::VectorXd derivatives(const LagrangeBasis& basis, double x);

}  // namespace sunder::numerics
