#include "solver/mesh/edge_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace sunder::mesh {
namespace {

/// A polygon edge filed under its lower vertex.
struct Filed {
  int upper;     ///< the other vertex
  int position;  ///< index among all polygon edges
};

std::vector<Edge> polygon_edges(const PolygonMesh& mesh, std::vector<int>& first) {
  first.assign(mesh.polygons.size() + 1, 0);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    first[i + 1] = first[i] + std::max(0, mesh.polygons[i].edge_count());
  }
  std::vector<Edge> edges;
  edges.reserve(first.back());
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    for (int e = 0; e < mesh.polygons[i].edge_count(); ++e) {
      const Edge edge = mesh.polygons[i].edge(e);
      for (const int v : edge) {
        if (v < 0 || v >= vertices) {
          throw std::invalid_argument("polygon " + std::to_string(i) + ": vertex index " + std::to_string(v) +
                                      " is not in 0 … " + std::to_string(vertices - 1));
        }
      }
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace

EdgeTable edge_table(const PolygonMesh& mesh) {
  EdgeTable table;
  const std::vector<Edge> edges = polygon_edges(mesh, table.first);
  const int count = static_cast<int>(edges.size());

  // Counting sort by lower vertex; the few edges of one vertex are then sorted by their upper vertex. No hash, so the
  // order never depends on one.
  std::vector<int> bucket(mesh.vertices.size() + 1, 0);
  for (const Edge& e : edges) ++bucket[std::min(e[0], e[1]) + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) bucket[v + 1] += bucket[v];
  std::vector<Filed> filed(count);
  std::vector<int> next(bucket.begin(), bucket.end() - 1);
  for (int h = 0; h < count; ++h) {
    filed[next[std::min(edges[h][0], edges[h][1])]++] = {std::max(edges[h][0], edges[h][1]), h};
  }
  std::vector<int> leader(count);  // the first polygon edge that shows the same mesh edge
  for (std::size_t v = 0; v + 1 < bucket.size(); ++v) {
    const auto begin = filed.begin() + bucket[v], end = filed.begin() + bucket[v + 1];
    std::sort(begin, end, [](const Filed& a, const Filed& b) {
      return a.upper != b.upper ? a.upper < b.upper : a.position < b.position;
    });
    for (auto it = begin; it != end; ++it) {
      leader[it->position] = it != begin && (it - 1)->upper == it->upper ? leader[(it - 1)->position] : it->position;
    }
  }

  table.edge.resize(count);
  table.ends.reserve(count);
  for (int i = 0; i + 1 < static_cast<int>(table.first.size()); ++i) {
    for (int h = table.first[i]; h < table.first[i + 1]; ++h) {
      if (leader[h] == h) {
        table.edge[h] = table.count();
        table.ends.push_back(edges[h]);
        table.owners.push_back({i, -1});
        table.uses.push_back(1);
      } else {
        const int e = table.edge[h] = table.edge[leader[h]];
        if (++table.uses[e] == 2) table.owners[e][1] = i;
      }
    }
  }
  return table;
}

}  // namespace sunder::mesh
