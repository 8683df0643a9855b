#include "solver/simulation/standing_water.hpp"

#include <algorithm>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"
#include "solver/simulation/static_loads.hpp"

namespace sunder::simulation {

using Eigen::VectorXd;
using mesh::Point;

VectorXd water_on_edge(const Eigen::Matrix2Xd& nodes, double level, double weight) {
  const Point first = nodes.col(0), last = nodes.col(nodes.cols() - 1);
  const double rise = last.y() - first.y();
  // Fractions of the edge between which it is wet.
  double from = 0.0, to = 1.0;
  if (first.y() >= level && last.y() >= level) return VectorXd::Zero(2 * nodes.cols());
  if (first.y() > level) from = (level - first.y()) / rise;
  if (last.y() > level) to = (level - first.y()) / rise;

  const auto basis = numerics::lagrange_basis(numerics::gauss_lobatto(static_cast<int>(nodes.cols())).points);
  const auto rule = numerics::gauss_legendre(static_cast<int>(nodes.cols()) / 2 + 1);  // degree p + 1 exactly
  const Point inward(-(last - first).y(), (last - first).x());                         // times its length
  VectorXd force = VectorXd::Zero(2 * nodes.cols());
  for (Eigen::Index g = 0; g < rule.points.size(); ++g) {
    const double s = from + 0.5 * (to - from) * (rule.points[g] + 1.0);
    const double pressure = weight * (level - first.y() - s * rise);
    const VectorXd shape = numerics::values(basis, 2.0 * s - 1.0);
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
      force.segment<2>(2 * i) += 0.5 * rule.weights[g] * (to - from) * pressure * shape[i] * inward;
    }
  }
  return force;
}

double weight_of_water(const scene::Scene& scene, double density) {
  return density * scene.gravity.value_or(scene::Gravity{}).acceleration;
}

std::optional<RestingWater> resting_water(const scene::Scene& scene, const Body& body, int tip) {
  if (!scene.crack_water || !scene.reservoir || scene.cracks[crack_of_tip(scene, tip)].inner) return {};
  const mesh::CrackFaces& faces = body.polygons.cracks[tip];
  const std::vector<mesh::Edge>& wet = body.polygons.boundaries.at(scene.reservoir->boundary);
  const auto at_mouth = [&](const mesh::Edge& edge) {
    const auto is = [&](int vertex) { return edge[0] == vertex || edge[1] == vertex; };
    return is(faces.lower.front()) || is(faces.upper.front());
  };
  if (std::none_of(wet.begin(), wet.end(), at_mouth)) return {};
  const double y = body.polygons.vertices[faces.lower.front()].y();
  const double pressure = weight_of_water(scene, scene.reservoir->density) * (*scene.reservoir->level - y);
  if (!(pressure > 0.0)) return {};
  const double sign = numerics::planted_fault("simulation/crack-water-ignores-its-mouth") ? 0.5 : 1.0;
  return RestingWater{sign * pressure, y, weight_of_water(scene, scene.crack_water->density)};
}

}  // namespace sunder::simulation
