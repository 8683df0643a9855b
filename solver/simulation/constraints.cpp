#include "solver/simulation/constraints.hpp"

#include <Eigen/SVD>
#include <numeric>

namespace sunder::simulation {
namespace {

/// Rank of the 3 x 3 Gram matrix of the rigid motions' values at the prescribed dofs of one part.
struct RigidGram {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  int rank() const {
    // A lever arm of 1e-6 of the body still counts as a support against rotation: 1e-12 in the Gram matrix.
    Eigen::JacobiSVD<Eigen::Matrix3d> svd(gram);
    svd.setThreshold(1e-12);
    return gram.isZero() ? 0 : static_cast<int>(svd.rank());
  }
};

}  // namespace

std::vector<int> parts_of(const mesh::NodalMesh& mesh, int& count) {
  std::vector<int> parent(mesh.node_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (int i = 0; i < mesh.polygon_count(); ++i) {
    const mesh::NodalPolygon polygon = mesh.polygon(i);
    for (const int node : polygon.nodes) parent[root(node)] = root(polygon.nodes.front());
  }
  std::vector<int> part(parent.size()), number(parent.size(), -1);
  count = 0;
  for (int node = 0; node < mesh.node_count(); ++node) {
    int& name = number[root(node)];
    if (name < 0) name = count++;
    part[node] = name;
  }
  return part;
}

void eliminate(const Constraints& constraints, double scale, Eigen::SparseMatrix<double>& lower,
               Eigen::VectorXd& force) {
  const std::vector<char>& fixed = constraints.fixed;
  const Eigen::VectorXd& known = constraints.displacement;
  for (int column = 0; column < lower.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      const Eigen::Index row = entry.row();
      if (!fixed[row] && !fixed[column]) continue;
      if (!fixed[row]) force[row] -= entry.value() * known[column];
      if (!fixed[column]) force[column] -= entry.value() * known[row];
      entry.valueRef() = row == column ? scale : 0.0;
    }
  }
  for (Eigen::Index dof = 0; dof < force.size(); ++dof) {
    if (fixed[dof]) force[dof] = scale * known[dof];
  }
}

void remove_inertia(const Constraints& constraints, Eigen::SparseMatrix<double>& lower_mass) {
  for (int column = 0; column < lower_mass.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower_mass, column); entry; ++entry) {
      if (constraints.fixed[entry.row()] || constraints.fixed[column]) entry.valueRef() = 0.0;
    }
  }
}

std::vector<FreeMotion> free_motions(const mesh::NodalMesh& mesh, const Constraints& constraints) {
  int count = 0;
  const std::vector<int> part = parts_of(mesh, count);
  const Eigen::Matrix2Xd& x = mesh.coordinates();
  std::vector<mesh::Point> low(count, mesh::Point::Constant(INFINITY)), high(count, mesh::Point::Constant(-INFINITY));
  std::vector<int> some_node(count, -1);
  for (int node = 0; node < mesh.node_count(); ++node) {
    low[part[node]] = low[part[node]].cwiseMin(x.col(node));
    high[part[node]] = high[part[node]].cwiseMax(x.col(node));
    some_node[part[node]] = node;
  }
  std::vector<RigidGram> grams(count);
  for (int node = 0; node < mesh.node_count(); ++node) {
    const int p = part[node];
    const double size = (high[p] - low[p]).maxCoeff();
    const mesh::Point arm = (x.col(node) - 0.5 * (low[p] + high[p])) / size;
    if (constraints.fixed[2 * node]) {
      const Eigen::Vector3d row(1.0, 0.0, -arm.y());
      grams[p].gram += row * row.transpose();
    }
    if (constraints.fixed[2 * node + 1]) {
      const Eigen::Vector3d row(0.0, 1.0, arm.x());
      grams[p].gram += row * row.transpose();
    }
  }
  std::vector<FreeMotion> free;
  for (int p = 0; p < count; ++p) {
    const int motions = 3 - grams[p].rank();
    if (motions > 0) free.push_back({x.col(some_node[p]), motions});
  }
  return free;
}

}  // namespace sunder::simulation
