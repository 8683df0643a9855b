#include "verification/harness/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace sunder::verification {
namespace {

TEST(MedianInterval, TakesTheOrderStatisticsOfTheBinomialTable) {
  // Ranks of the 95 % interval of the median from the binomial distribution: n = 10: 2 and 9, n = 20: 6 and 15.
  std::vector<double> ten(10), twenty(20);
  std::iota(ten.begin(), ten.end(), 1.0);
  std::iota(twenty.begin(), twenty.end(), 1.0);
  const MedianEstimate of_ten = median_interval(ten), of_twenty = median_interval(twenty);
  EXPECT_EQ(of_ten.median, 5.5);
  EXPECT_EQ(of_ten.low, 2.0);
  EXPECT_EQ(of_ten.high, 9.0);
  EXPECT_NEAR(of_ten.confidence, 1.0 - 2.0 * 11.0 / 1024.0, 1e-15);  // P(B ≤ 1) = (1 + 10) / 2¹⁰
  EXPECT_EQ(of_twenty.low, 6.0);
  EXPECT_EQ(of_twenty.high, 15.0);
}

TEST(MedianInterval, IsNotReachedByFiveValues) {
  const std::vector<double> five{1.0, 1.1, 0.9, 1.0, 1.05};
  EXPECT_NEAR(median_interval(five).confidence, 1.0 - 2.0 / 32.0, 1e-15);
  EXPECT_TRUE(std::isinf(relative_spread(median_interval(five))));
  EXPECT_EQ(median_interval(std::vector<double>{7.0}).median, 7.0);
  EXPECT_THROW(static_cast<void>(median_interval({})), std::invalid_argument);
}

TEST(MedianInterval, IgnoresOutliersAndSeesAStep) {
  std::vector<double> series(21, 1.0);
  series[3] = 50.0;
  EXPECT_EQ(relative_spread(median_interval(series)), 0.0);
  for (std::size_t i = 10; i < series.size(); ++i) series[i] = 1.3;  // half of the series is 30 % slower
  EXPECT_NEAR(relative_spread(median_interval(series)), 0.15 / 1.3, 1e-12);
}

// Two series of 31 timings each with 2 % of noise (uniform, from a fixed generator), the second slower by `step`.
bool intervals_part(std::mt19937& generator, double step) {
  const auto series = [&](double level) {
    std::vector<double> values(31);
    for (double& value : values) value = level * (1.0 + 0.02 * (static_cast<double>(generator()) / 2147483648.0 - 1.0));
    return median_interval(values);
  };
  const MedianEstimate before = series(1.0), after = series(1.0 + step);
  return before.high < after.low || after.high < before.low;
}

TEST(MedianInterval, TellsAPlantedStepFromNoise) {
  std::mt19937 generator(7);
  int false_alarms = 0, found = 0;
  for (int trial = 0; trial < 400; ++trial) {
    false_alarms += intervals_part(generator, 0.0);
    found += intervals_part(generator, 0.03);
  }
  // Two 95 % intervals part by chance in about 0.6 % of trials (their half-widths add, their errors add in squares):
  // 2.4 of 400; ten would be five standard deviations off. Of a uniform of half-width 2 % the median of 31 deviates by
  // 0.02 / √33 = 0.35 %: a step of 3 % is 8 of these, twice the widths of both intervals.
  EXPECT_LE(false_alarms, 10);
  EXPECT_GE(found, 396);
}

}  // namespace
}  // namespace sunder::verification
