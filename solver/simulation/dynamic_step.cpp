#include "solver/simulation/dynamic_step.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<const AttachedMedium*> constant(std::span<AttachedMedium* const> media) {
  return {media.begin(), media.end()};
}

/// weights · W_0 of each mouth: the pressure there for the accelerations of its medium's dofs; empty where no medium
/// reaches it.
std::vector<Eigen::RowVectorXd> mouth_rows(std::span<AttachedMedium* const> media, std::span<const Mouth> mouths) {
  std::vector<Eigen::RowVectorXd> rows(mouths.size());
  for (std::size_t c = 0; c < mouths.size(); ++c) {
    if (!mouths[c].wet || mouths[c].weights.size() == 0) continue;
    rows[c] = mouths[c].weights.transpose() * media[mouths[c].medium]->convolution->instantaneous_mass();
  }
  return rows;
}

/// What a unit of each force adds to the pressures at the mouths, through X's acceleration of the medium's dofs.
Eigen::MatrixXd mouth_answer(const Eigen::MatrixXd& X, double acceleration_factor,
                             std::span<AttachedMedium* const> media, std::span<const Mouth> mouths,
                             std::span<const Eigen::RowVectorXd> of_acceleration) {
  Eigen::MatrixXd answer = Eigen::MatrixXd::Zero(std::ssize(mouths), X.cols());
  for (std::size_t c = 0; c < mouths.size(); ++c) {
    for (Index i = 0; i < of_acceleration[c].size(); ++i) {
      const int dof = media[mouths[c].medium]->dofs[static_cast<std::size_t>(i)];
      answer.row(static_cast<Index>(c)) += acceleration_factor * of_acceleration[c][i] * X.row(dof);
    }
  }
  return answer;
}

}  // namespace

DynamicStep::DynamicStep(const DynamicBody& body, std::span<AttachedMedium* const> media, std::span<const Mouth> mouths,
                         const CrackWaters& waters, const StepOptions& options,
                         const faces::FaceStepOptions& face_options, const FaceMemory& memory, const MotionState& state)
    : body_(&body),
      media_(media.begin(), media.end()),
      mouths_(mouths),
      equations_(body.stiffness, body.mass, body.supports.constraints, constant(media), options),
      memory_(memory) {
  const Index dofs = body.body.dofs();
  for (VectorXd* values : {&d_, &trial_.displacement, &trial_.velocity, &trial_.acceleration, &start_.force})
    values->setZero(dofs);
  equations_.stand_at(state);
  if (!body.cracked() || equations_.status() != numerics::FactorStatus::factorised) return;
  X_ = equations_.answer(body.loads);
  of_acceleration_ = mouth_rows(media, mouths);
  Eigen::MatrixXd mouth = mouth_answer(X_, equations_.acceleration_factor(), media, mouths, of_acceleration_);
  faces_ = std::make_unique<faces::FaceStep>(face_structure(body, X_, std::move(mouth), waters), face_options);
  faces_->begin_with(memory.opening, memory.contact, memory.stiffness);
  motion_.setZero(body.loads.cols());
  before_motion_ = body.loads.transpose() * state.displacement;
  mouth_pressure_.setZero(std::ssize(mouths));
}

bool DynamicStep::solve(const MotionState& state, const StepLoad& start, const StepLoad& end, MotionState& next) {
  if (faces_ == nullptr) {
    equations_.advance(state, equations_.trial(state, start, end), next);
    return true;
  }
  start_.ground = start.ground;
  start_.force = start.force;
  start_.force.noalias() += body_->loads * memory_.force;
  d_ = equations_.trial(state, start_, end);
  equations_.advance(state, d_, trial_);
  motion_.noalias() = body_->loads.transpose() * trial_.displacement;
  for (std::size_t c = 0; c < mouths_.size(); ++c) {
    const Mouth& mouth = mouths_[c];
    double pressure = mouth.wet ? mouth.resting : 0.0;
    if (mouth.wet && mouth.weights.size() > 0) {
      pressure += mouth.weights.dot(equations_.medium_history(mouth.medium));
      for (Index i = 0; i < of_acceleration_[c].size(); ++i) {
        const int dof = media_[mouth.medium]->dofs[static_cast<std::size_t>(i)];
        pressure += of_acceleration_[c][i] * trial_.acceleration[dof];
      }
    }
    mouth_pressure_[static_cast<Index>(c)] = pressure;
  }
  {
    const numerics::Meter::Lap lap(face_work_);
    (void)faces_->solve(motion_, mouth_pressure_, equations_.options().time_step);
  }
  const faces::FaceStepResult& result = faces_->result();
  d_.noalias() += X_ * result.force;
  equations_.advance(state, d_, next);
  return result.status == faces::FaceStatus::solved;
}

FaceWork DynamicStep::accept(const MotionState& next, const Eigen::Vector2d& ground) {
  equations_.accept(next, ground, media_);
  FaceWork work;
  if (faces_ == nullptr) return work;
  faces_->accept();
  const faces::FaceStepResult& result = faces_->result();
  // trapezoids of force and conjugate motion
  Index pair = 0;
  for (const faces::CrackBlock& crack : faces_->structure().cracks) {
    for (Index i = 0; i < crack.forces; ++i) {
      const bool on_pair = i < crack.pairs;
      const double contact_before = on_pair ? memory_.contact[pair + i] : 0.0,
                   contact = on_pair ? result.contact_force[pair + i] : 0.0;
      const double before = memory_.force[crack.first + i] - contact_before,
                   now = result.force[crack.first + i] - contact;
      const double moved = result.motion[crack.first + i] - before_motion_[crack.first + i];
      work.contact += 0.5 * (contact_before + contact) * moved;
      work.water += 0.5 * (before + now) * moved;
    }
    pair += crack.pairs;
  }
  memory_.force = result.force;
  memory_.opening = result.opening;
  memory_.contact = result.contact_force;
  memory_.stiffness = result.stiffness;
  before_motion_ = result.motion;
  return work;
}

void DynamicStep::go_on(const StepMemory& memory) {
  memory_ = memory.faces;
  before_motion_ = memory.motion;
  faces_->go_on(memory.solve);
}

VectorXd DynamicStep::unbalanced(const MotionState& state, const StepLoad& load) const {
  const dynamics::Rayleigh& damping = equations_.options().damping;
  VectorXd sum =
      body_->mass.selfadjointView<Eigen::Lower>() * (state.acceleration + damping.of_mass * state.velocity).eval();
  sum += body_->stiffness.selfadjointView<Eigen::Lower>() *
         (state.displacement + damping.of_stiffness * state.velocity).eval();
  sum -= load.force;
  sum += equations_.ground_load(load.ground);
  if (faces_ != nullptr) sum -= body_->loads * memory_.force;
  for (std::size_t m = 0; m < media_.size(); ++m) {
    for (std::size_t i = 0; i < media_[m]->dofs.size(); ++i) {
      sum[media_[m]->dofs[i]] += equations_.medium_forces()[m][static_cast<Index>(i)];
    }
  }
  for (Index dof = 0; dof < sum.size(); ++dof) {
    if (body_->supports.constraints.fixed[static_cast<std::size_t>(dof)]) sum[dof] = 0.0;
  }
  return sum;
}

}  // namespace sunder::simulation
