#include "solver/simulation/surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::simulation {

using Eigen::Index;
using Eigen::VectorXd;

bool rock_moves(const scene::Scene& scene) {
  return scene.foundation && scene.foundation->density > 0.0;
}

Surroundings::Surroundings(const scene::Scene& scene, const Body& body, const std::filesystem::path& cache,
                           numerics::ThreadPool& pool, Ledger& ledger)
    : shaking_(shaking_of(scene)), time_step_(scene.dynamics->time_step), rock_moves_(simulation::rock_moves(scene)) {
  // a duration that is a whole number of steps but for round-off gets no step more
  steps_ = static_cast<long long>(std::fmax(std::ceil(scene.dynamics->duration / time_step_ - 1e-9), 1.0));
  if (rock_moves_) attach_rock(body, cache, pool, ledger);
  if (scene.reservoir && failure_.empty()) {
    auto water = attach_reservoir(scene, body, {.time_step = time_step_, .steps = steps_ + 1}, pool, ledger);
    if (water != nullptr) media_.push_back(std::move(water));
  }
  for (const auto& medium : media_) visited_.push_back(medium.get());
}

/// The rock outside the near field, and the wave that rises through it.
void Surroundings::attach_rock(const Body& body, const std::filesystem::path& cache, numerics::ThreadPool& pool,
                               Ledger& ledger) {
  // the wave starts no deeper than the body and its near field reach
  const auto heights = body.nodes.coordinates().row(1);
  const double speed = material::shear_wave_speed(body.materials[static_cast<std::size_t>(body.rock)]);
  const auto most_delay =
      static_cast<long long>(std::ceil((heights.maxCoeff() - heights.minCoeff()) / (speed * time_step_))) + 2;
  // rock at depth knows the record ahead of the surface, also at the end of the run
  const auto sampled = [&](int component, bool there) {
    std::vector<double> samples;
    for (long long n = 0; there && n <= steps_ + most_delay; ++n)
      samples.push_back(shaking_.at(time_step_ * static_cast<double>(n))[component]);
    return samples;
  };
  const SurfaceMotion motion{.horizontal = sampled(0, shaking_.horizontal.has_value()),
                             .vertical = sampled(1, shaking_.vertical.has_value()),
                             .step = time_step_};
  AttachedFoundation attached =
      attach_foundation(body, motion, {.time_step = time_step_, .steps = steps_ + most_delay}, cache, pool, ledger);
  failure_ = attached.failure;
  if (!failure_.empty()) return;
  wave_ = std::move(attached.wave);
  steps_ += wave_.delay;
  media_.push_back(std::move(attached.medium));
}

std::vector<std::string> Surroundings::warnings() const {
  std::vector<std::string> all;
  for (const auto& medium : media_) all.insert(all.end(), medium->warnings.begin(), medium->warnings.end());
  return all;
}

double Surroundings::time_at(long long step) const {
  return time_step_ * static_cast<double>(step - wave_.delay);
}

void Surroundings::load_at(long long step, const VectorXd& dead_load, StepLoad& load) const {
  load.force = dead_load;
  if (!rock_moves_) {
    load.ground = shaking_.at(time_at(step));
    return;
  }
  load.force += rock_reaction_;
  load.ground = wave_.surface.col(step);
  for (std::size_t i = 0; i < wave_.dofs.size(); ++i)
    load.force[wave_.dofs[i]] += wave_.load(static_cast<Index>(i), step);
}

bool Surroundings::keep(const std::vector<int>& same, int dofs, std::string& lost) {
  const auto move = [&same](std::vector<int>& list) {
    for (int& dof : list) dof = same[static_cast<std::size_t>(dof)];
    return std::none_of(list.begin(), list.end(), [](int dof) { return dof < 0; });
  };
  for (AttachedMedium* medium : visited_) {
    if (move(medium->dofs)) continue;
    lost = medium->name;
    return false;
  }
  if (!rock_moves_) return true;
  VectorXd reaction = VectorXd::Zero(dofs);
  const std::vector<int> before = wave_.dofs;
  move(wave_.dofs);  // the medium's, which could be moved
  for (std::size_t i = 0; i < before.size(); ++i) reaction[wave_.dofs[i]] = rock_reaction_[before[i]];
  rock_reaction_ = reaction;
  return true;
}

}  // namespace sunder::simulation
