#include "solver/numerics/library_threads.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "solver/numerics/symmetric_factor.hpp"

namespace sunder::numerics {
namespace {

int number_from(const char* function) {
  auto* const found = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, function));
  return found == nullptr ? -1 : found();
}

TEST(OneLibraryThread, ClosesOpenMpRegionsAndOpensThemAgain) {
  const int before = number_from("omp_get_max_active_levels");
  ASSERT_GT(before, 0) << "CHOLMOD came without OpenMP";
  {
    const OneLibraryThread calling_thread;
    EXPECT_EQ(number_from("omp_get_max_active_levels"), 0);
  }
  EXPECT_EQ(number_from("omp_get_max_active_levels"), before);
}

TEST(OneLibraryThread, FactorisingLeavesOneThreadToTheDenseBlocks) {
  Eigen::SparseMatrix<double> lower(2, 2);
  lower.insert(0, 0) = lower.insert(1, 1) = 2.0;
  lower.makeCompressed();
  const SymmetricFactor factor(lower);
  ASSERT_EQ(factor.status(), FactorStatus::factorised);
  const int threads = number_from("openblas_get_num_threads");
  EXPECT_TRUE(threads == 1 || threads == -1) << threads;  // -1: another BLAS
}

}  // namespace
}  // namespace sunder::numerics
