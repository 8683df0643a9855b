#include "solver/simulation/polygon_loads.hpp"

#include <algorithm>

#include "solver/sbfem/particular.hpp"
#include "solver/simulation/static_loads.hpp"

namespace sunder::simulation {
namespace {

/// ½ a(w, w) of w = Σ (ξ^s - ξ^A) d, which vanishes on the boundary: ½ ∫ w · Σ p ξ^k, term by term.
double resting_energy(const std::vector<sbfem::RadialLoad>& loads,
                      const std::vector<sbfem::ParticularSolution>& particular,
                      const std::vector<Eigen::VectorXd>& nodal) {
  double energy = 0.0;
  for (const sbfem::ParticularSolution& field : particular) {
    for (std::size_t l = 0; l < loads.size(); ++l) {
      energy += 0.5 * (field.d.dot(loads[l].density) / (field.power + loads[l].power + 2) - field.d.dot(nodal[l]));
    }
  }
  return energy;
}

PolygonShare share_of(const std::vector<sbfem::RadialLoad>& loads, const sbfem::Boundary& boundary,
                      const material::Isotropic& material, const sbfem::Formation::ConstMap& stiffness,
                      LoadDetail detail) {
  const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, material);
  const sbfem::PolygonSolution solution = sbfem::solution_of_stiffness(coefficients, stiffness);
  PolygonShare share;
  std::vector<Eigen::VectorXd> nodal;
  for (const sbfem::RadialLoad& load : loads) nodal.push_back(sbfem::load_vector(solution, load));
  share.force = nodal.front();
  for (std::size_t l = 1; l < nodal.size(); ++l) share.force += nodal[l];
  if (detail == LoadDetail::forces) return share;
  const std::vector<sbfem::ParticularSolution> particular = sbfem::particular_solutions(coefficients, solution, loads);
  share.energy = resting_energy(loads, particular, nodal);
  for (const sbfem::ParticularSolution& field : particular) share.residual = std::max(share.residual, field.residual);
  return share;
}

}  // namespace

std::vector<sbfem::RadialLoad> polygon_loads(const scene::Scene& scene, const Body& body, int index,
                                             const sbfem::Boundary& boundary) {
  std::vector<sbfem::RadialLoad> loads;
  const mesh::NodalPolygon polygon = body.nodes.polygon(index);
  if (scene.gravity && polygon.material != body.rock) {  // the rock has settled long before the dam was built
    const double weight = body.materials[polygon.material].density * scene.gravity->acceleration;
    loads.push_back(sbfem::body_force(boundary, Eigen::Vector2d(0.0, -weight)));
  }
  if (polygon.open) {
    const auto& cracks = body.polygons.cracks;
    const auto faces = std::find_if(cracks.begin(), cracks.end(),
                                    [&](const mesh::CrackFaces& crack) { return crack.tip_polygon == index; });
    const std::vector<sbfem::RadialLoad> pressure =
        tip_pressure(scene, body, static_cast<int>(faces - cracks.begin()), boundary);
    loads.insert(loads.end(), pressure.begin(), pressure.end());
  }
  return loads;
}

InteriorLoads interior_loads(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                             numerics::ThreadPool& pool, const std::optional<EarlierLoads>& earlier,
                             LoadDetail detail) {
  InteriorLoads sum{.force = Eigen::VectorXd::Zero(body.dofs()),
                    .shares = std::vector<PolygonShare>(static_cast<std::size_t>(body.nodes.polygon_count()))};
  std::vector<int> loaded;
  for (int i = 0; i < body.nodes.polygon_count(); ++i) {
    const mesh::NodalPolygon polygon = body.nodes.polygon(i);
    if (!(scene.gravity && polygon.material != body.rock) && !polygon.open) continue;
    const int from = earlier ? earlier->same[static_cast<std::size_t>(i)] : -1;
    if (from >= 0) {
      sum.shares[static_cast<std::size_t>(i)] = earlier->loads.shares[static_cast<std::size_t>(from)];
    } else {
      loaded.push_back(i);
    }
  }
  pool.parallel_for(static_cast<int>(loaded.size()), [&](int i) {
    const int index = loaded[static_cast<std::size_t>(i)];
    const sbfem::Boundary boundary = sbfem::boundary_of(body.nodes, index);
    const std::vector<sbfem::RadialLoad> loads = polygon_loads(scene, body, index, boundary);
    if (loads.empty()) return;
    sum.shares[static_cast<std::size_t>(index)] = share_of(
        loads, boundary, body.materials[body.nodes.polygon(index).material], formation.stiffness(index), detail);
  });
  // In the order of the polygons: the same bits for any thread count.
  for (int i = 0; i < body.nodes.polygon_count(); ++i) {
    const PolygonShare& share = sum.shares[static_cast<std::size_t>(i)];
    if (share.force.size() == 0) continue;
    const mesh::NodalPolygon polygon = body.nodes.polygon(i);
    for (Eigen::Index k = 0; k < std::ssize(polygon.nodes); ++k) {
      sum.force.segment<2>(2 * polygon.nodes[k]) += share.force.segment<2>(2 * k);
    }
    sum.energy += share.energy;
    sum.worst_residual = std::max(sum.worst_residual, share.residual);
    ++sum.polygons;
  }
  return sum;
}

}  // namespace sunder::simulation
