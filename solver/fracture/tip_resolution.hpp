#pragma once
/// How finely the boundary of a crack polygon is to be divided for a wanted accuracy of K_I, before anything is solved.
///
/// Along an edge the field is as smooth as its nearest singular point allows. With the edge mapped to [-1, 1], the tip
/// lies at the complex number z, and polynomials of order p converge as ρ^-p with ρ = |z + √(z² - 1)|, the sum of half
/// axes of the Bernstein ellipse through it [Trefethen 2013, theorem 8.2]. K_I is twice as accurate as the field (order
/// 2p), hence
///     p = 1 + ⌈ln(10 / tolerance) / (2 ln ρ)⌉,
/// and an edge that would need more than `largest_order` is halved; 1 and 10 are a reserve for the unknown factor
/// before ρ^-2p. Nothing is fitted to one plate: for the 28 edge cracks a/W = 0.1 … 0.7, H/W = ½, 1, 2, 3 and
/// tolerances from 1e-2 to 1e-8 the error of K_I came out between 0.004 and 1.0 times the tolerance.
///
/// Corners with a singularity of their own (where a held side meets a free one, re-entrant corners) are approached by
/// edges that shrink by 0.15, each with the order that its distance to the corner asks for.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sunder::fracture {

struct ResolutionOptions {
  double tolerance = 1e-6;              ///< relative error of K_I aimed at, in [1e-12, 0.1]
  int largest_order = 12;               ///< in [2, 64]
  std::vector<int> singular_corners{};  ///< indices into the outline's corners
};

/// Order for one edge from `first` to `last` (2) [m], relative to the tip; without bound, at least 2.
/// Throws std::invalid_argument where the tolerance is out of range.
[[nodiscard]] int tip_edge_order(const Eigen::Vector2d& first, const Eigen::Vector2d& last, double tolerance);

struct ResolvedOutline {
  std::vector<Eigen::Vector2d> vertices;  ///< relative to the tip [m]; one more than orders
  std::vector<int> orders;
};

/// Divides the sides between consecutive corners, which are relative to the tip [m], from the lower mouth to the upper
/// one. Throws std::invalid_argument where an option is out of range or there are fewer than two corners.
[[nodiscard]] ResolvedOutline resolve_outline(std::span<const Eigen::Vector2d> corners,
                                              const ResolutionOptions& options = {});

}  // namespace sunder::fracture
