#include "solver/sbfem/assembly.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include "solver/sbfem/tests/meshes.hpp"

namespace sunder::sbfem {
namespace {

using namespace testing;

const std::vector<material::Isotropic> concrete = {{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0}};

Eigen::MatrixXd dense_sum(const mesh::NodalMesh& mesh, const Formation& formation) {
  const int N = 2 * mesh.node_count();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(N, N);
  for (int p = 0; p < mesh.polygon_count(); ++p) {
    const auto nodes = mesh.polygon(p).nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        sum.block<2, 2>(2 * nodes[i], 2 * nodes[j]) += formation.stiffness(p).block<2, 2>(2 * i, 2 * j);
      }
    }
  }
  return sum;
}

TEST(Assembly, IsTheSumOfThePolygons) {
  const mesh::NodalMesh mesh =
      place_nodes(honeycomb(5, 4), [](int polygon, int edge) { return 1 + (polygon + edge) % 3; });
  const Formation formation = form(mesh, concrete);
  const Eigen::SparseMatrix<double> K = assemble_stiffness(mesh, formation);
  const Eigen::MatrixXd expected = dense_sum(mesh, formation);
  // at most three polygons meet at a node: two roundings apart
  EXPECT_LT((Eigen::MatrixXd(K) - Eigen::MatrixXd(expected.triangularView<Eigen::Lower>())).norm(),
            1e-15 * expected.norm());
  ASSERT_TRUE(K.isCompressed());
  for (int column = 0; column < K.outerSize(); ++column) {
    int last = column - 1;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry) {
      EXPECT_GT(entry.row(), last);
      last = static_cast<int>(entry.row());
    }
  }
}

TEST(Assembly, RigidBodyFeelsNoForceAndWeighsItsArea) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(6, 5), [](int, int) { return 2; });
  const Formation formation = form(mesh, concrete, {.with_mass = true});
  const Eigen::SparseMatrix<double> K = assemble_stiffness(mesh, formation), M = assemble_mass(mesh, formation);
  const int nodes = mesh.node_count();
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(2 * nodes, 3);
  double area = 0.0;
  for (int i = 0; i < nodes; ++i) {
    rigid(2 * i, 0) = rigid(2 * i + 1, 1) = 1.0;
    rigid(2 * i, 2) = -mesh.coordinates()(1, i);
    rigid(2 * i + 1, 2) = mesh.coordinates()(0, i);
  }
  for (int p = 0; p < mesh.polygon_count(); ++p) {
    const auto around = mesh.polygon(p).nodes;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Eigen::Vector2d a = mesh.coordinates().col(around[i]),
                            b = mesh.coordinates().col(around[(i + 1) % around.size()]);
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
  }
  const Eigen::MatrixXd force = K.selfadjointView<Eigen::Lower>() * rigid;
  EXPECT_LT(force.norm(), 1e-14 * K.norm() * rigid.norm());
  const Eigen::MatrixXd weight =
      rigid.leftCols(2).transpose() * (M.selfadjointView<Eigen::Lower>() * rigid.leftCols(2));
  EXPECT_LT((weight / (2400.0 * area) - Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(Assembly, HasTheSameBitsForAnyNumberOfThreads) {
  // more nodes than one part of the pattern, so that the parts are joined
  const mesh::NodalMesh mesh = place_nodes(honeycomb(60, 50), [](int, int) { return 1; });
  ASSERT_GT(mesh.node_count(), 5000);
  const Formation formation = form(mesh, concrete);
  const Eigen::SparseMatrix<double> one = assemble_stiffness(mesh, formation);
  for (const int threads : {2, 3}) {
    numerics::ThreadPool pool(threads);
    const Eigen::SparseMatrix<double> many = assemble_stiffness(mesh, formation, &pool);
    ASSERT_EQ(one.nonZeros(), many.nonZeros());
    const auto count = static_cast<std::size_t>(one.nonZeros());
    EXPECT_EQ(std::memcmp(one.valuePtr(), many.valuePtr(), count * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(one.innerIndexPtr(), many.innerIndexPtr(), count * sizeof(int)), 0);
  }
}

TEST(Assembly, RefusesMassThatWasNotFormed) {
  const mesh::NodalMesh mesh = place_nodes(honeycomb(2, 2), [](int, int) { return 1; });
  EXPECT_THROW(assemble_mass(mesh, form(mesh, concrete)), std::invalid_argument);
}

TEST(Assembly, EmptyMeshGivesAnEmptyMatrix) {
  const mesh::NodalMesh mesh = mesh::place_nodes(mesh::PolygonMesh{}, [](int, int) { return 1; });
  EXPECT_EQ(assemble_stiffness(mesh, form(mesh, concrete)).nonZeros(), 0);
}

}  // namespace
}  // namespace sunder::sbfem
