#include "solver/simulation/dynamic_body.hpp"

#include <map>
#include <tuple>

#include "solver/sbfem/assembly.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;

/// All columns of the cracks' loads side by side.
void join_loads(DynamicBody& body) {
  Index columns = 0;
  std::vector<Eigen::Triplet<double>> entries;
  body.first_load.clear();
  for (const CrackFaceLoads& crack : body.cracks) {
    body.first_load.push_back(columns);
    for (Index j = 0; j < crack.loads.cols(); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(crack.loads, j); entry; ++entry) {
        entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(columns + j), entry.value());
      }
    }
    columns += crack.count();
  }
  body.loads.resize(body.body.dofs(), columns);
  body.loads.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace

DynamicBody dynamic_body(const scene::Scene& scene, Body body, sbfem::Formation formation, bool rock_moves,
                         numerics::ThreadPool& pool, const std::optional<EarlierLoads>& earlier) {
  DynamicBody result;
  result.body = std::move(body);
  result.formation = std::move(formation);
  result.supports = supports_of(scene, result.body, rock_moves, rock_moves);
  sbfem::AssembledMatrices matrices = sbfem::assemble(result.body.nodes, result.formation, &pool);
  result.stiffness = std::move(matrices.stiffness);
  result.mass = std::move(matrices.mass);
  scene::Scene without_water = scene;  // the water in the cracks moves; it is no constant load
  without_water.crack_water.reset();
  result.interior = interior_loads(without_water, result.body, result.formation, pool, earlier, LoadDetail::forces);
  result.dead_load = boundary_forces(without_water, result.body) + crack_face_forces(without_water, result.body) +
                     result.interior.force;
  for (int crack = 0; crack < static_cast<int>(result.body.polygons.cracks.size()); ++crack) {
    result.cracks.push_back(crack_face_loads(without_water, result.body, result.formation, crack));
  }
  join_loads(result);
  return result;
}

faces::FaceStructure face_structure(const DynamicBody& body, const Eigen::MatrixXd& X, Eigen::MatrixXd mouth,
                                    std::span<const std::unique_ptr<faces::FaceWater>> waters) {
  faces::FaceStructure structure;
  const Eigen::MatrixXd answer = body.loads.transpose() * X;
  structure.answer = 0.5 * (answer + answer.transpose());
  structure.mouth = std::move(mouth);
  Index pairs = 0;
  for (const CrackFaceLoads& crack : body.cracks) pairs += crack.pairs.count();
  structure.tributary_length.resize(pairs);
  Index pair = 0;
  for (std::size_t c = 0; c < body.cracks.size(); ++c) {
    const Index n = body.cracks[c].pairs.count();
    structure.cracks.push_back({.first = body.first_load[c],
                                .pairs = n,
                                .forces = body.cracks[c].count(),
                                .water = waters.empty() ? nullptr : waters[c].get()});
    structure.tributary_length.segment(pair, n) = body.cracks[c].pairs.tributary_length;
    pair += n;
  }
  return structure;
}

std::vector<int> same_boundary_dofs(const Body& before, const Body& after) {
  // An edge is told by the places of its ends: the two nodes of a crack's mouth share a place, their edges do not.
  using Key = std::tuple<double, double, double, double>;
  const auto edges_of = [](const Body& body) {
    std::map<Key, std::vector<int>> edges;
    for (const auto& [name, vertices] : body.polygons.boundaries) {
      for (const PolygonEdge& place : find_edges(body.polygons, vertices)) {
        std::vector<int> nodes = body.nodes.edge_nodes(place.polygon, place.edge);
        const mesh::Point first = body.nodes.coordinates().col(nodes.front()),
                          last = body.nodes.coordinates().col(nodes.back());
        edges.emplace(Key{first.x(), first.y(), last.x(), last.y()}, std::move(nodes));
      }
    }
    return edges;
  };
  const std::map<Key, std::vector<int>> now = edges_of(after);
  std::vector<int> same(static_cast<std::size_t>(before.dofs()), -1);
  for (const auto& [key, nodes] : edges_of(before)) {
    const auto found = now.find(key);
    if (found == now.end() || found->second.size() != nodes.size()) continue;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (int component = 0; component < 2; ++component) {
        same[static_cast<std::size_t>(2 * nodes[i] + component)] = 2 * found->second[i] + component;
      }
    }
  }
  return same;
}

}  // namespace sunder::simulation
