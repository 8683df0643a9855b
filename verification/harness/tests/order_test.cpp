#include "verification/harness/order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace sunder::verification {
namespace {

std::vector<Level> levels(int count, double (*value)(double h)) {
  std::vector<Level> result;
  for (int i = 0; i < count; ++i) result.push_back({std::pow(0.5, i), value(std::pow(0.5, i))});
  return result;
}

// Three grids of NASA's NPARC tutorial "Examining Spatial (Grid) Convergence": pressure recovery on grids halved twice.
// It prints p = 1.786, 0.97130 at h = 0 and a grid convergence index of 0.103 % on the finest; each to its last digit
// here.
TEST(ObservedOrder, AgreesWithTheNasaTriplet) {
  const std::vector<Level> grids{{1.0, 0.97050}, {2.0, 0.96854}, {4.0, 0.96178}};
  const OrderEstimate estimate = observed_order(grids);
  EXPECT_EQ(estimate.convergence, Convergence::monotone);
  EXPECT_NEAR(estimate.order, 1.786, 5e-4);
  EXPECT_NEAR(estimate.extrapolated, 0.97130, 5e-6);
  EXPECT_NEAR(estimate.convergence_index, 0.00103, 5e-6);
}

TEST(ObservedOrder, IsExactForAPurePower) {
  const OrderEstimate estimate =
      observed_order(levels(5, [](double h) { return 3.0 + 0.7 * h * h * h; }), {.exact = 3.0});
  EXPECT_EQ(estimate.convergence, Convergence::monotone);
  EXPECT_EQ(estimate.levels_used, 5);
  EXPECT_NEAR(estimate.order, 3.0, 1e-11);         // errors down to 2e-4 of a value of 3: 1e-16 · 3 / 2e-4 / ln 2
  EXPECT_NEAR(estimate.extrapolated, 3.0, 1e-14);  // round-off of a value of 3
}

TEST(ObservedOrder, OfDifferencesNeedsNoAnswerAndNoEqualRatios) {
  // h = 1, 0.7, 0.4, 0.3: the triplet's equation is solved exactly for a pure power, whatever the ratios.
  std::vector<Level> uneven;
  for (const double h : {1.0, 0.7, 0.4, 0.3}) uneven.push_back({h, 2.0 - 0.1 * std::pow(h, 2.5)});
  const OrderEstimate estimate = observed_order(uneven);
  EXPECT_NEAR(estimate.order, 2.5, 1e-10);  // round-off 1e-16 · 2 over differences of 5e-3
  EXPECT_NEAR(estimate.extrapolated, 2.0, 1e-13);
}

TEST(ObservedOrder, StopsAtTheRoundOffFloor) {
  // Fourth order down to 1e-9, then noise of either sign: the noise must not enter.
  const auto noisy = levels(9, [](double h) { return 1.0 + std::pow(h, 4) + 1e-9 * std::sin(1e6 * h); });
  const OrderEstimate with_floor = observed_order(noisy, {.exact = 1.0, .floor = 1e-8});
  EXPECT_EQ(with_floor.convergence, Convergence::monotone);
  EXPECT_EQ(with_floor.levels_used, 7);      // (1/2)^(4·6) = 6e-8 is above 1e-8, (1/2)^(4·7) = 4e-9 below
  EXPECT_NEAR(with_floor.order, 4.0, 0.05);  // noise of 1e-9 in an error of 6e-8: 0.017 / ln 2
  const OrderEstimate all_below = observed_order(noisy, {.exact = 1.0, .floor = 2.0});
  EXPECT_EQ(all_below.convergence, Convergence::at_floor);
  EXPECT_EQ(all_below.levels_used, 0);
}

TEST(ObservedOrder, FitsOscillatingErrors) {
  int sign = 1;
  std::vector<Level> swinging;
  for (int i = 0; i < 6; ++i, sign = -sign)
    swinging.push_back({std::pow(0.5, i), 5.0 + sign * 0.3 * std::pow(0.25, i)});
  const OrderEstimate with_answer = observed_order(swinging, {.exact = 5.0});
  EXPECT_EQ(with_answer.convergence, Convergence::oscillatory);
  EXPECT_NEAR(with_answer.order, 2.0, 1e-9);  // |error| is a pure power
  const OrderEstimate without = observed_order(swinging);
  EXPECT_EQ(without.convergence, Convergence::oscillatory);
  EXPECT_NEAR(without.order, 2.0, 1e-9);
}

TEST(ObservedOrder, NamesDivergence) {
  const auto growing = levels(4, [](double h) { return 1.0 + 0.01 / h; });
  EXPECT_EQ(observed_order(growing, {.exact = 1.0}).convergence, Convergence::divergent);
  EXPECT_NEAR(observed_order(growing, {.exact = 1.0}).order, -1.0, 1e-12);
  EXPECT_EQ(observed_order(growing).convergence, Convergence::divergent);
  EXPECT_NEAR(observed_order(growing).order, -1.0, 1e-10);
}

TEST(ObservedOrder, DoesNotDependOnTheOrderOfTheLevels) {
  const std::vector<Level> up{{1.0, 0.97050}, {2.0, 0.96854}, {4.0, 0.96178}}, down(up.rbegin(), up.rend());
  EXPECT_EQ(observed_order(up).order, observed_order(down).order);
}

TEST(ObservedOrder, RejectsWhatIsNoSweep) {
  const std::vector<Level> two{{1.0, 1.0}, {2.0, 1.5}}, twice{{1.0, 1.0}, {1.0, 1.5}, {2.0, 2.0}};
  const std::vector<Level> not_a_number{{1.0, std::nan("")}, {2.0, 1.5}, {4.0, 2.0}},
      no_size{{0.0, 1.0}, {1.0, 1.5}, {2.0, 2.0}};
  EXPECT_THROW(static_cast<void>(observed_order(two)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(observed_order(twice)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(observed_order(not_a_number)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(observed_order(no_size)), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::verification
