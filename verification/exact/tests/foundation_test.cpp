#include "verification/exact/foundation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sunder::exact {
namespace {

/// At high frequency only plane waves leave: ∫ (ρ c_p cos² + ρ c_s sin²) dθ = π (c_p + c_s)/c_s, and 2π for the
/// rotation.
TEST(RigidDisc, RadiatesPlaneWavesAtHighFrequency) {
  const std::complex<double> force = rigid_disc_translation(0.25, 1000.0) / 1000.0;
  EXPECT_NEAR(force.imag(), std::numbers::pi * (1.0 + std::sqrt(3.0)), 1e-4);
  EXPECT_NEAR((rigid_disc_rotation(1000.0) / 1000.0).imag(), 2.0 * std::numbers::pi, 1e-4);
}

/// At rest the rotation is u_θ = 1/r: moment 2π r² · 2G/r² = 4π. The translation vanishes like 1/ln a0.
TEST(RigidDisc, AtLowFrequencyHoldsTheRotationAndLosesTheTranslation) {
  EXPECT_NEAR(rigid_disc_rotation(1e-4).real(), 4.0 * std::numbers::pi, 1e-6);
  EXPECT_LT(std::abs(rigid_disc_translation(0.25, 1e-6)), std::abs(rigid_disc_translation(0.25, 1e-3)));
}

}  // namespace
}  // namespace sunder::exact
