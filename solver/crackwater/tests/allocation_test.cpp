/// What a solve, its tangent and a marched step allocate: nothing.

#include <gtest/gtest.h>

#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/pressure_tangent.hpp"
#include "solver/crackwater/tests/reference_crack.hpp"
#include "solver/numerics/tests/allocation_count.hpp"

namespace sunder::crackwater {
namespace {

using numerics::allocations;

TEST(Allocations, AreNoneInASolveItsTangentAndAStep) {
  if (!numerics::counts_allocations) GTEST_SKIP() << "allocations are the sanitizer's";
  const long before_vector = allocations;
  const tests::Motion motion = tests::linear_motion(60, 0.10, 0.05, 0.10, 0.08);
  ASSERT_GT(allocations, before_vector);  // the count counts
  tests::Motion wavy = motion;
  for (std::size_t i = 0; i < wavy.rates.size(); ++i) wavy.rates[i] *= i % 20 < 12 ? 1.0 : -1.0;
  for (const Search search : tests::all_searches) {
    PressureSolver solver(straight_crack(45.0, 60), {}, {.search = search});
    PressureTangent tangent(60);
    FillingMarch march(straight_crack(45.0, 60), {}, motion.apertures, {.search = search});
    const long before = allocations;
    for (const tests::Motion* m : {&motion, static_cast<const tests::Motion*>(&wavy)}) {
      (void)solver.solve(m->apertures, m->rates, {tests::reference_head, 1e5});
      differentiate(solver, tangent);
      (void)solver.solve(m->apertures, m->rates, {tests::reference_head, {}});
      (void)march.trial(m->apertures, {tests::reference_head, 0.0}, 0.01);
      differentiate(march, tangent);
      (void)march.accept();
    }
    (void)solver.uniform(tests::reference_head);
    EXPECT_EQ(allocations, before) << static_cast<int>(search);
  }
}

}  // namespace
}  // namespace sunder::crackwater
