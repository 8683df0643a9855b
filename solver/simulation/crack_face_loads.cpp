#include "solver/simulation/crack_face_loads.hpp"

#include <array>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/loads.hpp"
#include "solver/simulation/polygon_loads.hpp"

namespace sunder::simulation {
namespace {

using Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Unit forces along the normals, apart.
void add_pairs(const crack::CrackPairs& pairs, Triplets& entries) {
  for (int i = 0; i < pairs.count(); ++i) {
    for (int component = 0; component < 2; ++component) {
      const double n = pairs.normals(component, i);
      entries.emplace_back(2 * pairs.upper[i] + component, i, n);
      entries.emplace_back(2 * pairs.lower[i] + component, i, -n);
    }
  }
}

std::vector<int> dofs_of(const mesh::NodalPolygon& polygon) {
  std::vector<int> dofs;
  for (const int node : polygon.nodes) {
    dofs.push_back(2 * node);
    dofs.push_back(2 * node + 1);
  }
  return dofs;
}

VectorXd nodal_load(const sbfem::PolygonSolution& solution, const std::vector<sbfem::RadialLoad>& loads) {
  return sbfem::load_vector(solution, std::span<const sbfem::RadialLoad>(loads));
}

/// What pressure y_a + y_b ξ on the faces inside the tip polygon does to the nodes and to the factors.
TipFactors add_tip(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation, int index, int first,
                   Triplets& entries) {
  const mesh::NodalPolygon polygon = body.nodes.polygon(index);
  const material::Isotropic& material = body.materials[polygon.material];
  const sbfem::Boundary boundary = sbfem::boundary_of(body.nodes, index);
  const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, material);
  const sbfem::PolygonSolution solution = sbfem::solution_of_stiffness(coefficients, formation.stiffness(index));
  const fracture::Extraction extraction = scene.fracture.value_or(scene::Fracture{}).extraction;
  const fracture::CrackTip tip =
      fracture::crack_tip(boundary, coefficients, solution, material, {.extraction = extraction, .exponents = false});

  TipFactors factors{.dofs = dofs_of(polygon),
                     .of_displacement = tip.of_displacement,
                     .position = polygon.scaling_centre,
                     .direction = tip.direction,
                     .status = tip.status};
  const auto shares = [&](const std::vector<sbfem::RadialLoad>& loads) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const sbfem::RadialLoad& load : loads) sum += fracture::load_share(tip, coefficients, solution, load);
    return sum;
  };
  constexpr std::array<std::array<double, 2>, 2> powers = {{{1.0, 0.0}, {0.0, 1.0}}};
  for (int k = 0; k < 2; ++k) {
    const std::vector<sbfem::RadialLoad> loads =
        sbfem::crack_face_pressure(boundary, powers[static_cast<std::size_t>(k)]);
    const VectorXd nodal = nodal_load(solution, loads);
    for (Eigen::Index i = 0; i < nodal.size(); ++i) {
      entries.emplace_back(factors.dofs[static_cast<std::size_t>(i)], first + k, nodal[i]);
    }
    if (!numerics::planted_fault("simulation/tip-pressure-left-out-of-K")) factors.of_pressure.col(k) = shares(loads);
  }
  factors.of_constant_loads = shares(polygon_loads(scene, body, index, boundary));
  return factors;
}

}  // namespace

Eigen::Vector3d TipFactors::factors(const Eigen::Ref<const VectorXd>& displacement, double y_a, double y_b) const {
  Eigen::Vector3d sum = of_constant_loads + of_pressure * Eigen::Vector2d(y_a, y_b);
  for (std::size_t i = 0; i < dofs.size(); ++i)
    sum += displacement[dofs[i]] * of_displacement.col(static_cast<Eigen::Index>(i));
  return sum;
}

VectorXd CrackFaceLoads::uniform_share() const {
  VectorXd share = VectorXd::Zero(count());
  share.head(edge_share.size()) = edge_share;
  if (tip) share[edge_share.size()] = 1.0;
  return share;
}

CrackFaceLoads crack_face_loads(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                                int crack) {
  CrackFaceLoads result;
  result.pairs = crack::crack_pairs(body.polygons, body.nodes, crack);
  const int n = result.pairs.count(), tip_polygon = body.polygons.cracks[static_cast<std::size_t>(crack)].tip_polygon;
  Triplets entries;
  add_pairs(result.pairs, entries);
  result.edge_share = result.pairs.tributary_length;
  if (tip_polygon >= 0) {
    result.edge_share[n - 1] -= 0.5 * (result.pairs.tip_position - result.pairs.position[n - 1]);
    result.tip = add_tip(scene, body, formation, tip_polygon, n, entries);
  }
  result.loads.resize(body.dofs(), n + (result.tip ? 2 : 0));
  result.loads.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace sunder::simulation
