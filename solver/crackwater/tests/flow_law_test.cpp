#include "solver/crackwater/flow_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/crackwater/aperture.hpp"
#include "solver/crackwater/inverse_cube_moments.hpp"

namespace sunder::crackwater {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(FlowLaw, IsDarcyWeisbachWithLouisFrictionFactors) {
  const Water water;
  const FlowLaw law = flow_law(water);
  for (const double reynolds : {1e-12, 1.0, 2299.0, 2301.0, 1e5, 1e9}) {
    const double flux = reynolds * water.dynamic_viscosity / (2.0 * water.density), w = 0.03;
    const double r = water.relative_roughness;
    const double friction_factor = reynolds <= 2300.0 ? 96.0 * (1.0 + 8.8 * std::pow(r, 1.5)) / reynolds
                                                      : std::pow(-2.0 * std::log10(r / 1.9), -2.0);
    const double expected = friction_factor * water.density * flux * flux / (4.0 * w * w * w);
    EXPECT_NEAR(friction_gradient(law, flux, w), expected, 16.0 * epsilon * expected) << reynolds;  // a dozen roundings
    EXPECT_EQ(friction_gradient(law, -flux, w), -friction_gradient(law, flux, w));  // odd, to the last bit
  }
}

TEST(FlowLaw, SwitchesAtReynoldsNumber2300) {
  const FlowLaw law = flow_law({});
  for (int k = 1; k <= 15; ++k) {
    const double below = law.critical_flux * (1.0 - std::pow(10.0, -k)),
                 above = law.critical_flux * (1.0 + std::pow(10.0, -k));
    EXPECT_EQ(resistance(law, below), law.laminar * below);
    EXPECT_EQ(resistance(law, above), law.turbulent * above * above);
  }
  EXPECT_EQ(resistance(law, law.critical_flux), law.laminar * law.critical_flux);
  // 1150/(192 log10²(r/1.9)(1 + 8.8 r^1.5)) = 4.334 at r = 0.5, given to four digits
  EXPECT_NEAR(resistance_jump(0.5), 4.334, 5e-4);
  EXPECT_NEAR(resistance_jump(1e-4), 0.327, 5e-4);
}

TEST(FlowLaw, IsInvertible) {
  const FlowLaw law = flow_law({});
  for (double flux = 1e-12; flux < 1e6; flux *= 1.7) {
    for (const double sign : {1.0, -1.0}) {
      const double q = sign * flux;
      EXPECT_NEAR(flux_of_resistance(law, resistance(law, q)), q, 4.0 * epsilon * flux);
    }
  }
  const double inside = 2.0 * law.laminar * law.critical_flux;  // in the jump
  EXPECT_EQ(flux_of_resistance(law, inside), law.critical_flux);
  EXPECT_EQ(flux_of_resistance(law, -inside), -law.critical_flux);
}

TEST(FlowLaw, RefusesWhatItCannotUse) {
  struct Case {
    const char* description;
    Water water;
    const char* named;
  };
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Case cases[] = {
      {"no density", {.density = 0.0}, "density"},
      {"negative density", {.density = -1.0}, "density"},
      {"no viscosity", {.dynamic_viscosity = 0.0}, "dynamic_viscosity"},
      {"viscosity not a number", {.dynamic_viscosity = nan}, "dynamic_viscosity"},
      {"infinite density", {.density = infinity}, "density"},
      {"smooth", {.relative_roughness = 0.0}, "relative_roughness"},
      {"rougher than the gap", {.relative_roughness = 0.51}, "relative_roughness"},
      {"law falls at Re = 2300", {.relative_roughness = 0.00687}, "0.00687879"},
      {"gravity upwards", {.gravity = -9.81}, "gravity"},
  };
  for (const Case& c : cases) {
    try {
      (void)flow_law(c.water);
      ADD_FAILURE() << c.description;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(c.named), std::string::npos) << error.what();
    }
  }
  EXPECT_NO_THROW(flow_law({.relative_roughness = least_monotone_roughness}));
  EXPECT_THROW(flow_law({.relative_roughness = least_monotone_roughness - 1e-8}), std::invalid_argument);
}

TEST(Aperture, FollowsTheOpeningOnlyWhereTheFacesAreApart) {
  struct Case {
    const char* description;
    ApertureRule rule;
    double opening, rate, value, aperture_rate, factor;
  };
  const Case cases[] = {
      {"open", ApertureRule::larger, 0.05, 0.2, 0.05, 0.2, 1.0},
      {"rests on the roughness", ApertureRule::larger, 0.02, 0.2, 0.03, 0.0, 0.0},
      {"penetrates", ApertureRule::larger, -0.01, -0.2, 0.03, 0.0, 0.0},
      {"on the bound, leaving", ApertureRule::larger, 0.03, 0.2, 0.03, 0.2, 1.0},
      {"on the bound, arriving", ApertureRule::larger, 0.03, -0.2, 0.03, 0.0, 0.0},
      {"open", ApertureRule::sum, 0.05, 0.2, 0.08, 0.2, 1.0},
      {"just closed", ApertureRule::sum, 0.0, -0.2, 0.03, 0.0, 0.0},
      {"leaving", ApertureRule::sum, 0.0, 0.2, 0.03, 0.2, 1.0},
      {"penetrates", ApertureRule::sum, -1.0, 0.2, 0.03, 0.0, 0.0},
  };
  for (const Case& c : cases) {
    const Aperture a = aperture(c.opening, c.rate, 0.03, c.rule);
    EXPECT_DOUBLE_EQ(a.value, c.value) << c.description;
    EXPECT_EQ(a.rate, c.aperture_rate) << c.description;
    EXPECT_EQ(a.factor, c.factor) << c.description;
  }
}

TEST(InverseCubeMoments, AgreeWithQuadratureForEveryTaper) {
  for (const double ratio : {1.0 + 1e-12, 1.0 + 1e-6, 1.0019, 1.0079, 1.0081, 1.01, 1.1, 1.105, 1.106, 1.5, 2.0, 2.33,
                             2.34, 5.0, 8.9, 9.1, 100.0, 1e4}) {
    for (const bool widening : {true, false}) {
      const double first = widening ? 1.0 : ratio, last = widening ? ratio : 1.0;
      const auto m = inverse_cube_moments(first, last, taper_of(first, last));
      // Independent: with w = e^u the integrand is entire; the trapezoidal rule in a double-exponential variable.
      long double expected[moment_count] = {};
      const long double tau = (static_cast<long double>(last) - first) / (static_cast<long double>(last) + first);
      const long double step = 0.01L, half_pi = 1.5707963267948966192313216916398L;
      for (int j = -450; j <= 450; ++j) {
        const long double t = step * j, y = std::tanh(half_pi * std::sinh(t));
        const long double weight = half_pi * std::cosh(t) / std::pow(std::cosh(half_pi * std::sinh(t)), 2.0L);
        const long double w = 1.0L + tau * y;
        for (int k = 0; k < moment_count; ++k) expected[k] += step * weight * std::pow(y, k) / (w * w * w);
      }
      for (int k = 0; k < moment_count; ++k) {
        // a few roundings of the largest moment; beyond 1 : 9 the upward recurrence may cost a digit
        const double tolerance = (ratio > 9.0 ? 256.0 : 16.0) * epsilon * m[0];
        EXPECT_NEAR(m[static_cast<std::size_t>(k)], static_cast<double>(expected[k]), tolerance) << ratio << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace sunder::crackwater
