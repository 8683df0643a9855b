#include "verification/harness/digits_trusted.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/harness/expression.hpp"

namespace sunder::verification {
namespace {

using results::Quantity;

Quantity quantities(double scalar, double first, double second) {
  return Quantity::Table{{"scalar", scalar},
                         {"word", "full"},
                         {"list", Quantity(std::vector<double>{first, second})},
                         {"tips", Quantity::List{Quantity::Table{{"K_I", scalar}}}}};
}

TEST(Jittered, MovesByOneStepOrNotAtAll) {
  std::mt19937_64 generator(1);
  int moved = 0;
  for (int i = 0; i < 300; ++i) {
    const double value = jittered(0.1, generator);
    EXPECT_LE(std::abs(value - 0.1), 2e-17);  // the grid's step at 0.1 is 1.4e-17
    moved += value != 0.1;
  }
  EXPECT_NEAR(moved, 200, 40);  // two of three; 40 is five standard deviations
  EXPECT_EQ(jittered(0.0, generator), 0.0);
}

TEST(DecimalDigits, EndAtHalfTheMachinesPrecisionAndAtZero) {
  EXPECT_NEAR(decimal_digits(1e-9), 9.0, 1e-12);
  EXPECT_NEAR(decimal_digits(0.0), 15.95, 0.01);
  EXPECT_EQ(decimal_digits(10.0), 0.0);
}

TEST(DigitsTrusted, CountsEachQuantityAtItsWorst) {
  DigitsTrusted trusted(quantities(2.0, 100.0, 0.0));
  EXPECT_TRUE(trusted.add(quantities(2.0 + 2e-6, 100.0, 1e-3)));
  EXPECT_TRUE(trusted.add(quantities(2.0 - 2e-9, 100.0, -1e-4)));
  EXPECT_NEAR(select(trusted.spread(), "scalar")[0], 2e-6, 1e-15);
  EXPECT_NEAR(select(trusted.digits(), "scalar")[0], 6.0, 1e-9);
  EXPECT_NEAR(select(trusted.digits(), "tips[0].K_I")[0], 6.0, 1e-9);
  EXPECT_NEAR(select(trusted.digits(), "list")[0], 5.0, 1e-9);  // 1e-3 of the list's largest, 100
  EXPECT_EQ(trusted.digits().find("word"), nullptr);
}

TEST(DigitsTrusted, RefusesOtherQuantities) {
  DigitsTrusted trusted(quantities(2.0, 1.0, 0.0));
  EXPECT_FALSE(trusted.add(Quantity(Quantity::Table{{"scalar", 2.0}})));
  Quantity longer = quantities(2.0, 1.0, 0.0);
  longer["list"] = Quantity(std::vector<double>{1.0, 0.0, 0.0});
  EXPECT_FALSE(trusted.add(longer));
}

}  // namespace
}  // namespace sunder::verification
