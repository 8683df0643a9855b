#include "solver/mesh/nodal_mesh.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "solver/mesh/edge_table.hpp"
#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"

namespace sunder::mesh {
namespace {

/// Order of every mesh edge: the larger answer of its polygons.
std::vector<int> edge_orders(const PolygonMesh& mesh, const EdgeTable& table,
                             const std::function<int(int, int)>& order) {
  std::vector<int> orders(table.count(), 0);
  const bool take_smaller = numerics::planted_fault("mesh/shared-edge-order-minimum");
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    for (int e = 0; e < table.first[i + 1] - table.first[i]; ++e) {
      int wanted = order(i, e);
      if (numerics::planted_fault("mesh/order-raised-to-one")) wanted = std::max(wanted, 1);
      if (wanted < 1) {
        throw std::invalid_argument("order of polygon " + std::to_string(i) + ", edge " + std::to_string(e) + " is " +
                                    std::to_string(wanted) + ", must be >= 1");
      }
      int& taken = orders[table.edge[table.first[i] + e]];
      taken = taken == 0 ? wanted : take_smaller ? std::min(taken, wanted) : std::max(taken, wanted);
    }
  }
  return orders;
}

/// Inner Gauss-Lobatto points of each order that occurs, as fractions of the edge, 0 … 1.
std::map<int, std::vector<double>> inner_points(const std::vector<int>& orders) {
  std::map<int, std::vector<double>> points;
  for (const int p : orders) {
    if (p < 2 || points.contains(p)) continue;
    const auto rule = numerics::gauss_lobatto(p + 1);
    std::vector<double>& inner = points[p];
    for (int k = 1; k < p; ++k) inner.push_back(0.5 * (1.0 + rule.points[k]));
  }
  return points;
}

}  // namespace

NodalPolygon NodalMesh::polygon(int i) const {
  const auto slice = [](const std::vector<int>& values, int from, int to) {
    return std::span<const int>(values).subspan(from, to - from);
  };
  return {slice(nodes_, node_offsets_[i], node_offsets_[i + 1]), slice(orders_, edge_offsets_[i], edge_offsets_[i + 1]),
          centres_[i], open_[i] != 0, materials_[i]};
}

std::vector<int> NodalMesh::edge_nodes(int polygon_index, int edge) const {
  const NodalPolygon p = polygon(polygon_index);
  int start = 0;
  for (int e = 0; e < edge; ++e) start += p.orders[e];
  std::vector<int> nodes(p.orders[edge] + 1);
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = p.nodes[(start + k) % p.nodes.size()];
  return nodes;
}

NodalMesh place_nodes(const PolygonMesh& mesh, const std::function<int(int, int)>& order) {
  const EdgeTable table = edge_table(mesh);
  const std::vector<int> orders = edge_orders(mesh, table, order);
  const std::map<int, std::vector<double>> inner = inner_points(orders);

  NodalMesh nodal;
  const int vertices = static_cast<int>(mesh.vertices.size());
  std::vector<int> first_inner(table.count());
  int nodes = vertices;
  for (int e = 0; e < table.count(); ++e) {
    first_inner[e] = nodes;
    nodes += orders[e] - 1;
  }
  nodal.coordinates_.resize(2, nodes);
  for (int v = 0; v < vertices; ++v) nodal.coordinates_.col(v) = mesh.vertices[v];
  for (int e = 0; e < table.count(); ++e) {
    if (orders[e] == 1) continue;
    const Point a = mesh.vertices[table.ends[e][0]], b = mesh.vertices[table.ends[e][1]];
    const std::vector<double>& s = inner.at(orders[e]);
    for (std::size_t k = 0; k < s.size(); ++k) {
      nodal.coordinates_.col(first_inner[e] + static_cast<int>(k)) = (1.0 - s[k]) * a + s[k] * b;
    }
  }

  nodal.node_offsets_ = {0};
  nodal.edge_offsets_ = table.first;
  nodal.orders_.reserve(table.edge.size());
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) {
    const Polygon& polygon = mesh.polygons[i];
    for (int h = table.first[i]; h < table.first[i + 1]; ++h) {
      const int e = table.edge[h], from = polygon.vertices[h - table.first[i]];
      const bool forward = table.ends[e][0] == from;
      nodal.orders_.push_back(orders[e]);
      nodal.nodes_.push_back(from);
      for (int k = 0; k < orders[e] - 1; ++k) {
        nodal.nodes_.push_back(first_inner[e] + (forward ? k : orders[e] - 2 - k));
      }
    }
    if (polygon.open) nodal.nodes_.push_back(polygon.vertices.back());
    nodal.node_offsets_.push_back(static_cast<int>(nodal.nodes_.size()));
    nodal.centres_.push_back(polygon.scaling_centre);
    nodal.open_.push_back(polygon.open ? 1 : 0);
    nodal.materials_.push_back(polygon.material);
  }
  return nodal;
}

}  // namespace sunder::mesh
