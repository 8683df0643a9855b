#pragma once
/// Water at rest: on a face of the body, in the reservoir of a static scene, and in the cracks that open to it.
///
/// p = ρ g (level - y) below the surface, nothing above; g is that of [gravity], 9.81 m/s² without it. At rest every
/// model of the reservoir and both models of crack water are this one pressure: nothing flows, and in a closed tip the
/// resting profile is the hydrostatic one of the mouth.

#include <Eigen/Core>
#include <algorithm>
#include <optional>

#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

/// Nodal forces (2m) [N/m] of water with surface `level` [m] and weight ρ g [N/m³] on an edge with nodes (2, m) [m] in
/// order, the body on its left. Exact, also where the surface cuts the edge.
[[nodiscard]] Eigen::VectorXd water_on_edge(const Eigen::Matrix2Xd& nodes, double level, double weight);

/// ρ g [N/m³].
[[nodiscard]] double weight_of_water(const scene::Scene& scene, double density);

/// Water in a crack, at rest.
struct RestingWater {
  double mouth_pressure;  ///< [Pa], > 0
  double mouth_level;     ///< y of the mouth [m]
  double weight;          ///< ρ g of the water in the crack [N/m³]

  /// At height y [m]; linear between the vertices of the faces.
  double pressure(double y) const { return std::max(0.0, mouth_pressure + weight * (mouth_level - y)); }
};

/// Of tip `tip` (index in body.polygons.cracks). Absent: the scene has no [crack_water] or no [reservoir], the crack is
/// an inner one, or its mouth lies on another boundary or above the water: it stays dry.
[[nodiscard]] std::optional<RestingWater> resting_water(const scene::Scene& scene, const Body& body, int tip);

}  // namespace sunder::simulation
