#include "solver/simulation/face_compliance.hpp"

#include <algorithm>
#include <map>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::simulation {
namespace {

constexpr Eigen::Index block = 64;  ///< right sides a back-substitution: CHOLMOD's copies stay small

}  // namespace

FacePairs face_pairs(const mesh::PolygonMesh& polygons, const mesh::NodalMesh& nodes) {
  FacePairs all;
  std::vector<double> position, length;
  std::vector<mesh::Point> normal;
  std::map<std::array<int, 2>, std::size_t> known;  // by its nodes, the lower number first
  for (int c = 0; c < static_cast<int>(polygons.cracks.size()); ++c) {
    const crack::CrackPairs pairs = crack::crack_pairs(polygons, nodes, c);
    for (int i = 0; i < pairs.count(); ++i) {
      const auto [low, high] = std::minmax(pairs.lower[i], pairs.upper[i]);
      const auto [place, is_new] = known.try_emplace({low, high}, position.size());
      if (!is_new) {
        length[place->second] += pairs.tributary_length[i];
        continue;
      }
      all.pairs.lower.push_back(pairs.lower[i]);
      all.pairs.upper.push_back(pairs.upper[i]);
      all.crack.push_back(c);
      position.push_back(pairs.position[i]);
      length.push_back(pairs.tributary_length[i]);
      normal.emplace_back(pairs.normals.col(i));
    }
  }
  const auto n = static_cast<Eigen::Index>(position.size());
  all.pairs.position = Eigen::Map<const Eigen::VectorXd>(position.data(), n);
  all.pairs.tributary_length = Eigen::Map<const Eigen::VectorXd>(length.data(), n);
  all.pairs.normals.resize(2, n);
  for (Eigen::Index i = 0; i < n; ++i) all.pairs.normals.col(i) = normal[i];
  return all;
}

Eigen::SparseMatrix<double> pair_operator(const crack::CrackPairs& pairs, Eigen::Index dofs, bool tangential) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Eigen::Index column, int i, const mesh::Point& direction) {
    for (int component = 0; component < 2; ++component) {
      entries.emplace_back(2 * pairs.upper[i] + component, column, direction[component]);
      entries.emplace_back(2 * pairs.lower[i] + component, column, -direction[component]);
    }
  };
  const double side = numerics::planted_fault("simulation/pair-force-pulls") ? -1.0 : 1.0;
  for (int i = 0; i < pairs.count(); ++i) {
    const mesh::Point n = pairs.normals.col(i);
    add(i, i, side * n);
    if (tangential) add(pairs.count() + i, i, mesh::Point(n.y(), -n.x()));
  }
  Eigen::SparseMatrix<double> B(dofs, (tangential ? 2 : 1) * pairs.count());
  B.setFromTriplets(entries.begin(), entries.end());
  return B;
}

FaceCompliance face_compliance(const numerics::SymmetricFactor& factor, Eigen::SparseMatrix<double> B,
                               std::span<const char> fixed) {
  FaceCompliance compliance;
  compliance.X = B;
  for (std::size_t dof = 0; dof < fixed.size(); ++dof) {
    if (fixed[dof] != 0) compliance.X.row(static_cast<Eigen::Index>(dof)).setZero();
  }
  for (Eigen::Index first = 0; first < B.cols(); first += block) {
    factor.solve_in_place(compliance.X.middleCols(first, std::min(block, B.cols() - first)));
  }
  const Eigen::MatrixXd F = B.transpose() * compliance.X;
  compliance.F = 0.5 * (F + F.transpose());
  compliance.B = std::move(B);
  return compliance;
}

}  // namespace sunder::simulation
