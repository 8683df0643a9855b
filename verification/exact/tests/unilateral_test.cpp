#include <gtest/gtest.h>

#include "verification/exact/unilateral.hpp"

namespace sunder::exact {
namespace {

TEST(ProjectedGaussSeidel, SolvesTwoPairsByHand) {
  // λ = (1, 0) leaves the second pair open by 0.5; with g⁰_2 = -2 both press: F⁻¹ (1, 2).
  const Eigen::Matrix2d F{{1.0, 0.5}, {0.5, 1.0}};
  const Unilateral one = projected_gauss_seidel(F, Eigen::Vector2d(-1.0, 0.0), Eigen::Vector2d::Zero(), 1e-15, 1000);
  EXPECT_NEAR(one.force[0], 1.0, 1e-14);
  EXPECT_EQ(one.force[1], 0.0);
  const Unilateral both = projected_gauss_seidel(F, Eigen::Vector2d(-1.0, -2.0), Eigen::Vector2d::Zero(), 1e-15, 1000);
  EXPECT_NEAR(both.force[0], 0.0, 1e-14);
  EXPECT_NEAR(both.force[1], 2.0, 1e-14);
}

TEST(ProjectedGaussSeidel, SaysHowFarItIsOff) {
  const Eigen::Matrix2d F{{1.0, 0.999}, {0.999, 1.0}};
  const Unilateral answer = projected_gauss_seidel(F, Eigen::Vector2d(-1.0, -1.1), Eigen::Vector2d::Zero(), 1e-15, 2);
  EXPECT_EQ(answer.sweeps, 2);
  EXPECT_GT(answer.residual, 1e-15);
}

}  // namespace
}  // namespace sunder::exact
