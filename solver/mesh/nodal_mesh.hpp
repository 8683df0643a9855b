#pragma once
/// Nodes of chosen order on the edges of a polygon mesh: what the SBFEM sees.

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "solver/mesh/polygon_mesh.hpp"

namespace sunder::mesh {

/// The nodes of one polygon. Edge e of order p holds the local nodes start_e … start_e + p (modulo the count where the
/// boundary is closed), start_e being the sum of the orders before it. Within an edge the nodes are Gauss-Lobatto
/// points.
struct NodalPolygon {
  std::span<const int> nodes;   ///< global node indices along the boundary, counter-clockwise
  std::span<const int> orders;  ///< one an edge; their sum is nodes.size() where closed, nodes.size() - 1 where open
  Point scaling_centre;
  bool open = false;
  int material = 0;
};

class NodalMesh {
 public:
  int node_count() const { return static_cast<int>(coordinates_.cols()); }
  int polygon_count() const { return static_cast<int>(centres_.size()); }
  const Eigen::Matrix2Xd& coordinates() const { return coordinates_; }  ///< (2, nodes) [m]
  NodalPolygon polygon(int i) const;
  /// Global nodes of an edge of polygon `polygon`, in order, both ends included.
  std::vector<int> edge_nodes(int polygon, int edge) const;

 private:
  friend NodalMesh place_nodes(const PolygonMesh&, const std::function<int(int, int)>&);
  Eigen::Matrix2Xd coordinates_;
  std::vector<int> node_offsets_, nodes_, edge_offsets_, orders_, materials_;
  std::vector<Point> centres_;
  std::vector<char> open_;
};

/// Places the nodes. Vertex i of the mesh becomes node i. `order(polygon, edge)` >= 1 is asked for every edge; an edge
/// of two polygons takes the larger answer.
NodalMesh place_nodes(const PolygonMesh& mesh, const std::function<int(int polygon, int edge)>& order);

}  // namespace sunder::mesh
