#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/front_tracking.hpp"
#include "solver/crackwater/tests/reference_crack.hpp"

namespace sunder::crackwater {
namespace {

using tests::linear_motion;
using tests::Motion;
using tests::reference_head;
using tests::reference_motion;

/// A uniform dry crack under constant head, in closed form: turbulent, then pinned at q_c, then laminar.
struct UniformFilling {
  double w = 0.001, pressure = reference_head;
  FlowLaw law = flow_law({});
  double x1() const { return pressure * w * w * w / (law.turbulent * law.critical_flux * law.critical_flux); }
  double x2() const { return pressure * w * w * w / (law.laminar * law.critical_flux); }
  double t1() const { return std::pow(x1(), 1.5) / (1.5 * std::sqrt(pressure * w / law.turbulent)); }
  double t2() const { return t1() + (x2() - x1()) * w / law.critical_flux; }
  double position(double t) const {
    if (t < t1()) return std::pow(1.5 * std::sqrt(pressure * w / law.turbulent) * t, 2.0 / 3.0);
    if (t < t2()) return x1() + law.critical_flux / w * (t - t1());
    return std::sqrt(x2() * x2() + 2.0 * pressure * w * w * (t - t2()) / law.laminar);
  }
};

CrackMotion still(double w) {
  return [w](double, std::span<double> apertures, std::span<double> rates) {
    std::fill(apertures.begin(), apertures.end(), w);
    std::fill(rates.begin(), rates.end(), 0.0);
    return reference_head;
  };
}

TEST(FrontTracking, FollowsTheThreePhasesOfFillingAUniformCrack) {
  const UniformFilling exact;
  EXPECT_NEAR(exact.x1(), 1.99478071861905, 1e-13 * 2.0);  // printed digits
  EXPECT_NEAR(exact.x2(), 8.64537713848934, 1e-13 * 9.0);
  EXPECT_NEAR(exact.t1(), 1.1563946194893, 1e-13);
  EXPECT_NEAR(exact.t2(), 6.93952194111564, 1e-13 * 7.0);
  EXPECT_NEAR(exact.position(10.0), 11.6446647038851, 1e-12 * 12.0);
  FrontTracker tracker(straight_crack(45.0, 45), {}, still(0.001), {.tolerance = 1e-11});
  for (const double time : {0.001, 0.5, 1.0, 5.0, 10.0, 100.0}) {
    const FrontTrack track = tracker.track(0.0, 0.0, time);
    ASSERT_EQ(track.status, FrontStatus::reached_time);
    EXPECT_NEAR(track.position, exact.position(time), 1e-8 * exact.position(time)) << time;  // the bar of the design
    EXPECT_LT(track.steps, 2000);
  }
  const FrontTrack full = tracker.track(0.0, 0.0, 1e4);
  ASSERT_EQ(full.status, FrontStatus::reached_end);
  EXPECT_NEAR(exact.position(full.time), 45.0, 1e-7);
}

TEST(FrontTracking, FollowsABreathingCrack) {
  const auto motion = [](double t, std::span<double> apertures, std::span<double> rates) {
    const double phase = 2.0 * std::numbers::pi * t;
    std::fill(apertures.begin(), apertures.end(), 0.03 * (1.0 + 0.02 * std::sin(phase)));
    std::fill(rates.begin(), rates.end(), 0.03 * 0.02 * 2.0 * std::numbers::pi * std::cos(phase));
    return reference_head;
  };
  FrontTracker tracker(straight_crack(45.0, 30), {.dynamic_viscosity = 1e-24}, motion, {.tolerance = 1e-12});
  const double times[] = {0.25, 0.5, 1.0}, positions[] = {2.654352199273, 3.925614182929, 5.902572048566};
  for (std::size_t k = 0; k < 3; ++k) {
    const FrontTrack track = tracker.track(1.0, 0.0, times[k]);
    ASSERT_EQ(track.status, FrontStatus::reached_time);
    EXPECT_NEAR(track.position, positions[k], 1e-8 * positions[k]);
  }
}

TEST(FrontTracking, ConvergesWithItsTolerance) {
  const UniformFilling exact;
  double before = 1.0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    FrontTracker tracker(straight_crack(45.0, 10), {}, still(0.001), {.tolerance = tolerance});
    const FrontTrack track = tracker.track(0.0, 0.0, 20.0);
    const double error = std::abs(track.position - exact.position(20.0)) / exact.position(20.0);
    EXPECT_LE(error, 20.0 * tolerance);  // steps of one sign add up, some tens of them matter
    EXPECT_LE(error, before);
    before = error;
  }
}

TEST(FrontTracking, SaysWhereItCannotGoOn) {
  // An opening crack under a falling head: the front stops where it takes all the water to keep the crack behind it
  // full.
  const auto opening = [](double t, std::span<double> apertures, std::span<double> rates) {
    std::fill(apertures.begin(), apertures.end(), 0.03 + 0.1 * t);
    std::fill(rates.begin(), rates.end(), 0.1);
    return 1e4 * std::max(1.0 - t, 0.0);
  };
  FrontTracker tracker(straight_crack(45.0, 45), {}, opening);
  const FrontTrack track = tracker.track(0.0, 0.0, 100.0);
  EXPECT_EQ(track.status, FrontStatus::turned_back);
  EXPECT_NEAR(track.flux, 0.0, 1e-4);  // stops within a shortened step of where the flux is nil
  FrontTracker drowned(straight_crack(45.0, 2), {}, still(0.001), {.water_ahead = {0.001, 0.001, 0.001}});
  EXPECT_EQ(drowned.track(1.0, 0.0, 1.0).status, FrontStatus::unusable_input);
  FrontTracker broken(straight_crack(45.0, 2), {}, still(std::nan("")));
  EXPECT_EQ(broken.track(1.0, 0.0, 1.0).status, FrontStatus::unusable_input);
  EXPECT_THROW(FrontTracker(straight_crack(45.0, 2), {}, still(0.001), {.tolerance = 0.0}), std::invalid_argument);
}

TEST(FrontTracking, RunsFasterWhereWaterLiesAhead) {
  // Half of the gap filled halves the void, so all times halve: x(t) of the half-filled crack is x(2 t) of the empty
  // one.
  const UniformFilling exact;
  FrontTracker tracker(straight_crack(45.0, 45), {}, still(0.001),
                       {.tolerance = 1e-11, .water_ahead = std::vector<double>(46, 0.0005)});
  EXPECT_NEAR(tracker.track(0.0, 0.0, 5.0).position, exact.position(10.0), 1e-8 * exact.position(10.0));
}

TEST(FillingMarch, ConvergesToTheFillingFrontWithFirstOrder) {
  const UniformFilling exact;
  double before = 0.0, first = 0.0;
  int levels = 0;
  for (const int n : {50, 100, 200, 400}) {
    const std::vector<double> w(static_cast<std::size_t>(n) + 1, 0.001);
    FillingMarch march(straight_crack(45.0, n), {}, w, {.initially_full = false});
    for (int k = 0; k < n; ++k) (void)march.step(w, {reference_head, {}}, 20.0 / n);
    const double error = std::abs(march.state().front_position - exact.position(20.0));
    EXPECT_EQ(march.state().status, ProfileStatus::converged);
    if (levels++ > 0) {
      EXPECT_LT(error, before);
    }
    if (levels == 1) first = error;
    before = error;
  }
  const double order = std::log2(first / before) / 3.0;
  EXPECT_GE(order, 0.7);
  EXPECT_LE(order, 1.2);
}

TEST(FillingMarch, KeepsTheWaterBalance) {
  struct Case {
    const char* description;
    bool full, open;
    double amplitude;
  };
  const int n = 40, steps = 3000;
  for (const Case& c : {Case{"full, open", true, true, 0.3}, Case{"empty, open", false, true, 0.3},
                        Case{"full, closed tip", true, false, 0.6}, Case{"empty, closed tip", false, false, 0.9}}) {
    SCOPED_TRACE(c.description);
    const auto apertures = [&](double t) {
      std::vector<double> w;
      for (int i = 0; i <= n; ++i) {
        const double x = static_cast<double>(i) / n;
        w.push_back(0.03 * (1.2 - 0.5 * x) *
                    (1.0 + c.amplitude * std::sin(7.0 * t + 4.0 * x) * std::sin(3.0 * x + 1.3 * t)));
      }
      return w;
    };
    FillingMarch march(straight_crack(20.0, n), {}, apertures(0.0), {.initially_full = c.full});
    MouthPressures mouths{2e5, {}};
    if (c.open) mouths.downstream = 3e4;
    double worst = 0.0;
    for (int k = 1; k <= steps; ++k) {
      const MarchState& state = march.step(apertures(0.01 * k), mouths, 0.01);
      ASSERT_EQ(state.status, ProfileStatus::converged) << k;
      worst = std::max(worst, std::abs(state.balance_error));
      const double peak = march.profile().peak_pressure;
      for (std::size_t node = 0; node <= n; ++node) {
        ASSERT_GE(state.voids[node], 0.0);
        ASSERT_LE(state.voids[node], state.capacities[node]);  // never less than no water
        ASSERT_GE(march.profile().pressure[node], 0.0);
        // complementarity, exactly: a node with void has no pressure beyond the round-off of the largest
        if (state.voids[node] > 0.0) {
          ASSERT_LE(march.profile().pressure[node], 1e-12 * peak);
        }
      }
    }
    EXPECT_LE(worst, 1e-13 * march.state().moved);
  }
}

TEST(FillingMarch, EndsAFullCrackWhereTheQuasiStaticProfileDoes) {
  // Backward Euler takes the aperture at the end of the step; as the step shrinks the march tends to the profile of the
  // instant.
  const int n = 450;
  const double printed[] = {1247e3, 149.72e6};  // after 0.01 s, to the digits the design gives
  const double rates[] = {0.10, -0.10};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto after = [&](double t) {
      Motion motion = reference_motion(n, rates[k]);
      for (std::size_t i = 0; i < motion.apertures.size(); ++i) motion.apertures[i] += t * motion.rates[i];
      return motion.apertures;
    };
    FillingMarch march(straight_crack(45.0, n), {}, after(0.0));
    (void)march.step(after(0.01), {reference_head, 0.0}, 0.01);
    EXPECT_NEAR(march.profile().uplift_force, printed[k], 2e-3 * printed[k]);
    FillingMarch instant(straight_crack(45.0, n), {}, after(0.0));
    (void)instant.step(after(1e-7), {reference_head, 0.0}, 1e-7);
    const double quasi_static = k == 0 ? 1233201.40063765116 : 146995198.365368616;
    // second order of the segment length (0.1 m) with the constant of the nodal trapezoid, 1e-4 in the opening case
    EXPECT_NEAR(instant.profile().uplift_force, quasi_static, 3e-4 * quasi_static);
  }
}

TEST(FillingMarch, StandsSignFlipsADryCrackAndASingleElement) {
  const std::vector<double> two(2, 0.03);
  FillingMarch single(straight_crack(1.0, 1), {}, two, {.initially_full = false});
  for (int k = 1; k <= 200; ++k) {
    const std::vector<double> w(2, 0.03 * (1.0 + (k % 2 == 0 ? 0.5 : -0.5)));
    ASSERT_EQ(single.step(w, {1e5, {}}, 1e-3).status, ProfileStatus::converged);
  }
  EXPECT_LE(std::abs(single.state().balance_error), 1e-13 * single.state().moved);

  const std::vector<double> w(11, 0.03);
  FillingMarch dry(straight_crack(10.0, 10), {}, w, {.initially_full = false});
  for (int k = 0; k < 10; ++k) ASSERT_EQ(dry.step(w, {0.0, {}}, 0.1).status, ProfileStatus::converged);
  EXPECT_EQ(dry.state().content, 0.0);
  EXPECT_EQ(dry.profile().uplift_force, 0.0);
  EXPECT_EQ(dry.state().front_position, 0.0);

  for (const double rate : {1e-9, 1e-6, 1e-3, 1.0, 1e3}) {
    FillingMarch march(straight_crack(10.0, 10), {}, w);
    for (int k = 1; k <= 50; ++k) {  // one step out, one step back
      const std::vector<double> moved(11, 0.03 + (k % 2 == 1 ? 1e-5 * rate : 0.0));
      ASSERT_EQ(march.step(moved, {1e5, {}}, 1e-5).status, ProfileStatus::converged) << rate;
      ASSERT_GE(march.state().content, 0.0);
    }
    EXPECT_LE(std::abs(march.state().balance_error), 1e-13 * (march.state().moved + march.state().content)) << rate;
  }
}

TEST(FillingMarch, TriesAStepAsOftenAsAskedAndAcceptsTheLast) {
  const int n = 20;
  const std::vector<double> start(n + 1, 0.03), wide(n + 1, 0.032), other(n + 1, 0.02);
  const MouthPressures mouths{1e5, {}};
  FillingMarch once(straight_crack(10.0, n), {}, start, {.initially_full = false}), often = once;
  for (int k = 0; k < 5; ++k) {
    (void)once.step(wide, mouths, 0.01);
    (void)often.trial(other, {2e5, 0.0}, 0.02);
    (void)often.trial(wide, mouths, 0.01);
    EXPECT_EQ(often.state().steps, k);
    (void)often.accept();
    (void)often.accept();  // nothing to accept
  }
  EXPECT_EQ(often.state().voids, once.state().voids);  // to the last bit
  EXPECT_EQ(often.profile().pressure, once.profile().pressure);
  EXPECT_EQ(often.state().inflow, once.state().inflow);
  EXPECT_EQ(often.state().time, once.state().time);
  EXPECT_EQ(often.trial(wide, mouths, -1.0).status, ProfileStatus::unusable_input);
  EXPECT_EQ(often.accept().steps, 5);
}

TEST(FillingMarch, GrowsWithItsWaterAndADryTip) {
  const auto aperture_at = [](double s) { return 0.05 - 0.002 * s; };
  const auto apertures = [&](const CrackLine& line) {
    std::vector<double> w{aperture_at(0.0)};
    double s = 0.0;
    for (const double h : line.lengths) w.push_back(aperture_at(s += h));
    return w;
  };
  struct Case {
    const char* description;
    bool full;
    CrackLine before, after;
  };
  const Case cases[] = {
      {"one segment more", true, {{1.0, 2.0, 1.5, 0.5}, {}}, {{1.0, 2.0, 1.5, 0.5, 0.5}, {}}},
      {"one segment more, with a front", false, {{1.0, 2.0, 1.5, 0.5}, {}}, {{1.0, 2.0, 1.5, 0.5, 0.5}, {}}},
      {"divided anew near the tip", false, {{1.0, 2.0, 1.5, 0.5}, {}}, {{1.0, 2.0, 0.7, 0.9, 0.9}, {}}},
      {"fewer segments", true, {{1.0, 1.0, 1.0, 1.0, 1.0}, {}}, {{3.0, 4.0}, {}}},
      {"the same", false, {{1.0, 2.0, 2.0}, {}}, {{1.0, 2.0, 2.0}, {}}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.description);
    FillingMarch march(c.before, {}, apertures(c.before), {.initially_full = c.full});
    const MouthPressures mouths{1e5, {}};
    for (int k = 0; k < 3; ++k) (void)march.step(apertures(c.before), mouths, 0.05);
    const MarchState before = march.state();
    ASSERT_GT(before.content, 0.0);
    march.grow(c.after, apertures(c.after));
    const MarchState& after = march.state();
    EXPECT_NEAR(after.content, before.content, 1e-15 * before.content);
    EXPECT_EQ(after.inflow, before.inflow) << "no water leaves";
    for (std::size_t node = 0; node < after.voids.size(); ++node) {
      EXPECT_GE(after.voids[node], 0.0);
      EXPECT_LE(after.voids[node], after.capacities[node]);
    }
    // nodes that own the same stretch before and after own the same water
    for (std::size_t node = 0;
         node + 1 < c.before.lengths.size() && node + 1 < c.after.lengths.size() &&
         c.before.lengths[node] == c.after.lengths[node] && c.before.lengths[node + 1] == c.after.lengths[node + 1];
         ++node) {
      EXPECT_EQ(after.voids[node], before.voids[node]) << node;
    }
    for (int k = 0; k < 40; ++k)
      ASSERT_EQ(march.step(apertures(c.after), mouths, 0.05).status, ProfileStatus::converged);
    EXPECT_LE(std::abs(march.state().balance_error), 1e-13 * march.state().moved);
    EXPECT_NEAR(march.state().content, std::accumulate(after.capacities.begin(), after.capacities.end(), 0.0), 1e-14)
        << "it fills";
  }
  FillingMarch march(straight_crack(2.0, 2), {}, std::vector<double>(3, 0.03));
  EXPECT_THROW(march.grow(straight_crack(1.9, 2), std::vector<double>(3, 0.03)), std::invalid_argument);
  EXPECT_THROW(march.grow(straight_crack(2.1, 2), std::vector<double>(4, 0.03)), std::invalid_argument);
  // narrower than before: what does not fit is pressed out through the mouth, and counted
  march.grow(straight_crack(2.5, 3), std::vector<double>(4, 0.01));
  EXPECT_NEAR(march.state().content, 0.025, 1e-16);
  EXPECT_NEAR(march.state().inflow, -0.035, 1e-16);
}

TEST(FillingMarch, RefusesWhatItCannotUse) {
  const std::vector<double> w(4, 0.03), bad{0.03, 0.0, 0.03, 0.03};
  EXPECT_THROW(FillingMarch(straight_crack(1.0, 3), {}, bad), std::invalid_argument);
  EXPECT_THROW(FillingMarch(straight_crack(1.0, 2), {}, w), std::invalid_argument);
  FillingMarch march(straight_crack(1.0, 3), {}, w);
  const MarchState before = march.state();
  EXPECT_EQ(march.step(bad, {1e5, {}}, 0.1).status, ProfileStatus::unusable_input);
  EXPECT_EQ(march.step(w, {1e5, {}}, 0.0).status, ProfileStatus::unusable_input);
  EXPECT_EQ(march.step(w, {std::nan(""), {}}, 0.1).status, ProfileStatus::unusable_input);
  EXPECT_EQ(march.state().content, before.content);
  EXPECT_EQ(march.state().steps, 0);
  EXPECT_EQ(march.step(w, {1e5, {}}, 0.1).status, ProfileStatus::converged);
}

TEST(FillingMarch, PassesOnWhatComesDownASlopeToWaterThatItCannotPress) {
  // Full from the mouth over a slope to a void at node 9. Pressure is nil at the top of the slope, node 4, where it has
  // its lowest minimum; behind the slope water is squeezed, and friction takes more than the flux has pressure for at
  // the foot. That stretch is not pressed, what comes down goes through it into the void, and no water is lost.
  constexpr int segments = 12;
  CrackLine line{.lengths = std::vector<double>(segments, 0.5), .rises = std::vector<double>(segments, 0.0)};
  line.rises[4] = -0.4;
  const std::vector<double> apertures(segments + 1, 0.03);
  FillingMarch march(line, {}, apertures);
  MarchMemory memory = march.memory();
  for (std::size_t node = 9; node <= segments; ++node) memory.state.voids[node] = memory.state.capacities[node];
  for (const double squeeze : {1e-12, 1e-9, 1e-6, 1e-4}) {
    std::vector<double> squeezed = apertures;
    for (const std::size_t node : {6u, 7u}) squeezed[node] *= 1.0 - squeeze;
    march.go_on(memory);
    const double voids = std::accumulate(memory.state.voids.begin(), memory.state.voids.end(), 0.0);
    const MarchState state = march.step(squeezed, {.upstream = 2000.0, .downstream = {}}, 0.01);
    EXPECT_EQ(state.status, ProfileStatus::converged) << squeeze;
    EXPECT_NEAR(march.profile().front_position, 2.0, 1e-9) << squeeze;
    EXPECT_GE(*std::min_element(march.profile().pressure.begin(), march.profile().pressure.end()), 0.0) << squeeze;
    EXPECT_GT(state.inflow, 1e-4) << squeeze;
    const double left = std::accumulate(state.voids.begin(), state.voids.end(), 0.0);
    const double capacity_lost = 2.0 * 0.5 * 0.03 * squeeze;
    EXPECT_NEAR(left, voids - capacity_lost - (state.inflow - memory.state.inflow), 1e-15) << squeeze;
    EXPECT_EQ(std::accumulate(state.voids.begin(), state.voids.begin() + 9, 0.0), 0.0) << squeeze;
  }
}

}  // namespace
}  // namespace sunder::crackwater
