#include "solver/fracture/tip_resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/fracture/tests/cracked_plate.hpp"

namespace sunder::fracture {
namespace {

using testing::Plate;

constexpr material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};

std::vector<Eigen::Vector2d> corners_of(double a, double H) {
  return {{-a, 0}, {-a, -H}, {1 - a, -H}, {1 - a, H}, {-a, H}, {-a, 0}};
}

double K_I(const ResolvedOutline& outline) {
  const Plate plate = testing::make_plate(sbfem::testing::boundary(outline.vertices, outline.orders, true), solid);
  return testing::state(plate, testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0)))
      .factors.K_I;
}

TEST(TipResolution, MeetsItsToleranceForEdgeCracksOfAnyDepth) {
  // F of the strip H/W = 3 and of H/W = 1, self-converged with other divisions; their last digits are 5e-8 of F at
  // worst.
  struct Case {
    double a, H, F;
  };
  const Case cases[] = {{0.1, 3, 1.1891784}, {0.2, 3, 1.3673256}, {0.3, 3, 1.6598661}, {0.4, 3, 2.1114124},
                        {0.6, 3, 4.0331148}, {0.7, 3, 6.3548772}, {0.5, 2, 2.8245794}, {0.5, 1, 2.8254653223}};
  for (const Case& c : cases) {
    for (const double tolerance : {1e-4, 1e-6}) {
      const ResolvedOutline outline = resolve_outline(corners_of(c.a, c.H), {.tolerance = tolerance});
      EXPECT_NEAR(K_I(outline) / (c.F * std::sqrt(std::numbers::pi * c.a)), 1.0, tolerance)
          << "a " << c.a << ", H " << c.H << ", tolerance " << tolerance;
    }
  }
  EXPECT_NEAR(K_I(resolve_outline(corners_of(0.5, 1), {.tolerance = 1e-8})) /
                  (2.8254653223 * std::sqrt(std::numbers::pi * 0.5)),
              1.0, 1e-8);
}

TEST(TipResolution, AsksMoreOfLongEdgesNearTheTip) {
  // Straight ahead at distance d and half length h, z = i d / h and ln ρ = asinh(d / h).
  const auto order = [](double d, double h) { return tip_edge_order({d, -h}, {d, h}, 1e-6); };
  for (const double h : {0.5, 1.0, 3.0}) {
    EXPECT_EQ(order(1.0, h), 1 + static_cast<int>(std::ceil(std::log(1e7) / (2.0 * std::asinh(1.0 / h)))));
  }
  EXPECT_EQ(order(2.0, 2.0), order(1e-3, 1e-3));
  EXPECT_EQ(tip_edge_order({1e9, 0}, {1e9, 1}, 1e-3), 2);
}

TEST(TipResolution, GradesTowardsSingularCorners) {
  const std::vector<Eigen::Vector2d> corners{{-3.5, 0}, {-3.5, -8}, {3.5, -8}, {3.5, 8}, {-3.5, 8}, {-3.5, 0}};
  const ResolvedOutline plain = resolve_outline(corners, {.tolerance = 1e-5});
  const ResolvedOutline graded = resolve_outline(corners, {.tolerance = 1e-5, .singular_corners = {1, 2}});
  EXPECT_GT(graded.orders.size(), plain.orders.size() + 6);
  EXPECT_EQ(graded.vertices.size(), graded.orders.size() + 1);
  for (std::size_t e = 0; e < graded.orders.size(); ++e) {
    EXPECT_GE(graded.orders[e], 2);
    EXPECT_LE(graded.orders[e], 12);
  }
  double smallest = 1e9;
  for (std::size_t e = 0; e < graded.orders.size(); ++e) {
    smallest = std::min(smallest, (graded.vertices[e + 1] - graded.vertices[e]).norm());
  }
  // Shorter edges than 1e-5 of the size cost more in round-off than they gain.
  EXPECT_GT(smallest, 1e-4);
}

TEST(TipResolution, RefusesArgumentsOutOfRange) {
  EXPECT_THROW((void)tip_edge_order({1, 0}, {1, 1}, 0.0), std::invalid_argument);
  EXPECT_THROW((void)tip_edge_order({1, 0}, {1, 1}, std::nan("")), std::invalid_argument);
  const std::vector<Eigen::Vector2d> corners = corners_of(0.5, 1.0);
  EXPECT_THROW((void)resolve_outline(corners, {.largest_order = 1}), std::invalid_argument);
  EXPECT_THROW((void)resolve_outline(corners, {.singular_corners = {6}}), std::invalid_argument);
  EXPECT_THROW((void)resolve_outline(std::span(corners).first(1)), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::fracture
