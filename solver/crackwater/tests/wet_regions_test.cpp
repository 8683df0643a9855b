#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/tests/reference_crack.hpp"

namespace sunder::crackwater {
namespace {

using tests::all_searches;
using tests::linear_motion;
using tests::Motion;
using tests::reference_head;

/// A crack that breathes at random: apertures over a decade, rates of both signs or one.
Motion random_motion(int n, std::mt19937& random, double mean_rate) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double phase = 6.3 * unit(random), waves = 3.0 + 12.0 * unit(random), tilt = unit(random);
  Motion motion;
  for (int i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / n;
    motion.apertures.push_back(0.02 * std::pow(10.0, 0.5 * std::sin(4.0 * x + phase) - 0.4 * tilt * x));
    motion.rates.push_back(0.02 * (mean_rate + std::sin(waves * x + phase) + 0.3 * std::sin(31.0 * x)));
  }
  return motion;
}

Motion refined(const Motion& motion, int parts) {
  Motion fine;
  for (std::size_t i = 0; i + 1 < motion.apertures.size(); ++i) {
    for (int k = 0; k < parts; ++k) {
      const double y = static_cast<double>(k) / parts;
      fine.apertures.push_back((1.0 - y) * motion.apertures[i] + y * motion.apertures[i + 1]);
      fine.rates.push_back((1.0 - y) * motion.rates[i] + y * motion.rates[i + 1]);
    }
  }
  fine.apertures.push_back(motion.apertures.back());
  fine.rates.push_back(motion.rates.back());
  return fine;
}

struct Ends {
  const char* description;
  MouthPressures mouths;
};

const Ends all_ends[] = {{"through", {2e5, 0.0}},   {"both mouths", {2e5, 1e5}}, {"downstream higher", {3e4, 2e5}},
                         {"closed tip", {2e5, {}}}, {"no head", {0.0, 0.0}},     {"downstream alone", {0.0, 2e5}}};

TEST(WetRegions, DoNotDependOnHowTheCrackIsCut) {
  // The exact rule is exact for piecewise linear motion, so cutting each segment in four must change nothing.
  std::mt19937 random(7);
  int islands = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const int n = 23;
    const Motion motion = random_motion(n, random, 0.05 * (sample % 7) - 0.1), fine = refined(motion, 4);
    for (const Ends& ends : all_ends) {
      SCOPED_TRACE(testing::Message() << sample << " " << ends.description);
      PressureSolver coarse_solver(straight_crack(30.0, n), {}), fine_solver(straight_crack(30.0, 4 * n), {});
      const PressureProfile& a = coarse_solver.solve(motion.apertures, motion.rates, ends.mouths);
      const PressureProfile& b = fine_solver.solve(fine.apertures, fine.rates, ends.mouths);
      ASSERT_EQ(a.status, ProfileStatus::converged);
      ASSERT_EQ(b.status, ProfileStatus::converged);
      ASSERT_EQ(a.wet_regions.size(), b.wet_regions.size());
      const double scale = std::max(a.peak_pressure, 2e5);
      for (std::size_t i = 0; i <= n; ++i) EXPECT_NEAR(a.pressure[i], b.pressure[4 * i], 1e-10 * scale) << i;
      EXPECT_NEAR(a.uplift_force, b.uplift_force, 1e-11 * 30.0 * scale);
      EXPECT_NEAR(a.uplift_moment, b.uplift_moment, 1e-11 * 900.0 * scale);
      EXPECT_NEAR(a.peak_pressure, b.peak_pressure, 1e-10 * scale);
      islands += a.wet_regions.size() > 2 ? 1 : 0;
    }
  }
  EXPECT_GT(islands, 20);  // the samples do hold islands between voids
}

TEST(WetRegions, FulfilTheComplementarityConditions) {
  std::mt19937 random(11);
  const int n = 40;
  const double length = 30.0;
  for (int sample = 0; sample < 60; ++sample) {
    const Motion motion = random_motion(n, random, 0.05 * (sample % 9) - 0.1);
    for (const Ends& ends : all_ends) {
      for (const Search search : all_searches) {
        SCOPED_TRACE(testing::Message() << sample << " " << ends.description << " " << static_cast<int>(search));
        PressureSolver solver(straight_crack(length, n), {}, {.search = search});
        const PressureProfile& p = solver.solve(motion.apertures, motion.rates, ends.mouths);
        ASSERT_EQ(p.status, ProfileStatus::converged);
        for (const double pressure : p.pressure) EXPECT_GE(pressure, 0.0);
        EXPECT_EQ(p.pressure.front(), ends.mouths.upstream);
        if (ends.mouths.downstream) {
          EXPECT_NEAR(p.pressure.back(), *ends.mouths.downstream, 1e-12 * std::max(p.peak_pressure, 2e5));
        }
        // m = q + V never falls: constants grow from region to region, and V grows over every void
        double end = 0.0, constant = -std::numeric_limits<double>::infinity();
        const auto growing = [&](double from, double to) {
          for (int i = 0; i <= n; ++i) {
            const double s = length * i / n;
            if (s > from && s < to) {
              EXPECT_GE(motion.rates[static_cast<std::size_t>(i)], -1e-12) << s;
            }
          }
        };
        for (const WetRegion& region : p.wet_regions) {
          EXPECT_GE(region.start, end - 1e-9);
          EXPECT_GT(region.end, region.start);
          EXPECT_GE(region.flux_constant, constant - 1e-12);
          growing(end, region.start);
          end = region.end;
          constant = region.flux_constant;
        }
        growing(end, length);
        // p grows from nothing between: every node inside a region is wet, every node in a void dry
        for (int i = 0; i <= n; ++i) {
          const double s = length * i / n;
          const bool wet = std::any_of(p.wet_regions.begin(), p.wet_regions.end(), [&](const WetRegion& region) {
            return s > region.start - 1e-9 && s < region.end + 1e-9;
          });
          if (!wet) {
            EXPECT_EQ(p.pressure[static_cast<std::size_t>(i)], 0.0) << s;
          }
        }
      }
    }
  }
}

/// The midpoint scheme by pooling adjacent violators: another algorithm for the same convex problem.
std::vector<double> pooled_constants(const Motion& motion, double length, double up, double down) {
  const FlowLaw law = flow_law({});
  const int n = static_cast<int>(motion.apertures.size()) - 1;
  const double h = length / n;
  std::vector<double> change(static_cast<std::size_t>(n)), cube(static_cast<std::size_t>(n));
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    const double v0 = motion.rates[i], v1 = motion.rates[i + 1];
    change[i] = sum + h * (3.0 * v0 + v1) / 8.0;
    sum += 0.5 * h * (v0 + v1);
    const double w = 0.5 * (motion.apertures[i] + motion.apertures[i + 1]);
    cube[i] = h / (w * w * w);
  }
  struct Block {
    int first, last;
    double constant;
  };
  const auto solve = [&](Block& block) {
    double low = -1e3, high = 1e3;
    for (int halving = 0; halving < 120; ++halving) {
      const double c = 0.5 * (low + high);
      double end = (block.first == 0 ? up : 0.0) - (block.last == n ? down : 0.0);
      for (int i = block.first; i < block.last; ++i) {
        end -= resistance(law, c - change[static_cast<std::size_t>(i)]) * cube[static_cast<std::size_t>(i)];
      }
      (end > 0.0 ? low : high) = c;
    }
    block.constant = low;
  };
  std::vector<Block> blocks;
  for (int i = 0; i < n; ++i) {
    blocks.push_back({i, i + 1, 0.0});
    solve(blocks.back());
    while (blocks.size() > 1 && blocks[blocks.size() - 2].constant > blocks.back().constant) {
      blocks[blocks.size() - 2].last = blocks.back().last;
      blocks.pop_back();
      solve(blocks.back());
    }
  }
  std::vector<double> constants;
  for (const Block& block : blocks)
    constants.insert(constants.end(), static_cast<std::size_t>(block.last - block.first), block.constant);
  return constants;
}

TEST(WetRegions, AgreeWithPoolingAdjacentViolators) {
  std::mt19937 random(3);
  const int n = 24;
  for (int sample = 0; sample < 40; ++sample) {
    const Motion motion = random_motion(n, random, 0.05 * (sample % 5));
    PressureSolver solver(straight_crack(30.0, n), {}, {.quadrature = Quadrature::midpoint});
    const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {2e5, 1e5});
    ASSERT_EQ(p.status, ProfileStatus::converged);
    const std::vector<double> constants = pooled_constants(motion, 30.0, 2e5, 1e5);
    for (const WetRegion& region : p.wet_regions) {
      for (int i = 0; i < n; ++i) {
        const double middle = 30.0 * (i + 0.5) / n;
        if (middle > region.start && middle < region.end) {
          // bisection to 1e-13 of fluxes below 1 m²/s; the pressures of a block agree to the same
          EXPECT_NEAR(constants[static_cast<std::size_t>(i)], region.flux_constant, 1e-11) << sample << " " << i;
        }
      }
    }
    EXPECT_NEAR(p.upstream_flux, constants.front(), 1e-11);
  }
}

TEST(WetRegions, StandExtremes) {
  std::mt19937 random(5);
  for (const double aperture : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    for (const double rate : {0.0, 1e-9, -1e-9, 1e-3, -1e-3, 1.0, -1.0, 1e3, -1e3}) {
      for (const double viscosity : {1e-12, 1e-3, 1e12}) {
        for (const Search search : all_searches) {
          for (const Ends& ends : all_ends) {
            SCOPED_TRACE(testing::Message() << aperture << " " << rate << " " << viscosity << " "
                                            << static_cast<int>(search) << " " << ends.description);
            PressureSolver solver(straight_crack(45.0, 9), {.dynamic_viscosity = viscosity}, {.search = search});
            const Motion motion = linear_motion(9, aperture, 3.0 * aperture, rate, -0.2 * rate);
            const PressureProfile& p = solver.solve(motion.apertures, motion.rates, ends.mouths);
            ASSERT_EQ(p.status, ProfileStatus::converged);
            const double scale = std::max(p.peak_pressure, 2e5);
            for (const double pressure : p.pressure) ASSERT_TRUE(pressure >= 0.0 && pressure <= scale);
            if (ends.mouths.downstream) {
              EXPECT_NEAR(p.pressure.back(), *ends.mouths.downstream, 1e-12 * scale);
            }
            EXPECT_TRUE(std::isfinite(p.uplift_force) && std::isfinite(p.upstream_flux));
            // a search of each wet region and one for the whole crack, below 70 residuals each
            EXPECT_LE(p.residual_evaluations, 70 * static_cast<int>(p.wet_regions.size() + 1));
          }
        }
      }
    }
  }
  // one node on a roughness of 1e-12 m between wide ones
  Motion pinched = linear_motion(10, 0.05, 0.05, -0.01, -0.01);
  pinched.apertures[5] = 1e-12;
  PressureSolver solver(straight_crack(10.0, 10), {});
  const PressureProfile& p = solver.solve(pinched.apertures, pinched.rates, {2e5, 0.0});
  EXPECT_EQ(p.status, ProfileStatus::converged);
  EXPECT_TRUE(std::isfinite(p.peak_pressure));
}

TEST(WetRegions, CrossTheSwitchAtEveryDistance) {
  // A crack at rest whose flux lies at 2300 (1 ± 1e-k), and moving so slowly that the switch is met somewhere inside.
  const FlowLaw law = flow_law({});
  const double cubes = 45.0 / std::pow(0.03, 3);
  for (const Search search : all_searches) {
    PressureSolver solver(straight_crack(45.0, 45), {}, {.search = search});
    for (int k = 1; k <= 14; ++k) {
      for (const double sign : {1.0, -1.0}) {
        const double flux = law.critical_flux * (1.0 + sign * std::pow(10.0, -k));
        const double head = resistance(law, flux) * cubes;
        Motion motion = linear_motion(45, 0.03, 0.03, 0.0, 0.0);
        const PressureProfile* p = &solver.solve(motion.apertures, motion.rates, {head, 0.0});
        ASSERT_EQ(p->status, ProfileStatus::converged);
        EXPECT_NEAR(p->upstream_flux, flux, 1e-13 * flux);
        EXPECT_FALSE(p->at_regime_jump);
        EXPECT_NEAR(p->uplift_force, 22.5 * head, 1e-12 * 22.5 * head);
        const double rate = std::pow(10.0, -k) * law.critical_flux;
        motion = linear_motion(45, 0.03, 0.03, -rate, -rate);
        p = &solver.solve(motion.apertures, motion.rates, {2.0 * law.laminar * law.critical_flux * cubes, 0.0});
        ASSERT_EQ(p->status, ProfileStatus::converged);
        EXPECT_NEAR(p->pressure.back(), 0.0, 1e-12 * head);
      }
    }
  }
}

TEST(WetRegions, CarryTheWeightOfWaterInAnInclinedCrack) {
  const double gamma = 9810.0;
  CrackLine rising = straight_crack(20.0, 40);
  rising.rises.assign(40, 0.25);  // 10 m in all
  PressureSolver solver(rising, {});
  Motion motion = linear_motion(40, 0.05, 0.03, 0.0, 0.0);
  // a closed tip at rest: hydrostatic
  const PressureProfile* p = &solver.solve(motion.apertures, motion.rates, {2e5, {}});
  for (std::size_t i = 0; i <= 40; ++i)
    EXPECT_NEAR(p->pressure[i], 2e5 - 0.25 * gamma * static_cast<double>(i), 1e-12 * 2e5);
  EXPECT_NEAR(p->uplift_force, 20.0 * (2e5 - 5.0 * gamma), 1e-12 * 4e6);
  EXPECT_NEAR(p->uplift_moment, 200.0 * 2e5 - 0.5 * gamma * 8000.0 / 3.0, 1e-12 * 4e7);
  // mouths in hydrostatic balance: no flow
  p = &solver.solve(motion.apertures, motion.rates, {2e5, 2e5 - 10.0 * gamma});
  EXPECT_NEAR(p->upstream_flux, 0.0, 1e-9);  // |F| ≤ 8 ε · 4e5 Pa over a laminar slope of 1e2 Pa s/m²
  // the same drop by head and by weight drives the same flux
  PressureSolver level(straight_crack(20.0, 40), {});
  const double flux = level.solve(motion.apertures, motion.rates, {2e5, 0.0}).upstream_flux;
  p = &solver.solve(motion.apertures, motion.rates, {2e5 + 10.0 * gamma, 0.0});
  EXPECT_NEAR(p->upstream_flux, flux, 1e-12 * flux);
  // opening: at the front p = 0 and dp/ds = 0, so the water there runs back as its weight makes it
  motion = linear_motion(40, 0.05, 0.03, 0.05, 0.05);
  p = &solver.solve(motion.apertures, motion.rates, {2e5, {}});
  ASSERT_EQ(p->status, ProfileStatus::converged);
  ASSERT_TRUE(p->cavitated);
  const double x = p->front_position, w = 0.05 - 0.001 * x, q = p->upstream_flux - 0.05 * x;
  EXPECT_NEAR(q, flux_of_resistance(flow_law({}), -0.5 * gamma * w * w * w),
              1e-6 * 0.05);  // x to the root of round-off
  // which feeds the wet region: it reaches further than in a level crack
  EXPECT_GT(x, level.solve(motion.apertures, motion.rates, {2e5, {}}).front_position);
  // seen from the other mouth the crack falls instead of rising
  CrackLine falling = rising;
  for (double& rise : falling.rises) rise = -rise;
  PressureSolver mirrored_solver(falling, {});
  Motion mirrored = motion;
  std::reverse(mirrored.apertures.begin(), mirrored.apertures.end());
  std::reverse(mirrored.rates.begin(), mirrored.rates.end());
  const PressureProfile here = solver.solve(motion.apertures, motion.rates, {2e5, 5e4});
  const PressureProfile there = mirrored_solver.solve(mirrored.apertures, mirrored.rates, {5e4, 2e5});
  ASSERT_EQ(here.status, ProfileStatus::converged);
  ASSERT_EQ(there.status, ProfileStatus::converged);
  for (std::size_t i = 0; i <= 40; ++i) EXPECT_NEAR(here.pressure[i], there.pressure[40 - i], 1e-9 * 2e5) << i;
}

TEST(WetRegions, ReportAMouthBelowZeroAsDry) {
  PressureSolver solver(straight_crack(10.0, 20), {});
  const Motion motion = linear_motion(20, 0.05, 0.05, -0.01, -0.01);
  const PressureProfile suction = solver.solve(motion.apertures, motion.rates, {-1e4, {}});
  const PressureProfile none = solver.solve(motion.apertures, motion.rates, {0.0, {}});
  EXPECT_TRUE(suction.mouth_below_zero);
  EXPECT_FALSE(none.mouth_below_zero);
  EXPECT_EQ(suction.pressure, none.pressure);
}

}  // namespace
}  // namespace sunder::crackwater
