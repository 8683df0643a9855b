#pragma once
/// The two faces of a crack as pairs of opposite points: where contact presses, water pushes, and the crack opens.
///
/// Pairs are counted from the mouth (of an inner crack: from the pair in its middle, which both its tips' faces have)
/// to the ends of the tip polygon. From there to the tip no pair is needed: the opening follows the tip polygon's own
/// field, and the last pair stands for that stretch.

#include <Eigen/Core>
#include <vector>

#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::crack {

struct CrackPairs {
  std::vector<int> lower, upper;  ///< (n) nodes on the right and on the left of the path, seen from the mouth
  Eigen::VectorXd position;       ///< (n) arc length from the first pair [m], ascending
  /// ∫ N_i ds over the faces [m], (n): N_i are the shape functions of the edges; on the last stretch, inside the tip
  /// polygon, N falls linearly from 1 to 0 at the tip.
  Eigen::VectorXd tributary_length;
  /// (2, n): unit normal from the lower to the upper face, at a kink the direction of ∫ N_i n ds.
  Eigen::Matrix2Xd normals;
  double tip_position = 0.0;  ///< arc length of the tip, or of the end where the crack has reached a face [m]

  int count() const { return static_cast<int>(lower.size()); }
};

/// Pairs of mesh.cracks[crack]. `nodes` are the nodes of this mesh. Throws std::invalid_argument where there is no such
/// crack or where opposite edges of its faces have nodes of different order. O(edges of the mesh).
CrackPairs crack_pairs(const mesh::PolygonMesh& mesh, const mesh::NodalMesh& nodes, int crack);

struct CrackMotion {
  Eigen::VectorXd opening;  ///< (n) n · (u_upper - u_lower) [m]; negative: the faces penetrate each other
  Eigen::VectorXd sliding;  ///< (n) t · (u_upper - u_lower) [m], t = direction from the mouth to the tip
};

/// Relative motion of the faces, from displacements (2 · nodes) in the order u_x, u_y of each node [m]. The same
/// function serves velocities.
CrackMotion crack_motion(const CrackPairs& pairs, const Eigen::Ref<const Eigen::VectorXd>& displacement);

}  // namespace sunder::crack
