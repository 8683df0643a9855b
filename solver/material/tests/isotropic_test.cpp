#include "solver/material/isotropic.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace sunder::material {
namespace {

const Isotropic strain{.youngs_modulus = 30e9, .poisson_ratio = 0.25, .density = 2400.0};
const Isotropic stress{.youngs_modulus = 30e9, .poisson_ratio = 0.25, .density = 2400.0, .plane = Plane::stress};

TEST(Isotropic, PlaneStressInvertsHookesLaw) {
  // ε = (1/E) [1 -ν 0; -ν 1 0; 0 0 2(1 + ν)] σ
  Eigen::Matrix3d compliance;
  compliance << 1.0, -0.25, 0.0, -0.25, 1.0, 0.0, 0.0, 0.0, 2.5;
  EXPECT_LT((elasticity_matrix(stress) * compliance / 30e9 - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(Isotropic, PlaneStrainIsPlaneStressWithReplacedConstants) {
  // E → E / (1 - ν²), ν → ν / (1 - ν)
  const Isotropic replaced{
      .youngs_modulus = 30e9 / (1.0 - 0.0625), .poisson_ratio = 0.25 / 0.75, .plane = Plane::stress};
  EXPECT_LT((elasticity_matrix(strain) - elasticity_matrix(replaced)).norm(), 1e-15 * elasticity_matrix(strain).norm());
  EXPECT_DOUBLE_EQ(effective_modulus(strain), replaced.youngs_modulus);
  EXPECT_DOUBLE_EQ(effective_modulus(stress), 30e9);
  EXPECT_DOUBLE_EQ(kolosov_constant(strain), kolosov_constant(replaced));
}

TEST(Isotropic, KolosovsConstantJoinsTheModuli) {
  // E' = 8 G / (κ + 1) in either plane state
  for (const Isotropic& material : {strain, stress}) {
    EXPECT_DOUBLE_EQ(effective_modulus(material), 8.0 * shear_modulus(material) / (kolosov_constant(material) + 1.0));
  }
}

TEST(Isotropic, WaveSpeeds) {
  EXPECT_DOUBLE_EQ(shear_wave_speed(strain), std::sqrt(12e9 / 2400.0));
  // (c_p / c_s)² = 2 (1 - ν) / (1 - 2ν) = 3 in plane strain, 2 / (1 - ν) = 8/3 in plane stress
  EXPECT_DOUBLE_EQ(std::pow(longitudinal_wave_speed(strain) / shear_wave_speed(strain), 2), 3.0);
  EXPECT_DOUBLE_EQ(std::pow(longitudinal_wave_speed(stress) / shear_wave_speed(stress), 2), 8.0 / 3.0);
}

TEST(Isotropic, NearlyIncompressibleStaysFiniteAndStiff) {
  const Isotropic rubber{.youngs_modulus = 1.0, .poisson_ratio = 0.4999999999};
  // D_11 / G = 2 (1 - ν) / (1 - 2ν) = 1 / 2e-10 to the digits of 1 - 2ν
  EXPECT_NEAR(elasticity_matrix(rubber)(0, 0) / shear_modulus(rubber), 5e9, 5e9 * 1e-6);
}

struct Refusal {
  const char* description;
  Isotropic material;
  const char* named;
};

TEST(Isotropic, NamesTheValueItRefuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Refusal refusals[] = {
      {"no stiffness", {.youngs_modulus = 0.0, .poisson_ratio = 0.2}, "youngs_modulus"},
      {"NaN stiffness", {.youngs_modulus = nan, .poisson_ratio = 0.2}, "youngs_modulus"},
      {"infinite stiffness", {.youngs_modulus = infinity, .poisson_ratio = 0.2}, "youngs_modulus"},
      {"incompressible", {.youngs_modulus = 1.0, .poisson_ratio = 0.5}, "poisson_ratio"},
      {"auxetic", {.youngs_modulus = 1.0, .poisson_ratio = -0.1}, "poisson_ratio"},
      {"NaN ratio", {.youngs_modulus = 1.0, .poisson_ratio = nan}, "poisson_ratio"},
      {"negative density", {.youngs_modulus = 1.0, .poisson_ratio = 0.2, .density = -1.0}, "density"},
  };
  for (const Refusal& refusal : refusals) {
    try {
      check(refusal.material);
      ADD_FAILURE() << refusal.description << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(refusal.named), std::string::npos) << error.what();
    }
  }
  EXPECT_NO_THROW(check(strain));
  EXPECT_THROW(shear_wave_speed({.youngs_modulus = 1.0, .poisson_ratio = 0.2}), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::material
