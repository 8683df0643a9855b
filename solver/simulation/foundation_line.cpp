#include "solver/simulation/foundation_line.hpp"

#include <cassert>

#include "solver/mesh/ground_block.hpp"

namespace sunder::simulation {

FoundationLine foundation_line(const Body& body) {
  assert(body.rock >= 0);
  std::vector<int> nodes;
  FoundationLine line;
  line.boundary.open = true;
  for (const PolygonEdge& place : find_edges(body.polygons, body.polygons.boundaries.at(mesh::block_interface))) {
    const std::vector<int> on_edge = body.nodes.edge_nodes(place.polygon, place.edge);
    if (nodes.empty()) nodes.push_back(on_edge.front());
    assert(nodes.back() == on_edge.front());
    nodes.insert(nodes.end(), on_edge.begin() + 1, on_edge.end());
    line.boundary.orders.push_back(static_cast<int>(on_edge.size()) - 1);
  }
  line.boundary.nodes = body.nodes.coordinates()(Eigen::all, nodes);
  const mesh::Point centre =
      0.5 * (line.boundary.nodes.col(0) + line.boundary.nodes.col(line.boundary.nodes.cols() - 1));
  line.boundary.nodes.colwise() -= centre;
  // The ends lie on the free surface, to the last bit.
  line.boundary.nodes(1, 0) = line.boundary.nodes(1, line.boundary.nodes.cols() - 1) = 0.0;
  for (const int node : nodes) line.dofs.insert(line.dofs.end(), {2 * node, 2 * node + 1});
  return line;
}

foundation::UnboundedDomain rock_beyond(const FoundationLine& line, const material::Isotropic& rock) {
  return foundation::unbounded_domain(sbfem::coefficients(line.boundary, rock));
}

}  // namespace sunder::simulation
