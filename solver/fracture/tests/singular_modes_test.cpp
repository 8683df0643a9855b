#include "solver/fracture/singular_modes.hpp"

#include <gtest/gtest.h>

#include "solver/fracture/tests/cracked_plate.hpp"

namespace sunder::fracture {
namespace {

constexpr material::Isotropic solid{.youngs_modulus = 1.0, .poisson_ratio = 0.3};

/// A square 2 × 2 around the tip with 8 edges.
testing::Plate square(int order) {
  return testing::make_plate(
      testing::open_boundary({{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}, order),
      solid);
}

SingularModes modes_of(const testing::Plate& plate) {
  return singular_modes(plate.boundary, plate.material, plate.coefficients, plate.solution);
}

void expect_invariant(const ModeGroup& group, const Eigen::MatrixXd& A) {
  // The iteration stops at 1e-12 ‖A‖; the left basis is scaled to Wᵀ V = I, which enlarges it.
  EXPECT_LE((A * group.right - group.right * group.matrix).norm(), 1e-12 * A.norm());
  EXPECT_LE((group.left.transpose() * A - group.matrix * group.left.transpose()).norm(),
            1e-11 * A.norm() * group.left.norm());
  EXPECT_LE((group.left.transpose() * group.right - Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(SingularModes, AreTwoInvariantPairsOnBothSides) {
  for (const int order : {1, 2, 4, 8, 12}) {
    const testing::Plate plate = square(order);
    const SingularModes modes = modes_of(plate);
    EXPECT_EQ(modes.status, ModeStatus::converged) << "order " << order;
    EXPECT_LE(modes.iterations, 10) << "order " << order;
    expect_invariant(modes.singular, plate.solution.A);
    expect_invariant(modes.unit, plate.solution.A);
    for (const auto& exponent : modes.unit.exponents) EXPECT_LE(std::abs(exponent - 1.0), 1e-11);
  }
}

TEST(SingularModes, HaveExponentsThatConvergeToOneHalf) {
  // Twice the prototype's figures for this square: 8e-3, 8e-5, 3e-6, 2e-11.
  const std::pair<int, double> bars[] = {{1, 1.6e-2}, {2, 1.6e-4}, {4, 6e-6}, {8, 4e-11}};
  for (const auto& [order, bar] : bars) {
    for (const auto& exponent : modes_of(square(order)).singular.exponents) {
      EXPECT_LE(std::abs(exponent - 0.5), bar) << "order " << order;
      EXPECT_GT(std::abs(exponent - 0.5), 0.0);
    }
  }
}

TEST(SingularModes, AreFoundByTheFallbackWhereTheyStandFarFromOneHalf) {
  testing::Plate plate = square(2);
  const SingularModes modes = modes_of(plate);
  // ½ → 0.85 is as far from the shift at ½ as the translations' 0 nearly is: inverse iteration stalls.
  plate.solution.A += 0.35 * modes.singular.right * modes.singular.left.transpose();
  const SingularModes moved = modes_of(plate);
  EXPECT_EQ(moved.status, ModeStatus::by_schur);
  for (const auto& exponent : moved.singular.exponents) EXPECT_NEAR(exponent.real(), 0.85, 1e-3);
  expect_invariant(moved.singular, plate.solution.A);
}

TEST(SingularModes, SayThatAPolygonIsNoCrack) {
  testing::Plate plate = square(2);
  plate.solution.A *= 1.4;  // exponents 0.7 and 1.4: no unit group
  EXPECT_EQ(modes_of(plate).status, ModeStatus::not_a_crack);
}

}  // namespace
}  // namespace sunder::fracture
