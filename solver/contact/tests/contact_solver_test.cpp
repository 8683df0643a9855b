#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/contact/contact_solver.hpp"
#include "solver/contact/tests/flexibilities.hpp"

namespace sunder::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using tests::Random;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ContactOptions exact{.model = ContactModel::exact};

ContactResult solve(const ContactOptions& options, const MatrixXd& F, const VectorXd& length, const VectorXd& gap) {
  ContactSolver solver(options);
  solver.set_faces(F, length);
  return solver.solve(gap);
}

VectorXd one(double value) {
  return VectorXd::Constant(1, value);
}

TEST(PenaltyContact, OnePairFollowsItsClosedForm) {
  // λ (F + 1/(k L)) = -g⁰, k = 1e8 · 10ʲ with the first j for which λ/(k L) ≤ 1e-4 m.
  const double F = 2e-10, L = 0.5, g0 = -0.3;
  double k = 1e8;
  int enlargements = 0;
  while (-g0 / (1.0 + F * k * L) > 1e-4) k *= 10.0, ++enlargements;
  const ContactResult result = solve({}, MatrixXd::Constant(1, 1, F), one(L), one(g0));
  EXPECT_EQ(result.status, ContactStatus::converged);
  EXPECT_EQ(result.enlargements, enlargements);
  EXPECT_DOUBLE_EQ(result.stiffness, k);
  EXPECT_NEAR(result.pair_force[0] * (F + 1.0 / (k * L)) / -g0, 1.0, 4 * eps);
  EXPECT_NEAR(result.largest_penetration, -g0 / (1.0 + F * k * L), 4 * eps * -g0);
  EXPECT_LE(result.largest_penetration, 1e-4);
}

TEST(PenaltyContact, OpenPairCarriesNothing) {
  const ContactResult result = solve({}, MatrixXd::Constant(1, 1, 2e-10), one(0.5), one(1e-3));
  EXPECT_EQ(result.status, ContactStatus::converged);
  EXPECT_EQ(result.pair_force[0], 0.0);
  EXPECT_EQ(result.gap[0], 1e-3);
  EXPECT_EQ(result.closed, 0);
  EXPECT_EQ(result.enlargements, 0);
}

TEST(Contact, AgreesWithTryingEverySetOfPairs) {
  Random random(1);
  int compared = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 1 + trial % 8;
    const MatrixXd F = tests::random_flexibility(n, n + 1, random);
    const VectorXd gap = tests::random_vector(n, random), length = VectorXd::Constant(n, 0.7);
    const VectorXd expected = tests::by_enumeration(F, gap);
    if (expected.size() == 0) continue;
    ++compared;
    const ContactResult result = solve(exact, F, length, gap);
    ASSERT_EQ(result.status, ContactStatus::converged) << trial;
    // Forces are right to the condition of F, gaps to round-off of their terms.
    const double condition = F.trace() * F.llt().solve(MatrixXd::Identity(n, n)).trace();
    EXPECT_LE((result.pair_force - expected).norm(), 64 * eps * condition * (1.0 + expected.norm())) << trial;
    EXPECT_LE(result.largest_penetration, 64 * eps * (1.0 + F.norm() * expected.norm())) << trial;
    EXPECT_LE(result.complementarity, 64 * eps * (1.0 + F.norm() * expected.norm())) << trial;
    EXPECT_EQ(result.largest_tension, 0.0);
  }
  EXPECT_GE(compared, 390);
}

TEST(PenaltyContact, NearsExactContactInTheFirstOrderOfItsSoftness) {
  const int n = 40;
  const MatrixXd F = tests::face_flexibility(n);
  VectorXd gap(n), length = VectorXd::Constant(n, 0.25);
  for (int i = 0; i < n; ++i) gap[i] = 1e-3 * std::cos(0.2 * i);
  const VectorXd limit = solve(exact, F, length, gap).pair_force;
  // λ_k = λ - (1/k) F_AA⁻¹ L⁻¹ λ + O(1/k²): the error falls tenfold a decade once F k L ≫ 1, to a relative 1/(F k L).
  std::vector<double> errors;
  for (const double k : {1e13, 1e14, 1e15, 1e16}) {
    errors.push_back(
        (solve({.initial_stiffness = k, .penetration_tolerance = 1.0}, F, length, gap).pair_force - limit).norm());
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(std::log10(errors[i - 1] / errors[i]), 1.0, 0.02);
  // Where 1/(k L) is below the round-off of F the two are the same: k enlarged to 1e24 spoils nothing.
  const ContactResult stiff = solve({.initial_stiffness = 1e24}, F, length, gap);
  EXPECT_EQ(stiff.status, ContactStatus::converged);
  EXPECT_LE((stiff.pair_force - limit).norm(), 1e-9 * limit.norm());
}

TEST(PenaltyContact, ReachesItsGateFromAnyStiffnessWithAnyGrowth) {
  const int n = 30;
  const MatrixXd F = tests::face_flexibility(n);
  VectorXd gap(n), length = VectorXd::Constant(n, 0.25);
  for (int i = 0; i < n; ++i) gap[i] = 5e-3 * std::sin(0.3 * i);
  for (double k = 1e-4; k < 2e24; k *= 100.0) {
    for (const double growth : {2.0, 10.0, 1e3}) {
      const ContactResult result =
          solve({.initial_stiffness = k, .growth_factor = growth, .maximum_stiffness = 1e30}, F, length, gap);
      EXPECT_EQ(result.status, ContactStatus::converged) << k;
      EXPECT_LE(result.largest_penetration, 1e-4) << k;
    }
  }
  const ContactResult soft = solve({.initial_stiffness = 1e4, .maximum_stiffness = 1e5}, F, length, gap);
  EXPECT_EQ(soft.status, ContactStatus::penetration_too_large);
  EXPECT_NEAR(soft.stiffness, 1e5, 1e-6);
  EXPECT_GT(soft.largest_penetration, 1e-4);
  EXPECT_TRUE(soft.pair_force.allFinite());
}

TEST(Contact, IsIndifferentToTheUnitsOfSinglePairs) {
  // λ ↦ S⁻¹ λ, g ↦ S g with S = diag(1e-9 … 1e9): the same pairs are closed, with the same numbers in their units.
  const int n = 12;
  Random random(3);
  const MatrixXd F = tests::random_flexibility(n, n + 3, random);
  const VectorXd gap = tests::random_vector(n, random), length = VectorXd::Ones(n);
  const ContactResult plain = solve(exact, F, length, gap);
  VectorXd scale(n);
  for (int i = 0; i < n; ++i) scale[i] = std::pow(10.0, -9.0 + 18.0 * ((5 * i) % n) / (n - 1));
  const MatrixXd scaled = scale.asDiagonal() * F * scale.asDiagonal();
  ContactOptions options = exact;
  options.penetration_tolerance = 1.0;
  const ContactResult result = solve(options, scaled, length, scale.cwiseProduct(gap));
  EXPECT_EQ(result.status, ContactStatus::converged);
  EXPECT_EQ(result.closed, plain.closed);
  EXPECT_LE((scale.cwiseProduct(result.pair_force) - plain.pair_force).norm(), 1e-10 * plain.pair_force.norm());
}

TEST(Contact, RedundantPairsShareWhatTheyCarry) {
  // Two pairs at one place: only the sum of their forces is defined.
  MatrixXd F = MatrixXd::Ones(2, 2);
  const ContactResult equal = solve(exact, F, VectorXd::Ones(2), VectorXd::Constant(2, -1.0));
  EXPECT_EQ(equal.status, ContactStatus::converged);
  EXPECT_NEAR(equal.pair_force.sum(), 1.0, 4 * eps);
  const VectorXd unequal_gap{{-1.0, -2.0}};
  const ContactResult unequal = solve(exact, F, VectorXd::Ones(2), unequal_gap);
  EXPECT_EQ(unequal.status, ContactStatus::converged);
  EXPECT_NEAR(unequal.pair_force[1], 2.0, 4 * eps);
  EXPECT_EQ(unequal.pair_force[0], 0.0);

  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    // q in the range of F: a solution exists whatever the rank.
    const int n = 4 + trial % 20;
    const MatrixXd singular = tests::random_flexibility(n, 1 + n / 2, random);
    const VectorXd gap = singular * tests::random_vector(n, random);
    const ContactResult result = solve(exact, singular, VectorXd::Ones(n), gap);
    EXPECT_EQ(result.status, ContactStatus::converged) << trial;
    const double terms = gap.norm() + singular.norm() * result.pair_force.norm();
    EXPECT_LE(result.largest_penetration, 1e-12 * terms) << trial;
    EXPECT_LE(result.complementarity, 1e-12 * terms) << trial;
  }
}

TEST(Contact, FacesThatCannotPartAreNamed) {
  // Held by prescribed motions: no force opens them. And a rigid wedge pressed from both sides.
  const MatrixXd rigid = MatrixXd::Zero(2, 2), wedge{{1.0, -1.0}, {-1.0, 1.0}};
  for (const MatrixXd& F : {rigid, wedge}) {
    const ContactResult result = solve(exact, F, VectorXd::Ones(2), VectorXd::Constant(2, -1.0));
    EXPECT_EQ(result.status, ContactStatus::no_solution);
    EXPECT_GE(result.largest_penetration, 1.0 - 1e-12);
    EXPECT_TRUE(result.pair_force.allFinite());
    const ContactResult soft = solve({}, F, VectorXd::Ones(2), VectorXd::Constant(2, -1.0));
    EXPECT_TRUE(soft.status == ContactStatus::penetration_too_large || soft.status == ContactStatus::no_solution);
  }
  // Only one of two pairs is rigid: the other is still right.
  const MatrixXd half{{2.0, 0.0}, {0.0, 0.0}};
  const ContactResult result = solve(exact, half, VectorXd::Ones(2), VectorXd::Constant(2, -1.0));
  EXPECT_EQ(result.status, ContactStatus::no_solution);
  EXPECT_NEAR(result.pair_force[0], 0.5, eps);
  EXPECT_EQ(solve(exact, rigid, VectorXd::Ones(2), VectorXd::Zero(2)).status, ContactStatus::converged);
  // A tolerance below the round-off of the gaps is no lack of a solution.
  ContactOptions finer = exact;
  finer.penetration_tolerance = 1e-300;
  const MatrixXd F = tests::face_flexibility(9);
  const ContactResult rounded = solve(finer, F, VectorXd::Ones(9), VectorXd::LinSpaced(9, -0.1, -0.2));
  EXPECT_TRUE(rounded.status == ContactStatus::not_converged || rounded.largest_penetration == 0.0);
}

TEST(PenaltyContact, APairWithoutLengthHasNoSpring) {
  const MatrixXd F{{2e-10, 1e-10}, {1e-10, 2e-10}};
  for (const double length : {0.0, 1e-320}) {
    const ContactResult result =
        solve({.penetration_tolerance = 1.0}, F, VectorXd{{0.5, length}}, VectorXd::Constant(2, -0.1));
    EXPECT_EQ(result.status, ContactStatus::converged);
    EXPECT_EQ(result.pair_force[1], 0.0);
    EXPECT_GT(result.largest_penetration, 0.05);  // what its neighbour does not part
  }
}

TEST(Contact, NoPairsIsAnAnswer) {
  ContactSolver solver;
  EXPECT_EQ(solver.solve(VectorXd()).status, ContactStatus::converged);
  EXPECT_EQ(solver.result().largest_penetration, 0.0);
  solver.set_faces(MatrixXd(), VectorXd());
  EXPECT_EQ(solver.solve(VectorXd()).closed, 0);
}

TEST(Contact, StartsWarmAndEndsWhereAColdSolveEnds) {
  const int n = 50;
  const MatrixXd F = tests::face_flexibility(n);
  const VectorXd length = VectorXd::Constant(n, 0.5);
  ContactOptions options = exact;
  ContactSolver warm(options);
  warm.set_faces(F, length);
  int cold_pivots = 0, warm_pivots = 0;
  for (int step = 0; step < 200; ++step) {
    VectorXd gap(n);
    for (int i = 0; i < n; ++i) gap[i] = 1e-3 * (std::sin(0.31 * step) + 0.4 * std::cos(0.2 * i + 0.05 * step));
    warm.solve(gap);
    const ContactResult cold = solve(options, F, length, gap);
    ASSERT_EQ(warm.result().status, ContactStatus::converged);
    // The same set of pairs is found; the factors differ by the order of their rows.
    EXPECT_LE((warm.result().pair_force - cold.pair_force).norm(), 1e-9 * (1.0 + cold.pair_force.norm())) << step;
    EXPECT_LE(warm.result().largest_penetration, 1e-15) << step;
    cold_pivots += cold.iterations;
    warm_pivots += warm.result().iterations;
  }
  EXPECT_LT(warm_pivots, cold_pivots);
}

TEST(Contact, DoesNotChatter) {
  // Strongly coupled pairs on which block pivoting alone cycles: the descent must take over and end. Every problem is
  // solved, from cold and from the opposite problem's answer, in a bounded number of steps.
  int descents = 0;
  Random random(11);
  for (int trial = 0; trial < 3000; ++trial) {
    const int n = 3 + trial % 12;
    MatrixXd F = tests::random_flexibility(n, n, random);
    F.diagonal().array() += 1e-4;
    BoundedMinimum minimum;
    minimum.resize(n);
    minimum.set_matrix(F, VectorXd::Zero(n));
    const VectorXd q = tests::random_vector(n, random), lower = VectorXd::Zero(n),
                   upper = VectorXd::Constant(n, std::numeric_limits<double>::infinity());
    for (const double sign : {1.0, -1.0, 1.0}) {
      const MinimumReport report = minimum.solve(sign * q, lower, upper);
      ASSERT_EQ(report.status, MinimumStatus::found) << trial;
      EXPECT_LE(report.pivots, 12 * n) << trial;
      const double terms = q.norm() + F.norm() * minimum.x().norm();
      EXPECT_GE(minimum.x().minCoeff(), 0.0);
      EXPECT_GE(minimum.gradient().minCoeff(), -1e-12 * terms);
      EXPECT_LE(std::abs(minimum.x().dot(minimum.gradient())), 1e-12 * terms * minimum.x().norm());
      descents += report.descended ? 1 : 0;
    }
  }
  EXPECT_GT(descents, 0);  // else this test tests nothing
}

TEST(Contact, ForcesFollowASmallChangeAsTheDerivativeSays) {
  const int n = 20;
  const MatrixXd F = tests::face_flexibility(n);
  const VectorXd length = VectorXd::Constant(n, 0.5);
  VectorXd gap(n);
  for (int i = 0; i < n; ++i) gap[i] = 1e-3 * std::sin(0.5 * i + 0.1);
  for (const ContactOptions& options : {exact, ContactOptions{.initial_stiffness = 1e10}}) {
    ContactSolver solver(options);
    solver.set_faces(F, length);
    const VectorXd before = solver.solve(gap).pair_force;
    MatrixXd change = 1e-9 * MatrixXd::Identity(n, n);
    EXPECT_TRUE(solver.differentiate(change));
    // Between changes of the set λ is linear in g⁰: the difference is exact to round-off over the step, 1e-16/1e-6.
    for (int i = 0; i < n; ++i) {
      VectorXd moved = gap;
      moved[i] += 1e-9;
      const VectorXd difference = solver.solve(moved).pair_force - before;
      EXPECT_LE((difference - change.col(i)).norm(), 1e-8 * change.norm()) << i;
    }
  }
}

TEST(Contact, RefusesWhatItCannotUse) {
  const auto refused = [](const ContactOptions& options, const std::string& name) {
    try {
      check(options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what()).find(name) != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused({.initial_stiffness = 0.0}, "initial_stiffness = 0 must be finite and > 0"));
  EXPECT_TRUE(refused({.initial_stiffness = NAN}, "initial_stiffness"));
  EXPECT_TRUE(refused({.growth_factor = 1.0}, "growth_factor = 1 must be finite and > 1"));
  EXPECT_TRUE(refused({.maximum_stiffness = 1.0}, "maximum_stiffness"));
  EXPECT_TRUE(refused({.penetration_tolerance = 0.0}, "penetration_tolerance"));
  EXPECT_TRUE(refused({.friction_coefficient = -0.1}, "friction_coefficient"));
  EXPECT_TRUE(refused({.friction_tolerance = 0.0}, "friction_tolerance"));
  EXPECT_TRUE(refused({.friction_iterations = 0}, "friction_iterations"));

  ContactSolver solver;
  const MatrixXd F = MatrixXd::Identity(2, 2);
  EXPECT_THROW(solver.set_faces(F, VectorXd::Ones(3)), std::invalid_argument);
  EXPECT_THROW(solver.set_faces(-F, VectorXd::Ones(2)), std::invalid_argument);
  EXPECT_THROW(solver.set_faces(F, VectorXd{{1.0, -1.0}}), std::invalid_argument);
  EXPECT_THROW(solver.set_faces(MatrixXd{{1.0, NAN}, {NAN, 1.0}}, VectorXd::Ones(2)), std::invalid_argument);
  EXPECT_THROW(solver.set_faces(MatrixXd{{1.0, 0.5}, {-0.5, 1.0}}, VectorXd::Ones(2)), std::invalid_argument);
  solver.set_faces(F, VectorXd::Ones(2));
  const VectorXd force = solver.solve(VectorXd::Constant(2, -1.0)).pair_force;
  EXPECT_EQ(solver.solve(VectorXd::Ones(3)).status, ContactStatus::unusable_input);
  EXPECT_EQ(solver.solve(VectorXd{{NAN, 1.0}}).status, ContactStatus::unusable_input);
  EXPECT_EQ(solver.result().pair_force, force);
  // Overflow inside is a status too.
  const ContactResult& huge = solver.solve(VectorXd::Constant(2, -1e308));
  EXPECT_NE(huge.status, ContactStatus::unusable_input);
  EXPECT_TRUE(huge.pair_force.allFinite());
}

}  // namespace
}  // namespace sunder::contact
