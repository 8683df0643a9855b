#include "solver/numerics/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sunder::numerics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr RootMethod all_methods[] = {RootMethod::bisection, RootMethod::itp, RootMethod::toms748, RootMethod::newton};

TEST(BracketedRoot, FindsTheRootOfASmoothFunctionToRoundOff) {
  for (const RootMethod method : all_methods) {
    auto function = [](double x, bool) { return Residual{2.0 - x * x * x, -3.0 * x * x, 4.0 * epsilon}; };
    const BracketedRoot root = bracketed_root(RootFunction(function), 0.0, 4.0, {.method = method});
    // |F| ≤ 4 ε leaves 4 ε / F' = 0.84 ε, a bracket to round-off 2 ε of the root
    EXPECT_NEAR(root.root, std::cbrt(2.0), 4.0 * epsilon) << static_cast<int>(method);
    EXPECT_LE(root.evaluations, method == RootMethod::bisection ? 56 : 20) << static_cast<int>(method);
    EXPECT_NE(root.status, RootStatus::evaluation_limit);
  }
}

TEST(BracketedRoot, KeepsBothSidesOfAJump) {
  for (const RootMethod method : all_methods) {
    auto function = [](double x, bool) { return Residual{x <= 0.3 ? 1.0 : -2.0, 0.0, 0.0}; };
    const BracketedRoot root = bracketed_root(RootFunction(function), 0.0, 1.0, {.method = method});
    EXPECT_EQ(root.status, RootStatus::bracket_within_tolerance);
    EXPECT_LE(root.lower, 0.3);
    EXPECT_GT(root.upper, 0.3);
    EXPECT_LE(root.upper - root.lower, 2.0 * epsilon);            // relative tolerance 2 ε of a bracket below 1
    EXPECT_LE(root.evaluations, 70) << static_cast<int>(method);  // bisection's 53, two ends, and 14 in vain
  }
}

TEST(BracketedRoot, EndsWhereTheRootIsZero) {
  for (const RootMethod method : all_methods) {
    auto function = [](double x, bool) { return Residual{-x * std::abs(x), -2.0 * std::abs(x), 0.0}; };
    const BracketedRoot root = bracketed_root(RootFunction(function), -1.0, 2.0, {.method = method});
    EXPECT_NEAR(root.root, 0.0, epsilon);
    EXPECT_LE(root.evaluations, 130) << static_cast<int>(method);  // Newton halves x a step on a double root
  }
}

TEST(BracketedRoot, ObeysItsTolerances) {
  for (const RootMethod method : all_methods) {
    auto function = [](double x, bool) { return Residual{1.0 - std::exp(x), -std::exp(x), 0.0}; };
    const BracketedRoot coarse =
        bracketed_root(RootFunction(function), -3.0, 5.0, {.method = method, .residual_tolerance = 1e-3});
    EXPECT_LE(std::abs(coarse.residual), 1e-3);
    EXPECT_LE(coarse.evaluations, 20);
    const BracketedRoot few =
        bracketed_root(RootFunction(function), -3.0, 5.0, {.method = method, .max_evaluations = 4});
    EXPECT_LE(few.evaluations, 6);  // a step of TOMS 748 may be under way
  }
}

TEST(BracketedRoot, SaysWhereThereIsNoRoot) {
  for (const RootMethod method : {RootMethod::itp, RootMethod::toms748, RootMethod::newton}) {
    auto positive = [](double, bool) { return Residual{1.0, 0.0, 0.0}; };
    EXPECT_EQ(bracketed_root(RootFunction(positive), 0.0, 1.0, {.method = method}).status, RootStatus::no_sign_change);
    auto nothing = [](double, bool) { return Residual{std::nan(""), 0.0, 0.0}; };
    EXPECT_EQ(bracketed_root(RootFunction(nothing), 0.0, 1.0, {.method = method}).status, RootStatus::not_finite);
  }
}

}  // namespace
}  // namespace sunder::numerics
