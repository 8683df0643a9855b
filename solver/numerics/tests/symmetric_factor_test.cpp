#include "solver/numerics/symmetric_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "solver/numerics/tests/allocation_count.hpp"

namespace sunder::numerics {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Two unknowns a node on an m x m grid, nodes joined to their eight neighbours by random positive semidefinite blocks.
Sparse lower_triangle_of_grid(int m, double regularisation) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row + 1 < m; ++row) {
    for (int column = 0; column + 1 < m; ++column) {
      const int first = row * m + column;
      const int nodes[] = {first, first + 1, first + m + 1, first + m};
      Eigen::Matrix<double, 8, 5> root;
      for (double& value : root.reshaped()) value = uniform(generator);
      const Eigen::Matrix<double, 8, 8> block = root * root.transpose();
      for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
          const int a = 2 * nodes[i / 2] + i % 2, b = 2 * nodes[j / 2] + j % 2;
          if (a >= b) entries.emplace_back(a, b, block(i, j));
        }
      }
    }
  }
  for (int i = 0; i < 2 * m * m; ++i) entries.emplace_back(i, i, regularisation);
  Sparse lower(2 * m * m, 2 * m * m);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

double relative_residual(const Sparse& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (lower.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
}

TEST(SymmetricFactor, SolvesWithEveryOrderingAndBlock) {
  const Sparse lower = lower_triangle_of_grid(20, 0.1);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 2.0);
  for (const Ordering ordering : {Ordering::automatic, Ordering::minimum_degree, Ordering::nested_dissection}) {
    for (const int block : {1, 2}) {
      const SymmetricFactor factor(lower, {.ordering = ordering, .block = block});
      ASSERT_EQ(factor.status(), FactorStatus::factorised);
      Eigen::VectorXd x = b;
      factor.solve_in_place(x);
      // Condition about 2e2 (pivots within 0.1 … 20): the residual of a backward stable solution is a few eps times
      // that.
      EXPECT_LT(relative_residual(lower, x, b), 1e-13);
      EXPECT_GT(factor.entries(), lower.nonZeros() / 2);
    }
  }
}

TEST(SymmetricFactor, SolvesSeveralRightSidesLikeOneByOne) {
  const Sparse lower = lower_triangle_of_grid(9, 0.1);
  const SymmetricFactor factor(lower, {.block = 2});
  Eigen::MatrixXd B = Eigen::MatrixXd::Random(lower.rows(), 3);
  const Eigen::MatrixXd right_sides = B;
  factor.solve_in_place(B);
  for (int column = 0; column < 3; ++column) {
    EXPECT_LT(relative_residual(lower, B.col(column), right_sides.col(column)), 1e-13);  // as above
  }
}

TEST(SymmetricFactor, SolvesForAnyNumberOfRightSidesAndBlockOfAMatrix) {
  // one and two alone, eight together, and what is left over; panels whose rows are no multiple of four
  for (const int size : {3, 5, 8}) {
    const Sparse lower = lower_triangle_of_grid(size, 0.1);
    const SymmetricFactor factor(lower);
    for (const int columns : {1, 2, 3, 8, 19}) {
      Eigen::MatrixXd all = Eigen::MatrixXd::Random(lower.rows(), columns + 2);
      const Eigen::MatrixXd before = all;
      factor.solve_in_place(all.middleCols(1, columns));
      for (int c = 1; c <= columns; ++c) EXPECT_LT(relative_residual(lower, all.col(c), before.col(c)), 1e-13);
      EXPECT_EQ(all.col(0), before.col(0));
      EXPECT_EQ(all.col(columns + 1), before.col(columns + 1));
    }
  }
}

/// ‖A x - b‖ / (‖A‖ ‖x‖ + ‖b‖) in the norm of the largest entry.
double backward_error(const Sparse& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const Sparse whole = lower.selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd A = whole;
  const double norm = A.cwiseAbs().rowwise().sum().maxCoeff();
  return (A * x - b).cwiseAbs().maxCoeff() / (norm * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

TEST(SymmetricFactor, IsAsGoodAsSubstitutionAcrossContrastsOfStiffness) {
  // Half of the nodes are up to 1e12 times as stiff. Substitution has a backward error of a few eps; inverted diagonal
  // blocks may add the condition of L₁₁, here below 1e3 for well scaled blocks, of which little is seen.
  const int m = 14;
  const Sparse grid = lower_triangle_of_grid(m, 1e-3);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(grid.rows(), 1.0, 2.0);
  for (double contrast = 1.0; contrast <= 1.1e12; contrast *= 10.0) {
    const double root = std::sqrt(contrast);
    const auto scale = [&](Eigen::Index row) { return row / 2 % m < m / 2 ? 1.0 : root; };
    Sparse lower = grid;
    for (Eigen::Index column = 0; column < lower.cols(); ++column)
      for (Sparse::InnerIterator entry(lower, column); entry; ++entry)
        entry.valueRef() *= scale(entry.row()) * scale(column);
    const SymmetricFactor factor(lower, {.block = 2});
    ASSERT_EQ(factor.status(), FactorStatus::factorised);
    Eigen::VectorXd x = b;
    factor.solve_in_place(x);
    const Eigen::SimplicialLLT<Sparse> substitution(lower);
    const double usual = backward_error(lower, substitution.solve(b), b);
    EXPECT_LT(backward_error(lower, x, b), 1e3 * std::numeric_limits<double>::epsilon()) << contrast;
    RecordProperty("contrast_" + std::to_string(std::lround(std::log10(contrast))),
                   std::to_string(backward_error(lower, x, b) / usual));
  }
}

TEST(SymmetricFactor, IsAsGoodAsSubstitutionOnABodyThatHardlyHoldsItself) {
  // Springs of `spring` under a body without supports: the last pivots are that small, and sit in one diagonal block.
  for (const double spring : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const Sparse lower = lower_triangle_of_grid(12, spring);
    const SymmetricFactor factor(lower, {.block = 2});
    ASSERT_EQ(factor.status(), FactorStatus::factorised) << spring;
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.rows(), 1.0, 2.0);
    Eigen::VectorXd x = b;
    factor.solve_in_place(x);
    EXPECT_LT(backward_error(lower, x, b), 1e3 * std::numeric_limits<double>::epsilon()) << spring;
  }
}

TEST(SymmetricFactor, SolvesWithoutAllocating) {
  const Sparse lower = lower_triangle_of_grid(10, 0.1);
  const SymmetricFactor factor(lower, {.block = 2});
  Eigen::VectorXd x = Eigen::VectorXd::Ones(lower.rows());
  Eigen::MatrixXd X = Eigen::MatrixXd::Ones(lower.rows(), 11);
  factor.solve_in_place(x);
  factor.solve_in_place(X);
  const long before = allocations;
  factor.solve_in_place(x);
  factor.solve_in_place(X);
  EXPECT_EQ(allocations - before, 0);
}

TEST(SymmetricFactor, NamesTheRowOfAPivotThatIsNotPositive) {
  Sparse lower = lower_triangle_of_grid(6, 0.1);
  const int row = 31;
  for (Sparse::InnerIterator entry(lower, row); entry; ++entry) entry.valueRef() = 0.0;
  for (int column = 0; column < row; ++column) {
    for (Sparse::InnerIterator entry(lower, column); entry; ++entry) {
      if (entry.row() == row) entry.valueRef() = 0.0;
    }
  }
  const SymmetricFactor factor(lower, {.block = 2});
  EXPECT_EQ(factor.status(), FactorStatus::not_positive_definite);
  EXPECT_EQ(factor.failed_row(), row);
}

TEST(SymmetricFactor, FactorisesAgainWithTheSamePattern) {
  const Sparse first = lower_triangle_of_grid(8, 0.1);
  Sparse second = first;
  second.coeffs() *= 4.0;
  SymmetricFactor factor(first, {.block = 2});
  factor.refactorise(second);
  ASSERT_EQ(factor.status(), FactorStatus::factorised);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(first.rows());
  Eigen::VectorXd x = b;
  factor.solve_in_place(x);
  EXPECT_LT(relative_residual(second, x, b), 1e-13);
}

TEST(SymmetricFactor, GivesTheSameBitsEveryTime) {
  const Sparse lower = lower_triangle_of_grid(15, 0.1);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(lower.rows());
  Eigen::VectorXd first = b, second = b;
  SymmetricFactor(lower, {.block = 2}).solve_in_place(first);
  SymmetricFactor(lower, {.block = 2}).solve_in_place(second);
  EXPECT_EQ(first, second);
}

TEST(SymmetricFactor, RefusesAMatrixThatIsNotSquare) {
  Sparse matrix(3, 2);
  matrix.makeCompressed();
  EXPECT_THROW(SymmetricFactor{matrix}, std::invalid_argument);
}

}  // namespace
}  // namespace sunder::numerics
