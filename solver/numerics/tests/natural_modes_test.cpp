#include "solver/numerics/natural_modes.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace sunder::numerics {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Springs and unit masses on an m x m grid with fixed rim: λ = 4 - 2 cos(iπ/(m+1)) - 2 cos(jπ/(m+1)), many of them
/// double.
Sparse grid_of_springs(int m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < m; ++row) {
    for (int column = 0; column < m; ++column) {
      const int i = row * m + column;
      entries.emplace_back(i, i, 4.0);
      if (column + 1 < m) entries.emplace_back(i, i + 1, -1.0), entries.emplace_back(i + 1, i, -1.0);
      if (row + 1 < m) entries.emplace_back(i, i + m, -1.0), entries.emplace_back(i + m, i, -1.0);
    }
  }
  Sparse matrix(m * m, m * m);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(LowestModes, FindsDoubleEigenvaluesTwice) {
  const int m = 17, count = 9;
  const Sparse stiffness = grid_of_springs(m);
  std::vector<double> exact;
  for (int i = 1; i <= m; ++i) {
    for (int j = 1; j <= m; ++j) {
      exact.push_back(4.0 - 2.0 * std::cos(i * std::numbers::pi / (m + 1)) -
                      2.0 * std::cos(j * std::numbers::pi / (m + 1)));
    }
  }
  std::sort(exact.begin(), exact.end());
  const Eigen::SimplicialLDLT<Sparse> factor(stiffness);
  const NaturalModes modes = lowest_modes(
      m * m, count, 0.0, [&](auto x, auto y) { y = factor.solve(x); }, [](auto x, auto y) { y = x; });
  ASSERT_EQ(modes.status, ModesStatus::converged);
  for (int i = 0; i < count; ++i) EXPECT_NEAR(modes.eigenvalues[i] / exact[i], 1.0, 1e-11) << i;  // 10 x the tolerance
  EXPECT_LT((modes.shapes.transpose() * modes.shapes - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-11);
  EXPECT_LT(modes.residual, 1e-5);  // vectors carry the square root of the tolerance, ‖r‖ ~ 1e-6
}

TEST(LowestModes, ShiftLetsABodyFloat) {
  // Free chain of three unit masses: λ = 0, 1, 3.
  Sparse stiffness(3, 3);
  const std::vector<Eigen::Triplet<double>> entries = {{0, 0, 1},  {1, 1, 2},  {2, 2, 1}, {0, 1, -1},
                                                       {1, 0, -1}, {1, 2, -1}, {2, 1, -1}};
  stiffness.setFromTriplets(entries.begin(), entries.end());
  Sparse shifted = stiffness;
  for (int i = 0; i < 3; ++i) shifted.coeffRef(i, i) += 0.5;
  const Eigen::SimplicialLDLT<Sparse> factor(shifted);
  const NaturalModes modes = lowest_modes(
      3, 2, 0.5, [&](auto x, auto y) { y = factor.solve(x); }, [](auto x, auto y) { y = x; });
  EXPECT_NEAR(modes.eigenvalues[0], 0.0, 1e-12);  // a few eps of the shifted spectrum
  EXPECT_NEAR(modes.eigenvalues[1], 1.0, 1e-12);
}

TEST(LowestModes, MassMayBeSingular) {
  // Two springs in series, the middle without mass: one mode, λ = (k/2) / m.
  Sparse stiffness(2, 2);
  const std::vector<Eigen::Triplet<double>> entries = {{0, 0, 2}, {0, 1, -1}, {1, 0, -1}, {1, 1, 1}};
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> factor(stiffness);
  const NaturalModes modes = lowest_modes(
      2, 1, 0.0, [&](auto x, auto y) { y = factor.solve(x); },
      [](auto x, auto y) {
        y = x;
        y[0] = 0.0;
      });
  EXPECT_NEAR(modes.eigenvalues[0], 0.5, 1e-14);
}

}  // namespace
}  // namespace sunder::numerics
