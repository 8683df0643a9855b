#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numbers>

#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/polygon_solution.hpp"
#include "solver/sbfem/tests/polygons.hpp"

namespace sunder::sbfem {
namespace {

using namespace testing;
using Eigen::MatrixXd;

const material::Isotropic concrete{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0};

/// (I + A)ᵀ M + M (I + A) = M0 as one linear system for all entries of M: Kronecker products, no iteration.
MatrixXd mass_by_kronecker(const Coefficients& c, const MatrixXd& A) {
  const Eigen::Index N = A.rows();
  const MatrixXd G = MatrixXd::Identity(N, N) + A;
  MatrixXd system = MatrixXd::Zero(N * N, N * N);
  for (Eigen::Index j = 0; j < N; ++j) {
    system.block(j * N, j * N, N, N) += G.transpose();
    for (Eigen::Index k = 0; k < N; ++k) system.block(j * N, k * N, N, N).diagonal().array() += G(k, j);
  }
  const Eigen::VectorXd m = system.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(c.M0.data(), N * N));
  return Eigen::Map<const MatrixXd>(m.data(), N, N);
}

/// M = Vu⁻ᵀ m Vu⁻¹ with (I - S)ᵀ m + m (I - S) = Vuᵀ M0 Vu, row by row on the quasi-triangular S: the modal form.
MatrixXd mass_by_modes(const Coefficients& c) {
  const ModalSolution all = modes(c);
  const Eigen::Index N = all.S.rows();
  const MatrixXd right = all.Vu.transpose() * c.M0 * all.Vu, T = MatrixXd::Identity(N, N) - all.S;
  MatrixXd m = MatrixXd::Zero(N, N);
  for (Eigen::Index i = 0; i < N;) {
    const Eigen::Index size = i + 1 < N && T(i + 1, i) != 0.0 ? 2 : 1;
    // rows i … i + size - 1: T_iiᵀ m_i + m_i T = right_i - Σ_k<i T_kiᵀ m_k
    MatrixXd rows = right.middleRows(i, size) - T.block(0, i, i, size).transpose() * m.topRows(i);
    MatrixXd system = MatrixXd::Zero(size * N, size * N);
    for (Eigen::Index j = 0; j < N; ++j) {
      system.block(j * size, j * size, size, size) += T.block(i, i, size, size).transpose();
      for (Eigen::Index k = 0; k < N; ++k) system.block(j * size, k * size, size, size).diagonal().array() += T(k, j);
    }
    const Eigen::VectorXd x = system.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(rows.data(), size * N));
    m.middleRows(i, size) = Eigen::Map<const MatrixXd>(x.data(), size, N);
    i += size;
  }
  const MatrixXd inverse = all.Vu.inverse();
  return inverse.transpose() * m * inverse;
}

TEST(Mass, EqualsADirectSolutionOfTheClosedLoop) {
  for (const bool open : {false, true}) {
    const Boundary polygon =
        open ? boundary(notch_vertices(6, 2.0 * std::numbers::pi), 1, true) : boundary(irregular_vertices(), 2);
    const Coefficients c = coefficients(polygon, concrete);
    const PolygonSolution solution = solve_polygon(c);
    const MatrixXd M = mass(c, solution);
    // the acceptance bar of two solutions of the closed loop
    EXPECT_LT((M - mass_by_kronecker(c, solution.A)).norm(), 1e-10 * M.norm());
    EXPECT_EQ(M, M.transpose());
  }
}

TEST(Mass, EqualsTheModalForm) {
  for (const int p : {1, 4, 8}) {
    const Coefficients c = coefficients(boundary(irregular_vertices(), p), concrete);
    const MatrixXd M = mass(c, solve_polygon(c));
    EXPECT_LT((M - mass_by_modes(c)).norm(), 1e-10 * M.norm()) << p;
  }
}

TEST(Mass, MomentsOfLinearDisplacementsAreExact) {
  // u = a + B x is carried exactly: uᵀ M u = ρ ∫ |u|² dA, on a rectangle w h with centre at (x0, y0).
  const double w = 3.0, h = 2.0, x0 = 0.4, y0 = -0.3;
  std::vector<Eigen::Vector2d> vertices = rectangle_vertices(w, h);
  for (Eigen::Vector2d& vertex : vertices) vertex += Eigen::Vector2d(x0, y0);
  Eigen::Matrix3d moments;  // ∫ {1, x, y}ᵀ {1, x, y} dA
  moments << 1.0, x0, y0, x0, x0 * x0 + w * w / 12.0, x0 * y0, y0, x0 * y0, y0 * y0 + h * h / 12.0;
  moments *= 2400.0 * w * h;
  for (const int p : {1, 2, 5}) {
    const Boundary polygon = boundary(vertices, p);
    const Coefficients c = coefficients(polygon, concrete);
    const MatrixXd M = mass(c, solve_polygon(c));
    MatrixXd linear = MatrixXd::Zero(M.rows(), 6);  // {1, x, y} of the first component, then of the second
    for (Eigen::Index i = 0; i < polygon.nodes.cols(); ++i) {
      for (int component = 0; component < 2; ++component) {
        linear.block<1, 3>(2 * i + component, 3 * component) << 1.0, polygon.nodes(0, i), polygon.nodes(1, i);
      }
    }
    MatrixXd expected = MatrixXd::Zero(6, 6);
    expected.topLeftCorner<3, 3>() = expected.bottomRightCorner<3, 3>() = moments;
    // the acceptance bar; round-off of K enters through A
    EXPECT_LT((linear.transpose() * M * linear - expected).norm(), 1e-12 * expected.norm()) << p;
  }
}

TEST(Mass, KeepsItsAreaOnSliversAndShortEdges) {
  for (const double height : {1e-2, 1e-4, 1e-6}) {
    for (const int p : {1, 2, 4}) {
      const Coefficients c = coefficients(boundary(rectangle_vertices(1.0, height), p), concrete);
      const MatrixXd M = mass(c, solve_polygon(c));
      double sum = 0.0;
      for (Eigen::Index i = 0; i < M.rows(); i += 2) {
        for (Eigen::Index j = 0; j < M.cols(); j += 2) sum += M(i, j);
      }
      // ε λ_max with λ_max of about 10 / height, and a factor of 10
      EXPECT_NEAR(sum / (2400.0 * height), 1.0, 2e-14 / height) << height << ' ' << p;
    }
  }
}

TEST(Mass, IsPositiveDefinite) {
  const Coefficients c = coefficients(boundary(star_vertices(6, 0.4), 3), concrete);
  const MatrixXd M = mass(c, solve_polygon(c));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixXd>(M).eigenvalues()[0], 0.0);
}

TEST(Mass, IsZeroWithoutDensity) {
  const Coefficients c = coefficients(boundary(irregular_vertices(), 1), {.youngs_modulus = 1.0, .poisson_ratio = 0.2});
  EXPECT_EQ(mass(c, solve_polygon(c)).norm(), 0.0);
}

}  // namespace
}  // namespace sunder::sbfem
