#include "solver/numerics/quadrature.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sunder::numerics {
namespace {

constexpr int largest_rule = 128;

// The points are iterated in the 64-bit mantissa of x87 and rounded once: weights hold 1 - x², which would lose digits
// near the ends in double.
using Extended = long double;

/// P_n(x) and P_{n-1}(x) by the three-term recurrence; n >= 1.
struct Legendre {
  Extended value, previous;
};
Legendre legendre(int n, Extended x) {
  Extended value = x, previous = 1;
  for (int k = 2; k <= n; ++k) {
    const Extended next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
    previous = value;
    value = next;
  }
  return {value, previous};
}

void check_size(const char* name, int n, int smallest) {
  if (n < smallest || n > largest_rule) {
    throw std::invalid_argument(std::string(name) + ": n = " + std::to_string(n) + ", accepted is " +
                                std::to_string(smallest) + " <= n <= " + std::to_string(largest_rule));
  }
}

// Newton's method converges quadratically from the guesses below; 12 steps are twice what any n needs.
constexpr int newton_steps = 12;

}  // namespace

QuadratureRule gauss_legendre(int n) {
  check_size("gauss_legendre", n, 1);
  QuadratureRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (int i = 0; i < (n + 1) / 2; ++i) {
    Extended x = std::cos(std::numbers::pi_v<Extended> * (i + 0.75L) / (n + 0.5L));
    Extended slope = 1;
    for (int step = 0; step < newton_steps; ++step) {
      const auto [value, previous] = legendre(n, x);
      slope = n * (previous - x * value) / (1 - x * x);
      x -= value / slope;
    }
    if (2 * i + 1 == n) x = 0;
    const auto [value, previous] = legendre(n, x);
    slope = n * (previous - x * value) / (1 - x * x);
    rule.points[n - 1 - i] = static_cast<double>(x);
    rule.points[i] = static_cast<double>(-x);
    rule.weights[i] = rule.weights[n - 1 - i] = static_cast<double>(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

QuadratureRule gauss_lobatto(int n) {
  check_size("gauss_lobatto", n, 2);
  QuadratureRule rule{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  const int degree = n - 1;
  for (int i = 0; i < (n + 1) / 2; ++i) {
    // Newton on (1 - x²) P'_N, whose derivative is -N (N + 1) P_N, started from the Chebyshev points.
    Extended x = std::cos(std::numbers::pi_v<Extended> * i / degree);
    for (int step = 0; step < newton_steps && i > 0; ++step) {
      const auto [value, previous] = legendre(degree, x);
      x -= (x * value - previous) / ((degree + 1) * value);
    }
    if (2 * i + 1 == n) x = 0;
    const Extended value = legendre(degree, x).value;
    rule.points[n - 1 - i] = static_cast<double>(x);
    rule.points[i] = static_cast<double>(-x);
    rule.weights[i] = rule.weights[n - 1 - i] = static_cast<double>(2 / (degree * (degree + 1) * value * value));
  }
  return rule;
}

LagrangeBasis lagrange_basis(const Eigen::VectorXd& points) {
  const auto n = points.size();
  LagrangeBasis basis{points, Eigen::VectorXd(n), Eigen::MatrixXd(n, n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    double product = 1.0;
    for (Eigen::Index k = 0; k < n; ++k) {
      // The factor 2 is the inverse of the interval's capacity: it keeps the product near 1 for any n.
      if (k != j) product *= 2.0 * (points[j] - points[k]);
    }
    basis.weights[j] = 1.0 / product;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    basis.derivative(i, i) = 0.0;
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j != i) basis.derivative(i, j) = basis.weights[j] / basis.weights[i] / (points[i] - points[j]);
    }
    basis.derivative(i, i) = -basis.derivative.row(i).sum();  // a constant has no slope, exactly
  }
  return basis;
}

Eigen::VectorXd values(const LagrangeBasis& basis, double x) {
  const auto n = basis.points.size();
  Eigen::VectorXd result(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    if (x == basis.points[j]) return Eigen::VectorXd::Unit(n, j);
    result[j] = basis.weights[j] / (x - basis.points[j]);
  }
  return result / result.sum();
}

Eigen::VectorXd derivatives(const LagrangeBasis& basis, double x) {
  return basis.derivative.transpose() * values(basis, x);
}

}  // namespace sunder::numerics
