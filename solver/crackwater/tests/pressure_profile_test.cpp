#include "solver/crackwater/pressure_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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

/// Closed forms in 40 digits, by a route of their own (power series and logarithms).
struct Reference {
  const char* description;
  double rate, upstream_flux, downstream_flux, front, uplift, moment, peak, peak_position;
  double pressures[8];  // at s = 1, 2, 5, 9, 10, 20, 30, 40 m
};

constexpr int stations[] = {1, 2, 5, 9, 10, 20, 30, 40};

const Reference references[] = {
    {"opening",
     0.10,
     0.883384970736352501,
     0.0,
     9.92930673144195245,
     1233201.40063765116,
     2469952.8430652634,
     490500.0,
     0.0,
     {358998.02793544358, 252998.30199384329, 61971.065899252569, 426.35452880864611, 0.0, 0.0, 0.0, 0.0}},
    {"static",
     0.0,
     0.139790782835389583,
     0.139790782835389583,
     45.0,
     14715000.0,
     255794468.574563571,
     490500.0,
     0.0,
     {486805.20136346421, 482983.72933884298, 470698.96193771626, 452148.14814814815, 447070.3125, 383724.48979591837,
      286125.0, 124260.0}},
    {"closing",
     -0.10,
     -1.65874217599189056,
     0.591257824008109439,
     45.0,
     146995198.365368616,
     3233771452.03903502,
     4305211.58973300819,
     21.9320126233930305,
     {980046.7003362356, 1426715.9787285993, 2527393.233229424, 3505941.1864019278, 3676086.6905890576,
      4302500.4137781886, 4107988.121268818, 2159618.4727271015}},
};

TEST(PressureProfile, MeetsTheClosedFormsOfTheReferenceCrack) {
  for (const int segments : {1, 5, 45, 450}) {
    // The rule is exact for linear apertures and rates, so the bar of 450 segments holds for one segment too.
    const double tolerance = 1e-12;
    for (const Search search : all_searches) {
      PressureSolver solver(straight_crack(45.0, segments), {}, {.search = search});
      for (const Reference& expected : references) {
        const Motion motion = reference_motion(segments, expected.rate);
        const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
        SCOPED_TRACE(testing::Message() << expected.description << " " << segments << " " << static_cast<int>(search));
        ASSERT_EQ(p.status, ProfileStatus::converged);
        EXPECT_LE(relative(p.upstream_flux, expected.upstream_flux), tolerance);
        EXPECT_NEAR(p.downstream_flux, expected.downstream_flux, tolerance * 2.25);  // flux less V(L) = ± 2.25
        EXPECT_LE(relative(p.front_position, expected.front), tolerance);
        EXPECT_LE(relative(p.uplift_force, expected.uplift), tolerance);
        EXPECT_LE(relative(p.uplift_moment, expected.moment), tolerance);
        EXPECT_LE(relative(p.peak_pressure, expected.peak), tolerance);
        EXPECT_NEAR(p.peak_position, expected.peak_position, 45.0 * tolerance);
        EXPECT_EQ(p.cavitated, expected.rate > 0.0);
        EXPECT_FALSE(p.at_regime_jump);
        if (segments % 45 != 0) continue;
        for (std::size_t k = 0; k < 8; ++k) {
          const std::size_t node = static_cast<std::size_t>(stations[k] * segments / 45);
          EXPECT_NEAR(p.pressure[node], expected.pressures[k], tolerance * expected.peak) << stations[k];
        }
      }
    }
  }
}

TEST(PressureProfile, MeetsTheTurbulentAndTheLaminarLimit) {
  const int n = 45;
  // A viscosity or density small enough moves the switch out of sight; the pressures are given in Pa.
  const Water turbulent{.dynamic_viscosity = 1e-24}, laminar{.density = 1e-9};
  PressureSolver fast(straight_crack(45.0, n), turbulent);
  Motion motion = reference_motion(n, 0.10);
  const PressureProfile* p = &fast.solve(motion.apertures, motion.rates, {reference_head, 0.0});
  EXPECT_LE(relative(p->front_position, 9.92930672322720308), 1e-12);
  EXPECT_LE(relative(p->uplift_force, 1233201.40791733722), 1e-12);
  motion = reference_motion(n, -0.10);
  p = &fast.solve(motion.apertures, motion.rates, {reference_head, 0.0});
  EXPECT_LE(relative(p->upstream_flux, -1.65874217599223899), 1e-12);
  EXPECT_LE(relative(p->uplift_force, 146995198.365410936), 1e-12);

  const double rates[] = {0.10, 0.0, -0.10};
  const double fluxes[] = {75.4869221704383929, 73.6458052537980647, 71.8046883371577366};
  const double uplifts[] = {14673922.6143785545, 14715000.0, 14756077.3856214455};
  PressureSolver slow(straight_crack(45.0, n), laminar);
  for (std::size_t k = 0; k < 3; ++k) {
    motion = reference_motion(n, rates[k]);
    p = &slow.solve(motion.apertures, motion.rates, {reference_head, 0.0});
    EXPECT_LE(relative(p->upstream_flux, fluxes[k]), 1e-12);
    EXPECT_LE(relative(p->uplift_force, uplifts[k]), 1e-12);
    EXPECT_FALSE(p->cavitated);
  }
}

TEST(PressureProfile, ReproducesTheMidpointSchemeOfTheSeedPaper) {
  for (const Search search : all_searches) {
    PressureSolver solver(straight_crack(45.0, 450), {}, {.quadrature = Quadrature::midpoint, .search = search});
    Motion motion = reference_motion(450, -0.10);
    const PressureProfile* p = &solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
    EXPECT_LE(relative(p->upstream_flux, -1.65874234060234), 1e-12);  // given to 15 digits
    EXPECT_LE(relative(p->uplift_force, 146994000.725856), 1e-12);
    motion = reference_motion(450, 0.0);
    p = &solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
    EXPECT_LE(relative(p->upstream_flux, 0.139790890698447), 1e-12);
    EXPECT_LE(relative(p->uplift_force, 14714975.777837213), 1e-12);
    motion = reference_motion(450, 0.10);
    p = &solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
    EXPECT_LE(relative(p->uplift_force, 1233302.073280455), 1e-12);
  }
}

TEST(PressureProfile, MidpointRuleIsOfSecondOrder) {
  for (const double rate : {0.0, -0.10}) {
    const Reference& expected = rate == 0.0 ? references[1] : references[2];
    double before_flux = 0.0, before_uplift = 0.0;
    for (const int segments : {90, 180, 360, 720}) {
      PressureSolver solver(straight_crack(45.0, segments), {}, {.quadrature = Quadrature::midpoint});
      const Motion motion = reference_motion(segments, rate);
      const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
      const double flux = std::abs(p.upstream_flux - expected.upstream_flux);
      const double uplift = std::abs(p.uplift_force - expected.uplift);
      if (before_flux > 0.0) {
        EXPECT_NEAR(std::log2(before_flux / flux), 2.0, 0.1);
        EXPECT_NEAR(std::log2(before_uplift / uplift), 2.0, 0.1);
      }
      before_flux = flux;
      before_uplift = uplift;
    }
  }
}

TEST(PressureProfile, FillsACrackWithAClosedTip) {
  for (const int segments : {3, 450}) {
    PressureSolver solver(straight_crack(45.0, segments), {});
    Motion motion = reference_motion(segments, -0.10);
    const PressureProfile* p = &solver.solve(motion.apertures, motion.rates, {reference_head, {}});
    EXPECT_LE(relative(p->upstream_flux, -2.25), 1e-14);  // all that the closing displaces
    EXPECT_LE(relative(p->pressure.back(), 11971999.7779086799), 1e-12);
    EXPECT_LE(relative(p->uplift_force, 431671539.088487577), 1e-12);
    EXPECT_EQ(p->downstream_flux, 0.0);
    motion = reference_motion(segments, 0.0);
    p = &solver.solve(motion.apertures, motion.rates, {reference_head, {}});
    EXPECT_LE(relative(p->uplift_force, 22072500.0), 1e-14);
    EXPECT_EQ(p->upstream_flux, 0.0);
    motion = reference_motion(segments, 0.10);
    p = &solver.solve(motion.apertures, motion.rates, {reference_head, {}});
    EXPECT_LE(relative(p->uplift_force, references[0].uplift), 1e-12);
    EXPECT_LE(relative(p->front_position, references[0].front), 1e-12);
    EXPECT_TRUE(p->cavitated);
  }
}

TEST(PressureProfile, HasTwoWetRegionsBetweenMouthsUnderHead) {
  const int n = 90;
  for (const Search search : all_searches) {
    PressureSolver solver(straight_crack(45.0, n), {}, {.search = search});
    const Motion motion = linear_motion(n, 0.10, 0.05, 0.10, 0.08);
    const PressureProfile both = solver.solve(motion.apertures, motion.rates, {reference_head, 0.4 * reference_head});
    ASSERT_EQ(both.status, ProfileStatus::converged);
    ASSERT_EQ(both.wet_regions.size(), 2u);
    EXPECT_LT(both.wet_regions[0].end, both.wet_regions[1].start);
    // a void between them: each is its own problem
    const PressureProfile upstream = solver.solve(motion.apertures, motion.rates, {reference_head, 0.0});
    EXPECT_LE(relative(both.wet_regions[0].end, upstream.front_position), 1e-13);
    EXPECT_LE(relative(both.upstream_flux, upstream.upstream_flux), 1e-13);
    Motion mirrored = motion;
    std::reverse(mirrored.apertures.begin(), mirrored.apertures.end());
    std::reverse(mirrored.rates.begin(), mirrored.rates.end());
    const PressureProfile downstream = solver.solve(mirrored.apertures, mirrored.rates, {0.4 * reference_head, 0.0});
    EXPECT_NEAR(45.0 - both.wet_regions[1].start, downstream.front_position, 1e-12 * 45.0);
    EXPECT_NEAR(both.downstream_flux, -downstream.upstream_flux, 1e-12 * 4.05);  // V(L) = 4.05 m²/s
    EXPECT_LE(relative(both.uplift_force, upstream.uplift_force + downstream.uplift_force), 1e-12);
  }
}

TEST(PressureProfile, IsTheSameSeenFromEitherMouth) {
  const int n = 60;
  PressureSolver solver(straight_crack(30.0, n), {});
  for (const double phase : {0.0, 0.7, 2.0, 3.5, 5.0}) {
    Motion motion;
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n;
      motion.apertures.push_back(0.04 + 0.02 * std::sin(5.0 * x));
      motion.rates.push_back(0.05 * std::sin(9.0 * x + phase));
    }
    const PressureProfile here = solver.solve(motion.apertures, motion.rates, {3e5, 1e5});
    Motion mirrored = motion;
    std::reverse(mirrored.apertures.begin(), mirrored.apertures.end());
    std::reverse(mirrored.rates.begin(), mirrored.rates.end());
    const PressureProfile there = solver.solve(mirrored.apertures, mirrored.rates, {1e5, 3e5});
    ASSERT_EQ(here.status, ProfileStatus::converged);
    ASSERT_EQ(there.status, ProfileStatus::converged);
    ASSERT_EQ(here.wet_regions.size(), there.wet_regions.size());
    const double scale = std::max(here.peak_pressure, 3e5);
    for (int i = 0; i <= n; ++i) {
      EXPECT_NEAR(here.pressure[static_cast<std::size_t>(i)], there.pressure[static_cast<std::size_t>(n - i)],
                  1e-12 * scale);
    }
    EXPECT_LE(relative(here.uplift_force, there.uplift_force), 1e-12);
    EXPECT_NEAR(here.upstream_flux, -there.downstream_flux, 1e-12);
    const PressureProfile again = solver.solve(mirrored.apertures, mirrored.rates, {1e5, 3e5});
    EXPECT_EQ(again.pressure, there.pressure);  // the same bits
    EXPECT_EQ(again.uplift_force, there.uplift_force);
  }
}

TEST(PressureProfile, UniformModelCarriesTheMouthPressureEverywhere) {
  PressureSolver level(straight_crack(14.5, 29), {});
  const PressureProfile* p = &level.uniform(336e3);
  EXPECT_LE(relative(p->uplift_force, 14.5 * 336e3), 8.0 * epsilon);
  EXPECT_LE(relative(p->uplift_moment, 0.5 * 14.5 * 14.5 * 336e3), 8.0 * epsilon);
  EXPECT_EQ(p->pressure[17], 336e3);
  p = &level.uniform(-1.0);
  EXPECT_EQ(p->uplift_force, 0.0);
  EXPECT_TRUE(p->mouth_below_zero);
  CrackLine rising = straight_crack(10.0, 10);
  rising.rises.assign(10, 0.5);
  PressureSolver inclined(rising, {});
  EXPECT_NEAR(inclined.uniform(1e5).pressure.back(), 1e5 - 5.0 * 9810.0, 1e-9);
}

TEST(PressureProfile, RefusesWhatItCannotUse) {
  EXPECT_THROW(straight_crack(45.0, 0), std::invalid_argument);
  EXPECT_THROW(straight_crack(-1.0, 3), std::invalid_argument);
  EXPECT_THROW(PressureSolver({{1.0, 0.0}, {}}, {}), std::invalid_argument);
  EXPECT_THROW(PressureSolver({{1.0, 1.0}, {0.1}}, {}), std::invalid_argument);
  EXPECT_THROW(PressureSolver({{1.0, 1.0}, {0.1, 1.1}}, {}), std::invalid_argument);
  EXPECT_THROW(PressureSolver({}, {}), std::invalid_argument);
  EXPECT_THROW(PressureSolver(straight_crack(1.0, 1), {}, {.relative_tolerance = 1.0}), std::invalid_argument);
  EXPECT_THROW(PressureSolver(straight_crack(1.0, 1), {}, {.max_evaluations = 1}), std::invalid_argument);

  PressureSolver solver(straight_crack(45.0, 7), {});
  const Motion good = reference_motion(7, 0.1);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node <= 7; ++node) {
    for (const double bad : {nan, infinity, 0.0, -1.0}) {
      Motion motion = good;
      motion.apertures[node] = bad;
      EXPECT_EQ(solver.solve(motion.apertures, motion.rates, {1e5, 0.0}).status, ProfileStatus::unusable_input);
    }
    for (const double bad : {nan, infinity, -infinity}) {
      Motion motion = good;
      motion.rates[node] = bad;
      EXPECT_EQ(solver.solve(motion.apertures, motion.rates, {1e5, 0.0}).status, ProfileStatus::unusable_input);
    }
  }
  const CrackLine line = straight_crack(45.0, 7);
  EXPECT_NO_THROW(check(line, good.apertures, good.rates));
  Motion bad = good;
  bad.apertures[3] = 0.0;
  EXPECT_THROW(check(line, bad.apertures, bad.rates), std::invalid_argument);
  EXPECT_THROW(check(line, good.apertures, reference_motion(6, 0.1).rates), std::invalid_argument);
  bad = good;
  bad.rates[7] = nan;
  EXPECT_THROW(check(line, bad.apertures, bad.rates), std::invalid_argument);
  EXPECT_EQ(solver.solve(good.apertures, good.rates, {nan, 0.0}).status, ProfileStatus::unusable_input);
  EXPECT_EQ(solver.solve(good.apertures, good.rates, {1e5, infinity}).status, ProfileStatus::unusable_input);
  EXPECT_EQ(solver.solve(reference_motion(6, 0.1).apertures, good.rates, {1e5, 0.0}).status,
            ProfileStatus::unusable_input);
  EXPECT_EQ(solver.solve(good.apertures, good.rates, {1e5, 0.0}).status, ProfileStatus::converged);
}

}  // namespace
}  // namespace sunder::crackwater
