#include "solver/numerics/ordered_schur.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace sunder::numerics {
namespace {

using Eigen::MatrixXd;

const auto decaying = [](double real, double) { return real < 0.0; };

MatrixXd random_matrix(int n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return MatrixXd::NullaryExpr(n, n, [&] { return uniform(generator); });
}

void expect_schur_form(const MatrixXd& A, const OrderedSchur& schur) {
  const auto n = A.rows();
  // backward stable: a modest multiple of n roundings
  EXPECT_LT((schur.U * schur.T * schur.U.transpose() - A).norm(), 1e-14 * static_cast<double>(n) * A.norm());
  EXPECT_LT((schur.U.transpose() * schur.U - MatrixXd::Identity(n, n)).norm(), 1e-14 * static_cast<double>(n));
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = j + 2; i < n; ++i) EXPECT_EQ(schur.T(i, j), 0.0);
    if (j + 2 < n) {
      EXPECT_TRUE(schur.T(j + 1, j) == 0.0 || schur.T(j + 2, j + 1) == 0.0);
    }
  }
}

TEST(OrderedSchur, PutsTheWantedEigenvaluesFirst) {
  for (const int n : {1, 2, 3, 8, 25, 60}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const MatrixXd A = random_matrix(n, seed);
      const OrderedSchur schur = ordered_schur(A, decaying);
      ASSERT_EQ(schur.status, SchurStatus::converged);
      expect_schur_form(A, schur);
      const auto leading = schur.T.topLeftCorner(schur.selected, schur.selected);
      const auto trailing = schur.T.bottomRightCorner(n - schur.selected, n - schur.selected);
      if (schur.selected > 0) {
        EXPECT_LT(leading.eigenvalues().real().maxCoeff(), 0.0);
      }
      if (schur.selected < n) {
        EXPECT_GE(trailing.eigenvalues().real().minCoeff(), 0.0);
      }
    }
  }
}

TEST(OrderedSchur, ExchangesPairsOfEverySize) {
  // A block upper triangular matrix with a known spectrum: real 2, pair 1 ± 3i, real -1, pair -0.5 ± 2i.
  MatrixXd A = random_matrix(6, 7).triangularView<Eigen::StrictlyUpper>();
  A(0, 0) = 2.0;
  A.block<2, 2>(1, 1) << 1.0, 9.0, -1.0, 1.0;
  A(3, 3) = -1.0;
  A.block<2, 2>(4, 4) << -0.5, 1.0, -4.0, -0.5;
  const OrderedSchur schur = ordered_schur(A, decaying);
  ASSERT_EQ(schur.selected, 3);
  expect_schur_form(A, schur);
  EXPECT_NEAR(schur.T.topLeftCorner(3, 3).trace(), -2.0, 1e-14);
  EXPECT_NEAR(schur.T.topLeftCorner(3, 3).determinant(), -1.0 * (0.25 + 4.0), 1e-13);
}

TEST(OrderedSchur, DefectiveEigenvaluesStayAnInvariantSubspace) {
  // A Jordan block of order 3 at -1 behind one of order 3 at +1.
  MatrixXd A = MatrixXd::Zero(6, 6);
  for (int i = 0; i < 6; ++i) {
    A(i, i) = i < 3 ? 1.0 : -1.0;
    if (i < 5) A(i, i + 1) = 1.0;
  }
  const OrderedSchur schur = ordered_schur(A, decaying);
  ASSERT_EQ(schur.selected, 3);
  const MatrixXd V = schur.U.leftCols(3);
  EXPECT_LT((A * V - V * schur.T.topLeftCorner(3, 3)).norm(), 1e-14);
}

TEST(OrderedSchur, RefusesNaN) {
  MatrixXd A = random_matrix(4, 1);
  A(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ordered_schur(A, decaying).status, SchurStatus::not_converged);
}

TEST(Balance, UndoesABadChoiceOfUnitsAndIsASimilarity) {
  const MatrixXd good = random_matrix(12, 3);
  const Eigen::VectorXd units =
      Eigen::VectorXd::NullaryExpr(12, [](Eigen::Index i) { return std::pow(10.0, 4 * static_cast<int>(i % 5) - 8); });
  const MatrixXd bad = units.asDiagonal() * good * units.cwiseInverse().asDiagonal();
  MatrixXd A = bad;
  const Eigen::VectorXd D = balance(A);
  // powers of two: exactly the same numbers
  EXPECT_EQ(D.asDiagonal() * A * D.cwiseInverse().asDiagonal(), bad);
  // rows and columns of the well chosen matrix are alike within a factor of a few; so must be the balanced ones
  for (int i = 0; i < 12; ++i) EXPECT_LT(std::abs(std::log(A.row(i).norm() / A.col(i).norm())), std::log(2.5));
  EXPECT_LT(A.norm(), 2.0 * good.norm());
}

}  // namespace
}  // namespace sunder::numerics
