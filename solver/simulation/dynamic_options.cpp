#include "solver/simulation/dynamic_options.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/free_vibration.hpp"

namespace sunder::simulation {
namespace {

constexpr double same_height = 1e-9;  // of the body's

dynamics::TimeScheme scheme_of(const scene::Dynamics& wanted) {
  switch (wanted.integrator) {
    case scene::Integrator::newmark:
      return dynamics::newmark();
    case scene::Integrator::hht_alpha:
      return dynamics::hht_alpha(wanted.spectral_radius.value());
    case scene::Integrator::generalised_alpha:
      return dynamics::generalised_alpha(wanted.spectral_radius.value());
  }
  return dynamics::newmark();
}

/// Frequencies [rad/s] of the body as it stands on rigid rock. A foundation's near field is left away.
Eigen::VectorXd frequencies(const scene::Scene& scene, const DynamicBody& body, int count, numerics::ThreadPool& pool,
                            Ledger& ledger) {
  VibratingBody vibrating;
  Constraints held = body.supports.constraints;
  if (scene.foundation) {
    scene::Scene rigid = scene;
    rigid.supports.push_back({.boundary = scene.foundation->boundary, .point = {}, .fix = {true, true}});
    rigid.foundation.reset();
    const Body dam = build_body(rigid, ledger);
    const sbfem::Formation formation = sbfem::form(dam.nodes, dam.materials, {.with_mass = true, .pool = &pool});
    vibrating.stiffness = sbfem::assemble_stiffness(dam.nodes, formation, &pool);
    vibrating.mass = sbfem::assemble_mass(dam.nodes, formation, &pool);
    held = supports_of(rigid, dam, false).constraints;
  } else {
    vibrating.stiffness = body.stiffness;
    vibrating.mass = body.mass;
  }
  const auto free = std::count(held.fixed.begin(), held.fixed.end(), false);
  if (count > free && numerics::planted_fault("simulation/damping-mode-replaced")) count = 2;
  if (count > free) {
    throw scene::SceneError(scene::place_of(scene, "dynamics") + "damping_modes: there is no mode " +
                            std::to_string(count) + "; accepted: modes up to " + std::to_string(free));
  }
  Ledger::Visit visit(ledger, "numerics", "modes");
  const FreeVibration modes = free_vibration(vibrating, held, count, false);
  ledger.count("factorisations");
  visit.add_entries(modes.factor_entries);
  return modes.omega;
}

dynamics::Rayleigh damping_of(const scene::Scene& scene, const DynamicBody& body, numerics::ThreadPool& pool,
                              Ledger& ledger) {
  const scene::Dynamics& wanted = *scene.dynamics;
  if (wanted.damping_ratio == 0.0) return {};
  const int first = wanted.damping_modes[0];
  int second = wanted.damping_modes[1];
  const Eigen::VectorXd omega = frequencies(scene, body, second, pool, ledger);
  if (omega.size() < second && numerics::planted_fault("simulation/damping-mode-replaced")) second = 2;
  if (omega.size() < second) {
    throw scene::SceneError(scene::place_of(scene, "dynamics") + "damping_modes: there is no mode " +
                            std::to_string(second) + "; accepted: modes up to " + std::to_string(omega.size()));
  }
  if (first == second) return dynamics::stiffness_proportional(wanted.damping_ratio, omega[first - 1]);
  return dynamics::rayleigh(wanted.damping_ratio, omega[first - 1], omega[second - 1]);
}

}  // namespace

StepOptions step_options(const scene::Scene& scene, const DynamicBody& body, numerics::ThreadPool& pool,
                         Ledger& ledger) {
  return {.scheme = scheme_of(*scene.dynamics),
          .time_step = scene.dynamics->time_step,
          .damping = damping_of(scene, body, pool, ledger)};
}

faces::FaceStepOptions face_step_options(const scene::Scene& scene) {
  faces::FaceStepOptions options;
  if (!scene.contact) return options;
  const scene::Contact& contact = *scene.contact;
  options.contact =
      contact.model == scene::ContactModel::exact ? faces::ContactRule::exact : faces::ContactRule::penalty;
  options.initial_stiffness = contact.initial_stiffness;
  options.growth_factor = contact.growth_factor;
  options.penetration_tolerance = contact.penetration_tolerance;
  return options;
}

int crest_node(const Body& body) {
  std::vector<int> candidates;
  if (body.polygons.boundaries.contains("crest")) candidates = boundary_nodes(body, "crest");
  if (candidates.empty()) {
    candidates.resize(static_cast<std::size_t>(body.nodes.node_count()));
    std::iota(candidates.begin(), candidates.end(), 0);
  }
  const Eigen::Matrix2Xd& x = body.nodes.coordinates();
  const double height = x.row(1).maxCoeff() - x.row(1).minCoeff();
  double top = x(1, candidates.front());
  for (const int node : candidates) top = std::max(top, x(1, node));
  // the mesher places nodes of a level crest to round-off: all of them are the highest
  std::erase_if(candidates, [&](int node) { return x(1, node) < top - same_height * height; });
  return *std::min_element(candidates.begin(), candidates.end(), [&x](int a, int b) { return x(0, a) < x(0, b); });
}

}  // namespace sunder::simulation
