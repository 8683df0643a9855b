#include "verification/exact/crack_water.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sunder::exact {
namespace {

double gradient(const LouisLaw& law, double flux, double w) {
  const double size = std::abs(flux);
  return (size <= law.critical_flux ? law.laminar * flux : law.turbulent * size * flux) / (w * w * w);
}

TEST(UniformCrack, FillsAsTheSeparateComputationSays) {
  // reference-data/independent-crack-water-2026: 14 printed digits
  EXPECT_NEAR(filling_front(490500.0, 0.001, 1.0, 1e-3), 1.8106080774731, 1e-13);
  EXPECT_NEAR(filling_front(490500.0, 0.001, 10.0, 1e-3), 11.6446647038851, 1e-12);
  EXPECT_NEAR(filling_front(490500.0, 0.001, 100.0, 1e-3), 43.8770017632609, 1e-12);
}

TEST(UniformCrack, RestsWithAFluxThatMeetsItsPressure) {
  for (const double viscosity : {1e3, 1e-3, 1e-9}) {
    const LouisLaw law = louis_law(viscosity);
    const double q = resting_crack_flux(1e5, 0.02, 30.0, viscosity);
    EXPECT_NEAR(gradient(law, q, 0.02) * 30.0, 1e5, 1e-9);
  }
  EXPECT_DOUBLE_EQ(resting_crack_flux(200.0, 0.03, 45.0, 1e-3), 0.00115) << "inside the jump";
}

TEST(UniformCrack, MovesAsTheFlowLawIntegratedPieceByPieceSays) {
  for (const double rate : {0.1, 1e-4, -1e-4, -0.1}) {
    const MovingCrack crack{.pressure = 2e5, .aperture = 0.03, .length = 20.0, .rate = rate, .viscosity = 1e-3};
    const LouisLaw law = louis_law(crack.viscosity);
    const double front = moving_crack_front(crack);
    const int steps = 200000;
    double p = moving_crack_tip_pressure(crack), force = 0.0;
    for (int k = 0; k < steps; ++k) {  // from the point of rest to the mouth, midpoints
      const double h = front / steps, u = (k + 0.5) * h, rise = h * gradient(law, rate * u, crack.aperture);
      force += h * (p + 0.5 * rise);
      p += rise;
    }
    // (front / steps)² of the second derivatives, and h of the jump at the switch
    EXPECT_NEAR(p, 2e5, 1e-4 * std::max(2e5, moving_crack_tip_pressure(crack)));
    EXPECT_NEAR(force, moving_crack_uplift(crack), 1e-4 * force);
  }
}

}  // namespace
}  // namespace sunder::exact
