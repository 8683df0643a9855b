#include "solver/simulation/static_loads.hpp"

#include <array>
#include <string>

#include "solver/mesh/ground_block.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/standing_water.hpp"

namespace sunder::simulation {
namespace {

using Eigen::VectorXd;
using mesh::Point;

std::string words(const Point& x) {
  return "(" + std::to_string(x.x()) + ", " + std::to_string(x.y()) + ")";
}

double extent(const mesh::NodalMesh& nodes) {
  return (nodes.coordinates().rowwise().maxCoeff() - nodes.coordinates().rowwise().minCoeff()).maxCoeff();
}

std::vector<int> supported_nodes(const scene::Scene& scene, const Body& body, std::size_t index) {
  const scene::Support& support = scene.supports[index];
  if (!support.point) return boundary_nodes(body, support.boundary);
  int nearest = 0;
  const double distance = (body.nodes.coordinates().colwise() - *support.point).colwise().norm().minCoeff(&nearest);
  if (distance > 1e-6 * extent(body.nodes)) {
    const Point place = body.nodes.coordinates().col(nearest);
    throw scene::SceneError(scene::place_of(scene, "support[" + std::to_string(index) + "]") + "point: no node at " +
                            words(*support.point) + ", the nearest one is " + words(place) +
                            "; accepted: a node within 1e-6 of the body's size");
  }
  return {nearest};
}

void refuse_free_motions(const scene::Scene& scene, const Body& body, const Constraints& constraints) {
  const std::vector<FreeMotion> free = free_motions(body.nodes, constraints);
  if (free.empty()) return;
  throw scene::SceneError(
      scene::place_of(scene, scene.supports.empty() ? "support" : "support[0]") + "the part of the body at " +
      words(free.front().somewhere) + " can still move rigidly in " + std::to_string(free.front().motions) +
      " way(s); accepted: supports that hold every part against both displacements and the rotation");
}

/// Adds the forces of one edge, given by its nodes in order.
void scatter(const std::vector<int>& nodes, const VectorXd& edge_force, VectorXd& force) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    force.segment<2>(2 * nodes[i]) += edge_force.segment<2>(2 * static_cast<Eigen::Index>(i));
  }
}

Eigen::Matrix2Xd places(const Body& body, const std::vector<int>& nodes) {
  return body.nodes.coordinates()(Eigen::all, nodes);
}

/// Distance of each pair of the faces from the tip over the length of the crack (inner: of this half), mouth first;
/// from the end where the crack has come out at a face.
std::vector<double> distance_from_tip(const mesh::PolygonMesh& mesh, const mesh::CrackFaces& faces) {
  std::vector<double> distance(faces.lower.size());
  double from_tip = 0.0;
  if (faces.tip_polygon >= 0) {
    from_tip = (mesh.vertices[faces.lower.back()] - mesh.polygons[faces.tip_polygon].scaling_centre).norm();
  }
  for (std::size_t i = faces.lower.size(); i-- > 0;) {
    distance[i] = from_tip;
    if (i > 0) from_tip += (mesh.vertices[faces.lower[i]] - mesh.vertices[faces.lower[i - 1]]).norm();
  }
  for (double& value : distance) value /= from_tip;
  return distance;
}

/// What presses on the faces of one crack.
struct FacePressure {
  std::vector<double> distance;     ///< of each vertex of the chain from the tip, see above
  std::vector<double> by_distance;  ///< the scene's own pressure, in powers of that distance
  std::vector<double> water;        ///< resting water instead: at each vertex, and last at the tip [Pa]

  bool empty() const { return by_distance.empty() && water.empty(); }
};

FacePressure face_pressure(const scene::Scene& scene, const Body& body, int tip) {
  const mesh::CrackFaces& faces = body.polygons.cracks[tip];
  FacePressure pressure;
  if (const std::optional<RestingWater> water = resting_water(scene, body, tip)) {
    for (const int vertex : faces.lower) pressure.water.push_back(water->pressure(body.polygons.vertices[vertex].y()));
    if (faces.tip_polygon >= 0) {
      pressure.water.push_back(water->pressure(body.polygons.polygons[faces.tip_polygon].scaling_centre.y()));
    }
    return pressure;
  }
  pressure.by_distance = scene.cracks[crack_of_tip(scene, tip)].pressure;
  if (!pressure.by_distance.empty()) pressure.distance = distance_from_tip(body.polygons, faces);
  return pressure;
}

/// Pressure on the faces of one crack between two places, each by its vertex index in the chain: powers of the fraction
/// of the way from the first to the last.
std::vector<double> pressure_between(const FacePressure& pressure, std::size_t first, std::size_t last) {
  if (pressure.water.empty()) {
    return sbfem::restrict_polynomial(pressure.by_distance, pressure.distance[first], pressure.distance[last]);
  }
  return {pressure.water[first], pressure.water[last] - pressure.water[first]};
}

/// Pressure on the chain of vertices of one face, from the mouth to the tip polygon.
void add_face(const Body& body, const std::vector<int>& chain, const FacePressure& pressure, VectorXd& force) {
  std::vector<mesh::Edge> edges;
  for (std::size_t i = 1; i < chain.size(); ++i) edges.push_back({chain[i - 1], chain[i]});
  const std::vector<PolygonEdge> found = find_edges(body.polygons, edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<int> nodes = body.nodes.edge_nodes(found[i].polygon, found[i].edge);
    const bool towards_tip = nodes.front() == edges[i][0];
    const std::vector<double> on_edge = pressure_between(pressure, towards_tip ? i : i + 1, towards_tip ? i + 1 : i);
    scatter(nodes, sbfem::edge_pressure(places(body, nodes), on_edge), force);
  }
}

}  // namespace

Supports supports_of(const scene::Scene& scene, const Body& body, bool may_float, bool rock_moves) {
  Supports supports{.constraints = Constraints(body.dofs()), .dofs = {}};
  if (body.rock >= 0 && !rock_moves) {
    for (const int node : boundary_nodes(body, mesh::block_interface)) {
      supports.constraints.prescribe(2 * node, 0.0);
      supports.constraints.prescribe(2 * node + 1, 0.0);
    }
  }
  std::vector<int> holder(body.dofs(), -1);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const scene::Support& support = scene.supports[i];
    for (const int node : supported_nodes(scene, body, i)) {
      for (int component = 0; component < 2; ++component) {
        if (!support.fix[component]) continue;
        supports.constraints.prescribe(2 * node + component, support.displacement[component]);
        holder[2 * node + component] = static_cast<int>(i);
      }
    }
  }
  supports.dofs.resize(scene.supports.size());
  for (int dof = 0; dof < body.dofs(); ++dof) {
    if (holder[dof] >= 0) supports.dofs[holder[dof]].push_back(dof);
  }
  if (!may_float) refuse_free_motions(scene, body, supports.constraints);
  return supports;
}

VectorXd boundary_forces(const scene::Scene& scene, const Body& body) {
  VectorXd force = VectorXd::Zero(body.dofs());
  for (const scene::Load& load : scene.loads) {
    const Eigen::Matrix2Xd traction = Point(load.traction[0], load.traction[1]);
    const std::array<double, 1> pressure = {load.pressure};
    for (const PolygonEdge& place : find_edges(body.polygons, body.polygons.boundaries.at(load.boundary))) {
      const std::vector<int> nodes = body.nodes.edge_nodes(place.polygon, place.edge);
      const Eigen::Matrix2Xd x = places(body, nodes);
      scatter(nodes, sbfem::edge_traction(x, traction) + sbfem::edge_pressure(x, pressure), force);
      if (load.water_level) {
        scatter(nodes, water_on_edge(x, *load.water_level, weight_of_water(scene, load.water_density)), force);
      }
    }
  }
  if (scene.reservoir) {
    const double weight = weight_of_water(scene, scene.reservoir->density);
    for (const PolygonEdge& place : find_edges(body.polygons, body.polygons.boundaries.at(scene.reservoir->boundary))) {
      const std::vector<int> nodes = body.nodes.edge_nodes(place.polygon, place.edge);
      scatter(nodes, water_on_edge(places(body, nodes), *scene.reservoir->level, weight), force);
    }
  }
  return force;
}

int crack_of_tip(const scene::Scene& scene, int tip) {
  int first = 0;
  for (std::size_t i = 0; i < scene.cracks.size(); ++i) {
    first += scene.cracks[i].inner ? 2 : 1;
    if (tip < first) return static_cast<int>(i);
  }
  return -1;
}

VectorXd crack_face_forces(const scene::Scene& scene, const Body& body) {
  VectorXd force = VectorXd::Zero(body.dofs());
  for (std::size_t tip = 0; tip < body.polygons.cracks.size(); ++tip) {
    const FacePressure pressure = face_pressure(scene, body, static_cast<int>(tip));
    if (pressure.empty()) continue;
    const mesh::CrackFaces& faces = body.polygons.cracks[tip];
    add_face(body, faces.lower, pressure, force);
    add_face(body, faces.upper, pressure, force);
  }
  return force;
}

std::vector<sbfem::RadialLoad> tip_pressure(const scene::Scene& scene, const Body& body, int tip,
                                            const sbfem::Boundary& boundary) {
  const FacePressure pressure = face_pressure(scene, body, tip);
  if (pressure.empty()) return {};
  if (pressure.water.empty()) {
    return sbfem::crack_face_pressure(boundary,
                                      sbfem::restrict_polynomial(pressure.by_distance, 0.0, pressure.distance.back()));
  }
  const std::size_t at_tip = pressure.water.size() - 1;
  return sbfem::crack_face_pressure(boundary, pressure_between(pressure, at_tip, at_tip - 1));
}

}  // namespace sunder::simulation
