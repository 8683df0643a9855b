#pragma once
/// The vertical face of a dam, how deep it stands in the water, and what the water's pressure does to its nodes.

#include <Eigen/Core>
#include <vector>

namespace sunder::reservoir {

/// Elements from the bottom up, each of order p >= 1 with its p + 1 nodes at Gauss-Lobatto points. Neighbours share a
/// node, or, where a crack opens into the face, have one each at the same height.
struct Face {
  Eigen::VectorXd heights;                 ///< (n) of the nodes [m]
  std::vector<std::vector<int>> elements;  ///< nodes of each element, bottom to top

  int size() const { return static_cast<int>(heights.size()); }
};

/// Equal elements of one order from 0 to `height` [m].
[[nodiscard]] Face uniform_face(double height, int elements, int order);

/// Part of an element below the water's surface. A surface nearer to a node than 1e-9 of the depth counts as on it.
struct WetElement {
  int element = 0;
  double lower = 0.0, upper = 0.0;  ///< of the element [m]
  double surface = 0.0;             ///< upper end of the wet part [m], = upper but in the last
};

/// Throws std::invalid_argument naming value and bound where the elements do not follow one another upwards, an order
/// is not 1 … 32, a node is missing, or `level` is not above the bottom and at most at the top.
[[nodiscard]] std::vector<WetElement> wet_elements(const Face& face, double level);

/// N_i(y) of the nodes of an element that reaches from `lower` to `upper`.
[[nodiscard]] Eigen::VectorXd shape_functions(int order, double lower, double upper, double y);

/// The water's pressure on the face, continuous, of the order of each element, zero at the surface: its own nodes from
/// the bottom up, the m below the surface.
struct PressureMesh {
  std::vector<WetElement> wet;
  std::vector<int> orders, first;  ///< of each wet element; its lowest pressure node
  int size = 0;                    ///< m
  double bottom = 0.0, level = 0.0;
  Eigen::MatrixXd mass;       ///< A = ∫ Nᵀ N dy (m, m) [m]
  Eigen::MatrixXd stiffness;  ///< K = ∫ N'ᵀ N' dy (m, m) [1/m]
  Eigen::MatrixXd load;       ///< ∫ Nᵀ N_face dy (m, n) [m]: nodal forces are loadᵀ p

  double depth() const { return level - bottom; }
  /// Values of the pressure's shape functions (m) at a height; zero above the water and below the bottom.
  Eigen::VectorXd values(double height) const;
};

[[nodiscard]] PressureMesh pressure_mesh(const Face& face, double level);

/// g (n) with p(height) = g · R [1/m]: the pressure whose consistent nodal forces are R. Since R = W_0 a + history, the
/// same is p = (W_0 g) · a + g · history: what a crack's mouth wants. Positive where the face pushes into the water.
[[nodiscard]] Eigen::VectorXd pressure_functional(const PressureMesh& mesh, double height);

}  // namespace sunder::reservoir
