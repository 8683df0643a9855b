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

TEST(TipResolution, MeetsItsToleranceForCentreCracks) {
  // The right half of the plate, held sideways on its axis of symmetry; the self-converged figures have eight digits.
  struct Case {
    double a, H, F, T;  // half the width is 1
  };
  for (const Case& c : {Case{0.5, 2, 1.1876356, -1.2585891}, Case{0.3, 3, 1.0577473, -1.0714158},
                        Case{0.5, 3, 1.1866713, -1.2569434}, Case{0.7, 3, 1.4882568, -1.8075643}}) {
    for (const double tolerance : {1e-4, 1e-6}) {
      const ResolvedOutline outline = resolve_outline(corners_of(c.a, c.H), {.tolerance = tolerance});
      const Plate plate = testing::make_plate(sbfem::testing::boundary(outline.vertices, outline.orders, true), solid);
      const Eigen::Index n = plate.boundary.nodes.cols();
      Eigen::MatrixXd held = Eigen::MatrixXd::Identity(2 * n, 2 * n);
      Eigen::VectorXd along = Eigen::VectorXd::Zero(2 * n);
      for (Eigen::Index i = 0; i < n; ++i) {
        if (plate.boundary.nodes(0, i) < -c.a + 1e-9) held(2 * i, 2 * i) = 0.0;
        along[2 * i + 1] = 1.0;
      }
      const Eigen::VectorXd load = testing::remote_tension(plate.boundary, {0, 1}, 1.0);
      const TipState at_tip = testing::state(plate, testing::constrained_displacement(plate, load, held, along));
      EXPECT_NEAR(at_tip.factors.K_I / (c.F * std::sqrt(std::numbers::pi * c.a)), 1.0, tolerance) << c.a << ", " << c.H;
      // T is of the next order in r: its field is weighed with r^-1 instead of r^-½.
      EXPECT_NEAR(at_tip.T_stress / c.T, 1.0, 100 * tolerance) << c.a << ", " << c.H;
    }
  }
}

/// The upper half of a plate 2W × 2H with a crack of half length a at 45° in its middle; the tip is at the origin. The
/// cut along y = 0 is divided on the left as on the right.
ResolvedOutline half_with_inclined_crack(double W, double H, const Eigen::Vector2d& tip, double tolerance) {
  std::vector<Eigen::Vector2d> corners{{0, 0}, {W, 0}, {W, H}, {-W, H}, {-W, 0}, {0, 0}};
  for (Eigen::Vector2d& corner : corners) corner -= tip;
  const ResolvedOutline right = resolve_outline(std::span(corners).first(2), {.tolerance = tolerance});
  ResolvedOutline outline = resolve_outline(std::span(corners).first(5), {.tolerance = tolerance});
  for (std::size_t e = right.orders.size(); e-- > 0;) {
    outline.vertices.push_back(-(right.vertices[e] + tip) - tip);
    outline.orders.push_back(right.orders[e]);
  }
  return outline;
}

TEST(TipResolution, MeetsItsToleranceForInclinedCracks) {
  // Tension along y. A turn by 180° maps the plate onto itself: u(-x) = -u(x), so that the left half of the cut and its
  // mouth node follow the right ones. Both factors over σ √(π a); self-converged, seven digits.
  struct Case {
    double W, H, a, K_I, K_II, tolerance, bar;
  };
  // Where the outline lies 140 crack lengths away the rule falls short by up to thirty times (see its header).
  for (const Case& c :
       {Case{1, 2, 0.5, 0.6118355, 0.5458554, 1e-6, 1e-6}, Case{10, 10, 0.1, 0.5000622, 0.5000474, 1e-8, 1e-6}}) {
    const Eigen::Vector2d tip(c.a * std::sqrt(0.5), c.a * std::sqrt(0.5));
    const ResolvedOutline outline = half_with_inclined_crack(c.W, c.H, tip, c.tolerance);
    const Plate plate = testing::make_plate(sbfem::testing::boundary(outline.vertices, outline.orders, true), solid);
    const Eigen::Index n = plate.boundary.nodes.cols();
    const Eigen::Matrix2Xd x = plate.boundary.nodes.colwise() + tip;
    Eigen::MatrixXd tied = Eigen::MatrixXd::Identity(2 * n, 2 * n);
    Eigen::VectorXd turn(2 * n), load = Eigen::VectorXd::Zero(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      turn.segment<2>(2 * i) = Eigen::Vector2d(-x(1, i), x(0, i));
      // Along the boundary the cut's nodes come from the middle outwards first, and last from outside to the middle.
      if (std::abs(x(1, i)) > 1e-9 * c.W || 2 * i > n) continue;
      const Eigen::Index partner = n - 1 - i;
      ASSERT_LE((x.col(i) + x.col(partner)).norm(), 1e-12 * c.W);
      for (Eigen::Index k = 0; k < 2; ++k) {
        tied(2 * partner + k, 2 * partner + k) = 0.0;
        tied(2 * partner + k, 2 * i + k) = -1.0;
      }
    }
    Eigen::Index start = 0;
    for (std::size_t e = 0; e < outline.orders.size(); ++e) {
      const Eigen::Index end = start + outline.orders[e];
      if (std::min(x(1, start), x(1, end)) > c.H - 1e-9) {
        load += sbfem::edge_traction(plate.boundary, static_cast<int>(e), Eigen::Matrix2Xd(Eigen::Vector2d(0, 1)));
      }
      start = end;
    }
    const TipState at_tip = testing::state(plate, testing::constrained_displacement(plate, load, tied, turn));
    const double scale = std::sqrt(std::numbers::pi * c.a);
    EXPECT_NEAR(at_tip.factors.K_I / (c.K_I * scale), 1.0, c.bar) << "W " << c.W;
    EXPECT_NEAR(at_tip.factors.K_II / (c.K_II * scale), 1.0, c.bar) << "W " << c.W;
  }
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
