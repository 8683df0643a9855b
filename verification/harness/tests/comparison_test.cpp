#include "verification/harness/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace sunder::verification {
namespace {

using Numbers = std::vector<double>;

Comparison of(const Numbers& answer, const Numbers& reference, const ComparisonOptions& options) {
  return compare({answer, {}}, {reference, {}}, options);
}

TEST(Comparison, TakesTheWorstOfAList) {
  const Comparison relative = of({1.0, 2.2, 3.0}, {1.0, 2.0, 3.3}, {.norm = Norm::relative});
  EXPECT_NEAR(relative.error, 0.1, 1e-15);
  EXPECT_EQ(relative.value, 2.2);
  EXPECT_EQ(relative.compared, 3);
  EXPECT_NEAR(of({1.0, 2.2}, {1.0, 2.0}, {.norm = Norm::relative, .scale = 4.0}).error, 0.05, 1e-15);
  EXPECT_NEAR(of({1.0, 2.2}, {1.0, 2.0}, {.norm = Norm::absolute}).error, 0.2, 1e-15);
  EXPECT_NEAR(of({3.0, 5.0}, {4.0}, {.norm = Norm::absolute}).error, 1.0, 1e-15);  // one reference for all
}

TEST(Comparison, NotANumberIsTheWorst) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Norm norm : {Norm::relative, Norm::absolute, Norm::l2, Norm::maximum})
    for (const Numbers& answer : {Numbers{nan, 1.0}, Numbers{1.0, nan}})
      EXPECT_TRUE(std::isnan(of(answer, {1.0, 1.0}, {.norm = norm}).error)) << word(norm);
}

TEST(Comparison, EmptyAnswersCompareNothing) {
  EXPECT_EQ(of({}, {1.0}, {.norm = Norm::l2}).compared, 0);
}

TEST(Comparison, NormsOfCurves) {
  EXPECT_NEAR(of({3.0, 4.4}, {3.0, 4.0}, {.norm = Norm::l2}).error, 0.4 / 5.0, 1e-15);
  EXPECT_NEAR(of({3.0, 4.4}, {3.0, 4.0}, {.norm = Norm::maximum}).error, 0.1, 1e-15);
  // The answer, a straight line on a grid of its own, is interpolated at the abscissae of the reference.
  const Numbers x{0.0, 1.0, 4.0}, y{0.0, 2.0, 8.0}, reference_x{0.5, 2.0, 3.0}, reference_y{1.0, 4.0, 6.6};
  const Comparison worst = compare({y, x}, {reference_y, reference_x}, {.norm = Norm::maximum});
  EXPECT_NEAR(worst.error, 0.6 / 6.6, 1e-15);
  EXPECT_EQ(worst.compared, 3);
  // ∫ 2x over 0 … 4 = 16 against the triangle ∫ = 4 · 6 / 2 = 12.
  const Numbers tx{0.0, 2.0, 4.0}, ty{0.0, 6.0, 0.0};
  EXPECT_NEAR(compare({y, x}, {ty, tx}, {.norm = Norm::area}).error, 4.0 / 12.0, 1e-15);
}

TEST(Comparison, TimeOfAnEvent) {
  const Numbers t{0.0, 1.0, 2.0}, y{0.0, 1.0, 5.0}, expected{1.4};
  const Comparison event = compare({y, t}, {expected, {}}, {.norm = Norm::event_time, .threshold = 3.0});
  EXPECT_NEAR(event.value, 1.5, 1e-15);
  EXPECT_NEAR(event.error, 0.1, 1e-15);
  EXPECT_THROW(static_cast<void>(compare({y, t}, {expected, {}}, {.norm = Norm::event_time, .threshold = 9.0})),
               std::invalid_argument);
}

TEST(Comparison, DistanceOfPaths) {
  const Numbers straight{0.0, 0.0, 4.0, 0.0}, same_with_more_points{0.0, 0.0, 1.0, 0.0, 4.0, 0.0};
  EXPECT_EQ(hausdorff_distance(straight, same_with_more_points), 0.0);
  const Numbers bent{0.0, 0.0, 2.0, 0.5, 4.0, 0.0}, shorter{0.0, 0.0, 3.0, 0.0};
  EXPECT_NEAR(hausdorff_distance(straight, bent), 0.5, 1e-3);  // sampled at 1/32 of a segment
  EXPECT_NEAR(hausdorff_distance(straight, shorter), 1.0, 1e-15);
  EXPECT_NEAR(of(straight, bent, {.norm = Norm::path_distance}).error, 0.5, 1e-3);
}

TEST(Comparison, RejectsWhatDoesNotGoTogether) {
  EXPECT_THROW(static_cast<void>(of({1.0, 2.0}, {1.0, 2.0, 3.0}, {.norm = Norm::absolute})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(of({1.0}, {0.0}, {.norm = Norm::relative})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(of({1.0}, {}, {.norm = Norm::absolute})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(of({1.0}, {0.0}, {.norm = Norm::l2})), std::invalid_argument);
  const Numbers x{1.0, 2.0}, y{1.0, 2.0}, beyond{2.5}, value{1.0};
  EXPECT_THROW(static_cast<void>(compare({y, x}, {value, beyond}, {.norm = Norm::l2})), std::invalid_argument);
}

}  // namespace
}  // namespace sunder::verification
