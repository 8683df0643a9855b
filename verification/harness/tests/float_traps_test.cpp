#include "verification/harness/float_traps.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace sunder::verification {
namespace {

volatile double zero = 0.0, huge = 1e308, result = 0.0;

TEST(FloatTrapsDeathTest, EndsTheProgramByName) {
  const auto with_traps = [](double (*operation)()) {
    const FloatTraps traps(true);
    result = operation();
  };
  EXPECT_EXIT(with_traps([] { return 1.0 / zero; }), testing::KilledBySignal(SIGFPE), "division by zero");
  EXPECT_EXIT(with_traps([] { return zero / zero; }), testing::KilledBySignal(SIGFPE), "invalid operation");
  EXPECT_EXIT(with_traps([] { return huge * huge; }), testing::KilledBySignal(SIGFPE), "overflow");
}

TEST(FloatTraps, AreGoneAfterwardsAndAbsentWhereNotSet) {
  { const FloatTraps traps(true); }
  result = 1.0 / zero;
  const FloatTraps none(false);
  result = zero / zero;
}

}  // namespace
}  // namespace sunder::verification
