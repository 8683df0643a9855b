#include "solver/simulation/tips.hpp"

#include "solver/crack/crack_faces.hpp"
#include "solver/simulation/polygon_loads.hpp"

namespace sunder::simulation {
namespace {

Eigen::VectorXd on_boundary(const mesh::NodalPolygon& polygon, const Eigen::VectorXd& displacement) {
  Eigen::VectorXd local(2 * std::ssize(polygon.nodes));
  for (Eigen::Index i = 0; i < std::ssize(polygon.nodes); ++i) {
    local.segment<2>(2 * i) = displacement.segment<2>(2 * polygon.nodes[i]);
  }
  return local;
}

}  // namespace

std::vector<TipResult> tip_results(const scene::Scene& scene, const Body& body, const sbfem::Formation& formation,
                                   const Eigen::VectorXd& displacement) {
  const fracture::Extraction extraction = scene.fracture.value_or(scene::Fracture{}).extraction;
  std::vector<TipResult> results;
  for (std::size_t tip = 0; tip < body.polygons.cracks.size(); ++tip) {
    const int index = body.polygons.cracks[tip].tip_polygon;
    if (index < 0) continue;
    const mesh::NodalPolygon polygon = body.nodes.polygon(index);
    const material::Isotropic& material = body.materials[polygon.material];
    const sbfem::Boundary boundary = sbfem::boundary_of(body.nodes, index);
    const sbfem::Coefficients coefficients = sbfem::coefficients(boundary, material);
    const sbfem::PolygonSolution solution = sbfem::solution_of_stiffness(coefficients, formation.stiffness(index));
    const fracture::CrackTip crack_tip =
        fracture::crack_tip(boundary, coefficients, solution, material, {.extraction = extraction});
    Eigen::Vector3d shares = Eigen::Vector3d::Zero();
    for (const sbfem::RadialLoad& load : polygon_loads(scene, body, index, boundary)) {
      shares += fracture::load_share(crack_tip, coefficients, solution, load);
    }
    results.push_back({.tip = static_cast<int>(tip),
                       .position = polygon.scaling_centre,
                       .state = fracture::tip_state(crack_tip, on_boundary(polygon, displacement), shares),
                       .exponents = crack_tip.exponents,
                       .status = crack_tip.status});
  }
  return results;
}

std::vector<double> mouth_openings(const scene::Scene& scene, const Body& body, const Eigen::VectorXd& displacement) {
  std::vector<double> openings;
  std::size_t tip = 0;
  for (const scene::Crack& scene_crack : scene.cracks) {
    const crack::CrackPairs pairs = crack::crack_pairs(body.polygons, body.nodes, static_cast<int>(tip));
    openings.push_back(crack::crack_motion(pairs, displacement).opening[0]);
    tip += scene_crack.inner ? 2 : 1;
  }
  return openings;
}

}  // namespace sunder::simulation
