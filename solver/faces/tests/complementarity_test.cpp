#include "solver/faces/complementarity.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sunder::faces {
namespace {

Eigen::MatrixXd random_matrix(int rows, int columns, std::mt19937& engine) {
  std::uniform_real_distribution<double> values(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return values(engine); });
}

/// M with positive definite symmetric part: a P-matrix, as the structure's answer with water is.
Eigen::MatrixXd dissipative(int n, std::mt19937& engine) {
  const Eigen::MatrixXd A = random_matrix(n, n, engine), B = random_matrix(n, n, engine);
  return A * A.transpose() + 0.01 * Eigen::MatrixXd::Identity(n, n) + 2.0 * (B - B.transpose());
}

TEST(Complementarity, FindsTheOnlySolutionOfRandomDissipativeProblems) {
  std::mt19937 engine(7);
  for (int n : {1, 2, 5, 12, 40}) {
    ComplementarityProblem problem(n);
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::MatrixXd M = dissipative(n, engine);
      const Eigen::VectorXd q = random_matrix(n, 1, engine);
      Eigen::VectorXd lambda(n);
      ASSERT_EQ(problem.solve(M, q, lambda), ComplementarityStatus::solved) << n << " " << trial;
      const Eigen::VectorXd slack = q + M * lambda;
      // Elimination of n unknowns of condition up to 1e5 leaves about n · 1e5 · eps.
      const double bound = 1e-9 * (1.0 + lambda.lpNorm<Eigen::Infinity>());
      EXPECT_GE(lambda.minCoeff(), 0.0);
      EXPECT_GE(slack.minCoeff(), -bound);
      EXPECT_LE(lambda.cwiseProduct(slack).cwiseAbs().maxCoeff(), bound * (1.0 + lambda.lpNorm<Eigen::Infinity>()));
    }
  }
}

TEST(Complementarity, StartsFromThePairsThatTouchedLast) {
  std::mt19937 engine(3);
  const Eigen::MatrixXd M = dissipative(20, engine);
  const Eigen::VectorXd q = random_matrix(20, 1, engine);
  Eigen::VectorXd lambda(20);
  ComplementarityProblem problem(20);
  ASSERT_EQ(problem.solve(M, q, lambda), ComplementarityStatus::solved);
  EXPECT_GT(problem.exchanges(), 0);
  ASSERT_EQ(problem.solve(M, q, lambda), ComplementarityStatus::solved);
  EXPECT_EQ(problem.exchanges(), 0);
}

TEST(Complementarity, TellsPairsThatCannotBeToldApart) {
  ComplementarityProblem problem(2);
  Eigen::VectorXd lambda(2);
  EXPECT_EQ(problem.solve(Eigen::Matrix2d::Ones(), Eigen::Vector2d(-1.0, -1.0), lambda),
            ComplementarityStatus::singular);
  EXPECT_EQ(lambda, Eigen::VectorXd::Zero(2));
}

TEST(Complementarity, NothingToDoWithoutPairs) {
  ComplementarityProblem problem(0);
  Eigen::VectorXd none(0);
  EXPECT_EQ(problem.solve(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0), none), ComplementarityStatus::solved);
}

}  // namespace
}  // namespace sunder::faces
