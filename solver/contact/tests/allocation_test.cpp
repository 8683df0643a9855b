/// What a solve, its derivative and an accepted step allocate: nothing.

#include <gtest/gtest.h>

#include <cmath>

#include "solver/contact/contact_solver.hpp"
#include "solver/contact/tests/flexibilities.hpp"
#include "solver/numerics/tests/allocation_count.hpp"

namespace sunder::contact {
namespace {

using numerics::allocations;

TEST(Allocations, AreNoneInASolveItsDerivativeAndAnAcceptedStep) {
  if (!numerics::counts_allocations) GTEST_SKIP() << "allocations are the sanitizer's";
  const int n = 150;
  const Eigen::MatrixXd F = tests::face_flexibility(n);
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  both.topLeftCorner(n, n) = both.bottomRightCorner(n, n) = F;
  const Eigen::VectorXd length = Eigen::VectorXd::Constant(n, 0.2);
  Eigen::VectorXd gap(n);
  Eigen::MatrixXd change(n, 3), change_both(2 * n, 3);
  long before = allocations;
  Eigen::VectorXd counted = gap;
  ASSERT_GT(allocations, before);  // the count counts
  for (const ContactModel model : {ContactModel::penalty, ContactModel::exact}) {
    ContactSolver smooth({.model = model}), rough({.model = model, .friction_coefficient = 0.5});
    smooth.set_faces(F, length);
    rough.set_faces(both, length);
    before = allocations;
    for (int step = 0; step < 12; ++step) {
      for (int i = 0; i < n; ++i) gap[i] = 1e-3 * std::sin(0.1 * i + step);
      (void)smooth.solve(gap);
      (void)rough.solve(gap, gap);
      change.setOnes();
      change_both.setOnes();
      (void)smooth.differentiate(change);
      (void)rough.differentiate(change_both);
      rough.accept();
      if (step == 6) smooth.forget();
    }
    EXPECT_EQ(allocations, before);
  }
  // The descent, on redundant pairs.
  tests::Random random(2);
  const Eigen::MatrixXd singular = tests::random_flexibility(n, n / 2, random);
  ContactSolver redundant({.model = ContactModel::exact});
  redundant.set_faces(singular, length);
  gap = singular * tests::random_vector(n, random);
  before = allocations;
  EXPECT_EQ(redundant.solve(gap).status, ContactStatus::converged);
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace sunder::contact
