// A dynamic run that is kept on disk between steps, and goes on from there.

#include "solver/scene/scene_error.hpp"
#include "solver/simulation/dynamic_run.hpp"

namespace sunder::simulation {

using Eigen::Index;
using Eigen::VectorXd;

bool DynamicRun::has_checkpoints() const {
  return scene_.output && scene_.output->checkpoint_every > 0;
}

bool DynamicRun::wants_checkpoint(long long number) const {
  return has_checkpoints() && number % scene_.output->checkpoint_every == 0;
}

/// Ground and rising wave of all steps, and how many there are.
std::string DynamicRun::identity() const {
  const long long steps = around_->steps();
  Eigen::MatrixXd samples(3, steps + 1);
  StepLoad load;
  for (long long n = 0; n <= steps; ++n) {
    around_->load_at(n, body_.dead_load, load);
    samples(0, n) = load.ground.x();
    samples(1, n) = load.ground.y();
    samples(2, n) = load.force.sum();
  }
  return run_identity(step_->equations(), body_.dead_load, samples, laws());
}

/// What decides between the faces and at the tips.
VectorXd DynamicRun::laws() const {
  std::vector<double> values{static_cast<double>(face_options_.contact), face_options_.initial_stiffness,
                             face_options_.growth_factor, face_options_.penetration_tolerance};
  if (scene_.crack_water) {
    const scene::CrackWater& water = *scene_.crack_water;
    for (const double value : {static_cast<double>(water.model), water.minimum_aperture,
                               static_cast<double>(water.aperture), water.relative_roughness, water.density,
                               water.dynamic_viscosity, scene_.gravity ? scene_.gravity->acceleration : 0.0})
      values.push_back(value);
  }
  for (const Mouth& mouth : mouths_) {
    values.push_back(mouth.wet ? mouth.resting : -1.0);
    values.insert(values.end(), mouth.weights.begin(), mouth.weights.end());
  }
  if (scene_.propagation) {
    const scene::Propagation& growth = *scene_.propagation;
    for (const double value : {growth.fracture_toughness, growth.increment, static_cast<double>(growth.per_step),
                               growth.max_speed.value_or(0.0)})
      values.push_back(value);
  }
  for (const AttachedMedium* medium : around_->media()) values.push_back(medium->memory_error.value_or(0.0));
  for (const double time : scene_.output->profile_times) values.push_back(time);
  return VectorXd::Map(values.data(), std::ssize(values));
}

CrackMemory DynamicRun::crack_memory() const {
  CrackMemory memory{.growths = grown_,
                     .step = step_->step_memory(),
                     .waters = {},
                     .released = released_,
                     .allowances = {},
                     .events = events_,
                     .profiles = profiles_,
                     .face_residual = record_->largest_face_residual()};
  for (const fracture::SpeedAllowance& allowance : allowances_) memory.allowances.push_back(allowance.length);
  if (scene_.crack_water && scene_.crack_water->model == scene::CrackWaterModel::moving) {
    for (const auto& water : waters_) {
      if (water != nullptr) memory.waters.push_back(static_cast<const MovingWater&>(*water).memory());
    }
  }
  return memory;
}

/// What the media felt at the end of the last step, as StepEquations::accept has told them.
void DynamicRun::note_felt() {
  if (!has_checkpoints()) return;
  for (const AttachedMedium* medium : around_->media()) {
    for (const int dof : medium->dofs) {
      const double ground = medium->driven_by == DrivenBy::total ? start_.ground[dof % 2] : 0.0;
      felt_.push_back(state_.acceleration[dof] + ground);
    }
  }
}

void DynamicRun::keep() {
  Checkpoint checkpoint{.number = number_,
                        .state = state_,
                        .medium_forces = step_->equations().medium_forces(),
                        .felt = felt_,
                        .energy = energy_.memory(),
                        .history = {},
                        .cracked = body_.cracked(),
                        .cracks = body_.cracked() ? crack_memory() : CrackMemory()};
  const results::History& history = record_->history();
  for (std::size_t row = 0; row < history.rows(); ++row) {
    for (std::size_t column = 0; column < history.columns().size(); ++column)
      checkpoint.history.push_back(history.at(row, column));
  }
  write_checkpoint(options_.output, identity_, checkpoint);
}

void DynamicRun::refuse_checkpoint(const std::string& fault) const {
  throw scene::SceneError(scene::place_of(scene_, "output") + "checkpoint " +
                          checkpoint_file(options_.output).string() + " " + fault);
}

/// The body grows as it has grown, and its faces take up what was between them.
void DynamicRun::go_on_with_cracks(const CrackMemory& kept) {
  for (const GrownTip& tip : kept.growths) {
    Growth growth = grow(body_.body, body_.formation, tip.crack, {tip.x, tip.y}, &pool_);
    DynamicBody before;
    if (growth.event == crack::TipEvent::refused) refuse_checkpoint("does not grow again: " + growth.reason);
    paths_[static_cast<std::size_t>(tip.crack)].push_back(growth.tip);
    if (!take_body(std::move(growth), before)) refuse_checkpoint("does not grow again: " + summary_.status);
  }
  if (state_.displacement.size() != body_.body.dofs()) refuse_checkpoint("is of another body than its growth gives");
  grown_ = kept.growths;
  released_ = kept.released;
  for (std::size_t c = 0; c < allowances_.size(); ++c) allowances_[c].length = kept.allowances[c];
  events_ = *kept.events.list();
  profiles_ = *kept.profiles.list();
  if (scene_.crack_water && scene_.crack_water->model == scene::CrackWaterModel::moving) {
    waters_ = moving_waters(scene_, body_, mouths_, kept.step.faces.opening);
    auto memory = kept.waters.begin();
    for (const auto& water : waters_) {
      if (water != nullptr) static_cast<MovingWater&>(*water).go_on(*memory++);
    }
  } else {
    waters_ = uniform_waters(body_, mouths_);
  }
  make_step(kept.step.faces);
  step_->go_on(kept.step);
}

/// Takes up the run where its checkpoint has left it; it has begun, at rest.
void DynamicRun::go_on() {
  const FoundCheckpoint found = read_checkpoint(options_.output, identity_);
  if (!found.fault.empty()) refuse_checkpoint(found.fault);
  const Checkpoint& kept = found.checkpoint;

  felt_ = kept.felt;
  const double* at = felt_.data();
  for (long long number = 1; number <= kept.number; ++number) {
    for (AttachedMedium* medium : around_->media()) {
      VectorXd values(std::ssize(medium->dofs));
      medium->convolution->history_force(values);  // as a step asks for it
      values = VectorXd::Map(at, values.size());
      medium->convolution->append(values);
      at += values.size();
    }
  }
  number_ = kept.number;
  state_ = kept.state;
  state_.time = around_->time_at(number_);
  next_ = state_;
  if (kept.cracked) go_on_with_cracks(kept.cracks);
  step_->equations().begin_with(kept.medium_forces);
  step_->equations().stand_at(state_);
  media_before_ = kept.medium_forces;
  around_->load_at(number_, body_.dead_load, start_);
  end_ = start_;
  energy_.go_on(step_->equations(), state_, kept.energy);
  record_->read_rows(kept.history, kept.cracks.face_residual);
}

}  // namespace sunder::simulation
