#include "solver/fracture/williams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/fracture/tests/cracked_plate.hpp"

namespace sunder::fracture {
namespace {

constexpr double pi = std::numbers::pi;
constexpr material::Isotropic strain{.youngs_modulus = 2.0, .poisson_ratio = 0.3};
constexpr material::Isotropic stress_state{
    .youngs_modulus = 2.0, .poisson_ratio = 0.3, .plane = material::Plane::stress};

TEST(Williams, HoldsHookesLawAndItsOwnSlope) {
  for (const material::Isotropic& solid : {strain, stress_state}) {
    for (const int n : {-2, -1, 1, 2, 3}) {
      for (const Mode mode : {Mode::I, Mode::II}) {
        const WilliamsField field{n, mode};
        const auto u = [&](double x, double y) {
          return displacement(field, solid, std::hypot(x, y), std::atan2(y, x));
        };
        const double x = 0.6, y = -0.9, h = 1e-5;
        const Eigen::Vector2d u_x = (u(x + h, y) - u(x - h, y)) / (2 * h), u_y = (u(x, y + h) - u(x, y - h)) / (2 * h);
        const Eigen::Vector3d eps(u_x.x(), u_y.y(), u_y.x() + u_x.y());
        // Central differences: h² / 6 times a third derivative of order 100 at most, and round-off 1e-16 / h.
        constexpr double difference = 1e-8;
        EXPECT_LE((material::elasticity_matrix(solid) * eps - stress(field, std::hypot(x, y), std::atan2(y, x))).norm(),
                  difference)
            << n;
        EXPECT_LE((displacement_slope(field, solid, std::hypot(x, y), std::atan2(y, x)) - u_x).norm(), difference) << n;
      }
    }
  }
}

TEST(Williams, LeavesBothFacesFreeOfTraction) {
  for (const int n : {-2, -1, 1, 2, 3}) {
    for (const Mode mode : {Mode::I, Mode::II}) {
      for (const double theta : {-pi, pi}) {
        const Eigen::Vector3d s = stress({n, mode}, 0.5, theta);
        EXPECT_LE(std::hypot(s[1], s[2]), 1e-13) << n;  // a few units of round-off of amplitudes below 100
      }
    }
  }
}

TEST(Williams, HasTheAmplitudesThatDefineTheFactors) {
  const double r = 0.25;
  for (const material::Isotropic& solid : {strain, stress_state}) {
    const double opening = 8.0 / material::effective_modulus(solid) * std::sqrt(r / (2.0 * pi));
    EXPECT_NEAR((displacement({1, Mode::I}, solid, r, pi) - displacement({1, Mode::I}, solid, r, -pi)).y(), opening,
                1e-15);
    EXPECT_NEAR((displacement({1, Mode::II}, solid, r, pi) - displacement({1, Mode::II}, solid, r, -pi)).x(), opening,
                1e-15);
  }
  EXPECT_DOUBLE_EQ(stress({1, Mode::I}, r, 0.0)[1], 1.0 / std::sqrt(2.0 * pi * r));
  EXPECT_DOUBLE_EQ(stress({1, Mode::II}, r, 0.0)[2], 1.0 / std::sqrt(2.0 * pi * r));
  EXPECT_LE((stress({2, Mode::I}, r, 1.0) - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 1e-15);
}

TEST(TipFrame, TurnsWithTheCrackAndKeepsTheFacesApart) {
  for (const double angle : {0.0, 0.3, -2.0, pi / 2, 3.1}) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    std::vector<Eigen::Vector2d> corners{{-0.7, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-0.7, 0}};
    for (Eigen::Vector2d& corner : corners) corner = turn * corner;
    const sbfem::Boundary boundary = testing::open_boundary(corners, 1);
    const TipFrame frame = tip_frame(boundary);
    EXPECT_NEAR(frame.direction, angle, 1e-15);
    EXPECT_NEAR(frame.face_length, 0.7, 1e-15);
    const Eigen::Matrix2Xd polar = polar_nodes(boundary, frame);
    EXPECT_EQ(polar(1, 0), -pi);
    EXPECT_EQ(polar(1, polar.cols() - 1), pi);
    EXPECT_NEAR(polar(1, 2), -pi / 4, 1e-14);
  }
}

TEST(TipFrame, RefusesWhatIsNoCrack) {
  sbfem::Boundary boundary = testing::open_boundary({{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}, 1);
  boundary.open = false;
  EXPECT_THROW(tip_frame(boundary), std::invalid_argument);
  const sbfem::Boundary notch = testing::open_boundary({{-1, -0.2}, {0, -1}, {1, 0}, {0, 1}, {-1, 0.2}}, 1);
  EXPECT_THROW(tip_frame(notch), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::fracture
