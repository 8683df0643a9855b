// The water of [reservoir] as a medium of the body.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <unordered_map>

#include "solver/convolution/simple_convolutions.hpp"
#include "solver/reservoir/added_mass.hpp"
#include "solver/reservoir/face_water.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/attached_medium.hpp"
#include "solver/simulation/built_parts.hpp"

namespace sunder::simulation {

const bool built::reservoir = true;

namespace {

/// The wet part of the boundary as module reservoir wants it.
struct WetBoundary {
  reservoir::Face face;
  std::vector<int> nodes;    ///< of the body, ascending: face node i is nodes[i]
  double into_water = -1.0;  ///< sign of x from the body into the water
};

void refuse(const scene::Scene& scene, const std::string& what) {
  throw scene::SceneError(scene::place_of(scene, "reservoir") + what);
}

/// Calls `work` and turns what module reservoir refuses into a SceneError at its table.
template <class Work>
auto at_reservoir(const scene::Scene& scene, Work work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw scene::SceneError(scene::place_of(scene, "reservoir") + error.what());
  }
}

/// Edges of the boundary with their nodes from the bottom up.
std::vector<std::vector<int>> upward_edges(const scene::Scene& scene, const Body& body, double& into_water) {
  const Eigen::Matrix2Xd& x = body.nodes.coordinates();
  const std::string& boundary = scene.reservoir->boundary;
  const auto found = body.polygons.boundaries.find(boundary);
  if (found == body.polygons.boundaries.end()) refuse(scene, "boundary: there is no boundary \"" + boundary + "\"");
  std::vector<std::vector<int>> edges;
  int up = 0;
  for (const PolygonEdge& place : find_edges(body.polygons, found->second)) {
    std::vector<int> nodes = body.nodes.edge_nodes(place.polygon, place.edge);
    const bool upward = x(1, nodes.back()) > x(1, nodes.front());
    up += upward ? 1 : -1;
    if (!upward) std::reverse(nodes.begin(), nodes.end());
    edges.push_back(std::move(nodes));
  }
  if (edges.empty()) refuse(scene, "boundary: \"" + boundary + "\" has no edges");
  // polygons run counter-clockwise: their edges go down where the outside lies at -x
  into_water = up < 0 ? -1.0 : 1.0;
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return x(1, a[0]) < x(1, b[0]); });
  return edges;
}

void check_vertical(const scene::Scene& scene, const Body& body, const std::vector<std::vector<int>>& edges) {
  const Eigen::Matrix2Xd& x = body.nodes.coordinates();
  const double first = x(0, edges.front().front());
  const double height = x(1, edges.back().back()) - x(1, edges.front().front());
  for (const std::vector<int>& edge : edges)
    for (const int node : edge)
      if (!(std::abs(x(0, node) - first) <= 1e-6 * height))
        refuse(scene, "boundary: \"" + scene.reservoir->boundary + "\" is inclined or bent (x = " +
                          std::to_string(first) + " and " + std::to_string(x(0, node)) +
                          " m); accepted: one vertical line, or model = \"hydrostatic\" on any face");
}

WetBoundary wet_boundary(const scene::Scene& scene, const Body& body) {
  WetBoundary wet;
  const std::vector<std::vector<int>> edges = upward_edges(scene, body, wet.into_water);
  check_vertical(scene, body, edges);
  const Eigen::Matrix2Xd& x = body.nodes.coordinates();
  // the whole face first, so that a level that is not on it is refused with the face's own ends
  reservoir::Face whole{x.row(1).transpose(), edges};
  const std::vector<reservoir::WetElement> parts =
      at_reservoir(scene, [&] { return reservoir::wet_elements(whole, *scene.reservoir->level); });
  for (const reservoir::WetElement& part : parts) {
    const std::vector<int>& edge = edges[static_cast<std::size_t>(part.element)];
    wet.nodes.insert(wet.nodes.end(), edge.begin(), edge.end());
  }
  std::sort(wet.nodes.begin(), wet.nodes.end());
  wet.nodes.erase(std::unique(wet.nodes.begin(), wet.nodes.end()), wet.nodes.end());
  std::unordered_map<int, int> number;
  wet.face.heights.resize(static_cast<Eigen::Index>(wet.nodes.size()));
  for (std::size_t i = 0; i < wet.nodes.size(); ++i) {
    number[wet.nodes[i]] = static_cast<int>(i);
    wet.face.heights[static_cast<Eigen::Index>(i)] = x(1, wet.nodes[i]);
  }
  for (const reservoir::WetElement& part : parts) {
    std::vector<int>& nodes = wet.face.elements.emplace_back(edges[static_cast<std::size_t>(part.element)]);
    for (int& node : nodes) node = number.at(node);
  }
  return wet;
}

reservoir::Water water_of(const scene::Reservoir& reservoir) {
  return {.density = reservoir.density,
          .sound_speed = reservoir.sound_speed,
          .reflection_coefficient = reservoir.reflection_coefficient};
}

/// Compressible water: all of its memory, or that of a few exponentials.
void convolve_with(const scene::Reservoir& reservoir, const WetBoundary& wet, const StepPlan& plan,
                   numerics::ThreadPool& pool, AttachedMedium& medium) {
  convolution::ConvolutionOptions options{.pool = &pool};
  if (reservoir.memory_tolerance > 0.0) {
    options.method = convolution::Method::state_space;
    options.reduction.tolerance = reservoir.memory_tolerance;
  }
  convolution::MadeConvolution made = reservoir::face_convolution(
      reservoir::face_modes(reservoir::pressure_mesh(wet.face, *reservoir.level), water_of(reservoir)), plan.time_step,
      plan.steps, options);
  medium.convolution = std::move(made.convolution);
  if (options.method != convolution::Method::state_space) return;
  medium.memory_error = made.error.relative;
  if (made.within_tolerance) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "the water's memory errs by up to %.2g of its kernel's sum, more than "
                "reservoir.memory_tolerance = %.2g",
                made.error.relative, reservoir.memory_tolerance);
  medium.warnings.emplace_back(text);
}

std::unique_ptr<convolution::Convolution> mass_of(const scene::Reservoir& reservoir, const WetBoundary& wet) {
  switch (reservoir.model) {
    case scene::ReservoirModel::hydrostatic:
    case scene::ReservoirModel::compressible:
      break;
    case scene::ReservoirModel::westergaard:
      return std::make_unique<convolution::InstantaneousMass>(
          reservoir::westergaard_mass(wet.face, *reservoir.level, reservoir.density));
    case scene::ReservoirModel::incompressible:
      return std::make_unique<convolution::InstantaneousMass>(
          reservoir::incompressible_mass(wet.face, *reservoir.level, reservoir.density));
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<AttachedMedium> attach_reservoir(const scene::Scene& scene, const Body& body, const StepPlan& plan,
                                                 numerics::ThreadPool& pool, Ledger& ledger) {
  if (!scene.reservoir || scene.reservoir->model == scene::ReservoirModel::hydrostatic) return nullptr;
  Ledger::Visit visit(ledger, "reservoir", "reservoir");
  const WetBoundary wet = wet_boundary(scene, body);
  auto medium = std::make_unique<AttachedMedium>();
  medium->name = "reservoir";
  for (const int node : wet.nodes) medium->dofs.push_back(2 * node);
  at_reservoir(scene, [&] {
    if (scene.reservoir->model == scene::ReservoirModel::compressible) {
      convolve_with(*scene.reservoir, wet, plan, pool, *medium);
    } else {
      medium->convolution = mass_of(*scene.reservoir, wet);
    }
  });
  medium->driven_by = DrivenBy::total;
  const bool remembers = scene.reservoir->model == scene::ReservoirModel::compressible;
  medium->worker = remembers ? "convolution" : "reservoir";
  visit.add_entries(static_cast<long long>(wet.nodes.size()) * static_cast<long long>(wet.nodes.size()));
  return medium;
}

Eigen::VectorXd reservoir_pressure_weights(const scene::Scene& scene, const Body& body, double height) {
  const WetBoundary wet = wet_boundary(scene, body);
  const reservoir::PressureMesh mesh =
      at_reservoir(scene, [&] { return reservoir::pressure_mesh(wet.face, *scene.reservoir->level); });
  // R acts on the water in +x; the functional wants forces that push into the water
  return wet.into_water * reservoir::pressure_functional(mesh, height);
}

}  // namespace sunder::simulation
