/// What a solve, its derivative and an accepted step allocate: nothing.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "solver/contact/contact_solver.hpp"
#include "solver/contact/tests/flexibilities.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Counting replacements of the global operators; not inlined, or GCC takes malloc and delete for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

// Eigen allocates past operator new: with glibc every block comes through here. A sanitizer has its own.
#ifndef __SANITIZE_ADDRESS__
extern "C" void* __libc_malloc(std::size_t size);
extern "C" [[gnu::noinline]] void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

namespace sunder::contact {
namespace {

TEST(Allocations, AreNoneInASolveItsDerivativeAndAnAcceptedStep) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations cannot be counted under the address sanitizer";
#endif
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
