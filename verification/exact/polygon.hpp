#pragma once
/// Straight-edged polygons: moments of their area, and what a traction does to the nodes on an edge.

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "verification/exact/plane_elasticity.hpp"

namespace sunder::exact {

/// ∫ dA, ∫ z dA, ∫ z² dA, ∫ |z|² dA of a counter-clockwise polygon, by Green's theorem [m², m³, m⁴, m⁴].
struct AreaMoments {
  double area;
  Complex first, second;
  double polar;
};
AreaMoments area_moments(std::span<const Complex> vertices);

/// Points in (-1, 1) and weights of Gauss and Legendre's rule, exact to degree 2 count - 1; by Newton's method on the
/// three-term recurrence.
std::vector<std::pair<double, double>> gauss_rule(int count);

/// Nodal forces ∮ N_i t ds on one straight edge whose Lagrange polynomials N_i have the given nodes, first and last its
/// ends. `traction(z)` [Pa] of the edge; exact for polynomials up to degree 2 points - nodes.
std::vector<Complex> edge_forces(std::span<const Complex> nodes, const std::function<Complex(Complex)>& traction,
                                 int points);

}  // namespace sunder::exact
