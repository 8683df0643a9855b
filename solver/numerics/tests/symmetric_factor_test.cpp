#include "solver/numerics/symmetric_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

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
