// How the flux is found: the band without a root, jumps of an unsplit rule, searches that stop at a tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/tests/reference_crack.hpp"

namespace sunder::crackwater {
namespace {

using tests::all_searches;
using tests::linear_motion;
using tests::Motion;
using tests::reference_head;
using tests::reference_motion;
using tests::relative;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(FluxSearch, ClosesTheBandWithoutARootAtTheRegimeJump) {
  const int n = 450;
  const FlowLaw law = flow_law({});
  const double cubes = 45.0 / std::pow(0.03, 3), head_below = law.laminar * law.critical_flux * cubes;
  const Motion motion = linear_motion(n, 0.03, 0.03, 0.0, 0.0);
  const double jump = resistance_jump(0.5);
  for (const double factor : {1.0 + 1e-9, 1.5, 2.0, 3.0, 4.3}) {
    for (const Search search : all_searches) {
      for (const Quadrature quadrature : {Quadrature::exact, Quadrature::midpoint}) {
        PressureSolver solver(straight_crack(45.0, n), {}, {.quadrature = quadrature, .search = search});
        const double head = factor * head_below;
        const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {head, 0.0});
        SCOPED_TRACE(testing::Message() << factor << " " << static_cast<int>(search) << static_cast<int>(quadrature));
        ASSERT_EQ(p.status, ProfileStatus::converged);
        EXPECT_TRUE(p.at_regime_jump);
        EXPECT_LE(relative(p.upstream_flux, law.critical_flux), 4.0 * epsilon);
        EXPECT_NEAR(p.turbulent_share, (factor - 1.0) / (jump - 1.0), 1e-12);
        EXPECT_LE(p.residual, 1e-12 * head);
        for (std::size_t i = 0; i <= n; ++i) {  // a uniform crack at rest: linear
          EXPECT_NEAR(p.pressure[i], head * (1.0 - static_cast<double>(i) / n), 1e-12 * head);
        }
        EXPECT_LE(relative(p.uplift_force, 22.5 * head), 1e-12);
        EXPECT_LE(p.residual_evaluations, 70);
        const PressureProfile& back = solver.solve(motion.apertures, motion.rates, {0.0, head});
        EXPECT_TRUE(back.at_regime_jump);
        EXPECT_LE(relative(back.upstream_flux, -law.critical_flux), 4.0 * epsilon);
      }
    }
  }
}

TEST(FluxSearch, ReportsAJumpThatAnUnsplitRuleMeets) {
  // Zero head and uniform closing: by symmetry the flux is zero in the middle, where the midpoint rule of an even
  // number of segments meets both signs of ± h v / 2, far from the switch; an odd number leaves one segment at zero.
  for (const int n : {449, 450}) {
    for (const Search search : all_searches) {
      PressureSolver solver(straight_crack(45.0, n), {}, {.quadrature = Quadrature::midpoint, .search = search});
      const Motion motion = linear_motion(n, 0.03, 0.03, -1e-3, -1e-3);
      const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {0.0, 0.0});
      ASSERT_EQ(p.status, ProfileStatus::converged);
      EXPECT_NEAR(p.upstream_flux, -0.0225, 1e-3);
      EXPECT_NEAR(p.pressure.front(), 0.0, 1e-12 * p.peak_pressure);
      EXPECT_NEAR(p.pressure.back(), 0.0, 1e-12 * p.peak_pressure);
      EXPECT_LE(p.residual_evaluations, 70);
    }
    PressureSolver exact(straight_crack(45.0, n), {});
    const Motion motion = linear_motion(n, 0.03, 0.03, -1e-3, -1e-3);
    const PressureProfile& p = exact.solve(motion.apertures, motion.rates, {0.0, 0.0});
    EXPECT_NEAR(p.upstream_flux, -0.0225, 1e-12 * 0.0225);  // half of what is displaced leaves by each mouth
    EXPECT_FALSE(p.at_regime_jump);
  }
}

TEST(FluxSearch, AnswersToATolerance) {
  Motion island = linear_motion(450, 0.10, 0.05, 0.0, 0.0);
  for (std::size_t i = 0; i < island.rates.size(); ++i)
    island.rates[i] = 0.1 * std::sin(8.0 * static_cast<double>(i) / 450.0);
  struct Case {
    const char* description;
    Motion motion;
    MouthPressures mouths;
  };
  const Case cases[] = {
      {"opening", reference_motion(450, 0.10), {reference_head, 0.0}},
      {"static", reference_motion(450, 0.0), {reference_head, 0.0}},
      {"closing", reference_motion(450, -0.10), {reference_head, 0.0}},
      {"two mouths", linear_motion(450, 0.10, 0.05, 0.10, 0.08), {reference_head, 0.4 * reference_head}},
      {"islands", island, {reference_head, 1e5}},
      {"islands, closed tip", island, {reference_head, {}}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.description);
    PressureSolver to_round_off(straight_crack(45.0, 450), {});
    const PressureProfile exact = to_round_off.solve(c.motion.apertures, c.motion.rates, c.mouths);
    ASSERT_EQ(exact.status, ProfileStatus::converged);
    for (const double tolerance : {1e-2, 1e-3, 1e-6, 1e-9}) {
      for (const Search search : all_searches) {
        for (const Quadrature quadrature : {Quadrature::exact, Quadrature::midpoint}) {
          SCOPED_TRACE(testing::Message() << tolerance << " " << static_cast<int>(search));
          PressureSolver solver(straight_crack(45.0, 450), {},
                                {.quadrature = quadrature, .search = search, .relative_tolerance = tolerance});
          const PressureProfile& p = solver.solve(c.motion.apertures, c.motion.rates, c.mouths);
          EXPECT_EQ(p.status, ProfileStatus::converged);
          for (const double pressure : p.pressure) ASSERT_GE(pressure, 0.0);
          if (quadrature == Quadrature::midpoint) continue;
          // bracket over its larger end
          EXPECT_LE(std::abs(p.upstream_flux - exact.upstream_flux), 2.0 * tolerance * std::abs(exact.upstream_flux));
        }
      }
    }
  }
  // In the band without a root no bracket is narrow enough: the jump is found, whatever the tolerance.
  for (const Search search : all_searches) {
    PressureSolver solver(straight_crack(45.0, 450), {}, {.search = search, .relative_tolerance = 1e-3});
    const Motion still = linear_motion(450, 0.03, 0.03, 0.0, 0.0);
    const PressureProfile& p = solver.solve(still.apertures, still.rates, {200.0, 0.0});
    EXPECT_EQ(p.status, ProfileStatus::converged);
    EXPECT_TRUE(p.at_regime_jump);
    EXPECT_NEAR(p.pressure[225], 100.0, 1e-10);
  }
}

}  // namespace
}  // namespace sunder::crackwater
