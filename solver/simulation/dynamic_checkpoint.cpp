// A dynamic run that is kept on disk between steps, and goes on from there.

#include "solver/scene/scene_error.hpp"
#include "solver/simulation/checkpoint.hpp"
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
  return run_identity(step_->equations(), body_.dead_load, samples);
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
  if (identity_.empty()) identity_ = identity();
  Checkpoint checkpoint{.number = number_,
                        .state = state_,
                        .medium_forces = step_->equations().medium_forces(),
                        .felt = felt_,
                        .energy = energy_.memory(),
                        .history = {}};
  const results::History& history = record_->history();
  for (std::size_t row = 0; row < history.rows(); ++row) {
    for (std::size_t column = 0; column < history.columns().size(); ++column)
      checkpoint.history.push_back(history.at(row, column));
  }
  write_checkpoint(options_.output, identity_, checkpoint);
}

/// Takes up the run where its checkpoint has left it; it has begun, at rest.
void DynamicRun::go_on() {
  identity_ = identity();
  const FoundCheckpoint found = read_checkpoint(options_.output, identity_);
  if (!found.fault.empty()) {
    throw scene::SceneError(scene::place_of(scene_, "output") + "checkpoint " +
                            checkpoint_file(options_.output).string() + " " + found.fault);
  }
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
  step_->equations().begin_with(kept.medium_forces);
  step_->equations().stand_at(state_);
  media_before_ = kept.medium_forces;
  around_->load_at(number_, body_.dead_load, start_);
  energy_.go_on(step_->equations(), state_, kept.energy);
  record_->read_rows(kept.history);
}

}  // namespace sunder::simulation
