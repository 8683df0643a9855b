#include "verification/exact/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sunder::exact {
namespace {

/// u'' + 2 ζ ω u' + ω² u of a motion given as a function of time, by central differences of its velocity.
template <class Function>
double left_side(double omega, double zeta, double time, Function motion) {
  constexpr double h = 1e-4;
  const double acceleration = (motion(time + h).velocity - motion(time - h).velocity) / (2.0 * h);
  return acceleration + 2.0 * zeta * omega * motion(time).velocity + omega * omega * motion(time).displacement;
}

constexpr double omega = 3.0, zeta = 0.1;
// h² times the fourth derivative of motions of order one, over 6
constexpr double of_differences = 1e-6;

TEST(Oscillator, ClosedFormsSolveTheirEquations) {
  for (const double t : {0.3, 1.7, 4.0}) {
    EXPECT_NEAR(left_side(omega, zeta, t,
                          [](double s) {
                            return free_oscillator(omega, zeta, {0.7, -1.2}, s);
                          }),
                0.0, of_differences);
    EXPECT_NEAR(left_side(omega, zeta, t, [](double s) { return forced_oscillator(omega, zeta, 2.0, 2.2, s); }),
                2.0 * std::sin(2.2 * t), of_differences);
    EXPECT_NEAR(left_side(omega, zeta, t, [](double s) { return ramped_oscillator(omega, zeta, 1.5, -0.4, s); }),
                1.5 - 0.4 * t, of_differences);
  }
}

TEST(Oscillator, ClosedFormsBeginWhereTheyShall) {
  EXPECT_EQ(free_oscillator(omega, zeta, {0.7, -1.2}, 0.0).displacement, 0.7);
  EXPECT_NEAR(free_oscillator(omega, zeta, {0.7, -1.2}, 0.0).velocity, -1.2, 1e-15);
  EXPECT_NEAR(forced_oscillator(omega, zeta, 2.0, 2.2, 0.0).displacement, 0.0, 1e-15);
  EXPECT_NEAR(forced_oscillator(omega, zeta, 2.0, 2.2, 0.0).velocity, 0.0, 1e-15);
  EXPECT_NEAR(ramped_oscillator(omega, zeta, 1.5, -0.4, 0.0).velocity, 0.0, 1e-15);
}

TEST(Oscillator, TrapezoidalRuleSolvesItsOwnEquations) {
  constexpr double dt = 0.4;
  for (int n = 0; n < 5; ++n) {
    const Motion a = trapezoidal_oscillator(omega, zeta, {0.7, -1.2}, dt, n),
                 b = trapezoidal_oscillator(omega, zeta, {0.7, -1.2}, dt, n + 1);
    const auto slope = [](const Motion& m) {
      return -2.0 * zeta * omega * m.velocity - omega * omega * m.displacement;
    };
    EXPECT_NEAR(b.displacement - a.displacement, 0.5 * dt * (a.velocity + b.velocity), 1e-14);
    EXPECT_NEAR(b.velocity - a.velocity, 0.5 * dt * (slope(a) + slope(b)), 1e-14);
  }
}

TEST(Rod, FreeEndMovesTwiceTheBaseAfterOnePassage) {
  // L / c = 1; until 3 only the first wave has come: twice the base's motion of one second before.
  EXPECT_EQ(rod_free_end(1.0, 1.0, 2.0, 2.0, 0.5), -1.0);
  EXPECT_NEAR(rod_free_end(1.0, 1.0, 2.0, 2.0, 1.5), 2.0, 1e-15);
  EXPECT_NEAR(rod_free_end(1.0, 1.0, 2.0, 2.0, 3.5), -2.0, 1e-15);
}

TEST(Rod, PulseHasItsAcceleration) {
  constexpr double h = 1e-4;
  for (const double t : {0.1, 0.33, 0.7}) {
    const double second =
        (smooth_pulse(1.0, 1.0, t + h) - 2.0 * smooth_pulse(1.0, 1.0, t) + smooth_pulse(1.0, 1.0, t - h)) / (h * h);
    // h²/12 times the fourth derivative, which stays below (2π)⁴ · 6
    EXPECT_NEAR(smooth_pulse_acceleration(1.0, 1.0, t), second, 1e-5);
  }
}

TEST(ShakenRod, MovesWithTheInverseGroundUntilTheFirstWaveAndIsTheSumOfItsModesAfterwards) {
  const double forcing = 3.0;
  EXPECT_EQ(shaken_rod_free_end(1.0, forcing, 0.9), -(0.9 / forcing - std::sin(forcing * 0.9) / (forcing * forcing)));
  // fixed-free modes: participation 2 / κ, (-1)^n at the free end, κ = (n + ½) π; their terms fall like n^-4
  for (const double t : {0.4, 1.7, 3.9}) {
    double sum = 0.0;
    for (int n = 0; n < 2000; ++n) {
      const double k = (n + 0.5) * std::numbers::pi;
      sum -= 2.0 / k * (n % 2 == 0 ? 1.0 : -1.0) * forced_oscillator(k, 0.0, 1.0, forcing, t).displacement;
    }
    EXPECT_NEAR(shaken_rod_free_end(1.0, forcing, t), sum, 1e-9) << t;
  }
}

TEST(AlphaSchemes, NearTheStepResponseWithOrderTwo) {
  const auto error = [](auto scheme, int steps) {
    return std::abs(scheme(6.0 / steps, steps) - 36.0 * ramped_oscillator(6.0, 0.1, 1.0, 0.0, 1.0).displacement);
  };
  const auto hht = [](double phase, int n) { return hht_alpha_step_response(0.7, phase, 0.1, n); };
  const auto alpha = [](double phase, int n) { return generalised_alpha_step_response(0.3, phase, 0.1, n); };
  EXPECT_NEAR(error(hht, 400) / error(hht, 800), 4.0, 0.2);  // the next term is a few times the phase, 0.015
  EXPECT_NEAR(error(alpha, 400) / error(alpha, 800), 4.0, 0.2);
  // ρ = 1 is average acceleration for both, which the trapezoidal rule has in closed form
  const double rule = 1.0 - trapezoidal_oscillator(0.4, 0.1, {1.0, 0.0}, 1.0, 50).displacement;
  EXPECT_NEAR(hht_alpha_step_response(1.0, 0.4, 0.1, 50), rule, 1e-13);
  EXPECT_NEAR(generalised_alpha_step_response(1.0, 0.4, 0.1, 50), rule, 1e-13);
}

}  // namespace
}  // namespace sunder::exact
