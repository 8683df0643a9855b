#include "verification/harness/float_traps.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "solver/numerics/untrapped_floats.hpp"

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

TEST(FloatTrapsDeathTest, LetAForeignLibraryOffAndReturnAfterIt) {
  const auto with_traps = [] {
    const FloatTraps traps(true);
    {
      const numerics::UntrappedFloats foreign;
      result = 1.0 / zero;
    }
    result = 1.0;  // nothing is left to trap
    result = zero / zero;
  };
  EXPECT_EXIT(with_traps(), testing::KilledBySignal(SIGFPE), "invalid operation");
}

TEST(FloatTraps, AreGoneAfterwardsAndAbsentWhereNotSet) {
  { const FloatTraps traps(true); }
  result = 1.0 / zero;
  const FloatTraps none(false);
  result = zero / zero;
}

}  // namespace
}  // namespace sunder::verification
