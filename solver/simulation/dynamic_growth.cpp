// Growth of cracks between two steps of a dynamic run.

#include <limits>

#include "solver/numerics/planted_fault.hpp"
#include "solver/simulation/dynamic_run.hpp"
#include "solver/simulation/state_transfer.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;

constexpr double same_place = 1e-9;  // m, along a crack

fracture::PropagationLaw law_of(const scene::Propagation& wanted) {
  return {.fracture_toughness = wanted.fracture_toughness,
          .increment = wanted.increment,
          .per_step = wanted.per_step,
          .max_speed = wanted.max_speed.value_or(std::numeric_limits<double>::infinity())};
}

}  // namespace

void DynamicRun::note_event(std::size_t crack, const std::string& what, const mesh::Point& place) {
  events_.emplace_back(results::Quantity::Table{{"time", state_.time},
                                                {"crack", static_cast<int>(crack)},
                                                {"event", what},
                                                {"position", results::Quantity::List{place.x(), place.y()}}});
}

bool DynamicRun::held_closed(std::size_t crack) const {
  Index last = -1;
  for (std::size_t c = 0; c <= crack; ++c) last += body_.cracks[c].pairs.count();
  return step_->memory().contact[last] > 0.0;
}

/// Moves every tip that its state of stress drives. With growth until arrest the factors after an increment are those
/// of the same displacements around the new tip.
bool DynamicRun::grow_cracks() {
  const fracture::PropagationLaw law = law_of(*scene_.propagation);
  for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
    fracture::refill(allowances_[c], law, step_options_.time_step);
    for (int taken = 0;; ++taken) {
      const CrackFaceLoads& crack = body_.cracks[c];
      if (!crack.tip || crack.tip->status != fracture::TipStatus::ready) break;
      if (taken > 0) observe(now_);
      const fracture::Faces faces = held_closed(c) ? fracture::Faces::held_closed : fracture::Faces::as_K_I_says;
      const fracture::GrowthDecision decision =
          fracture::decide_growth({.K_I = now_.cracks[c].K_I, .K_II = now_.cracks[c].K_II}, faces, law);
      if (decision.verdict != fracture::GrowthVerdict::grows || !fracture::take_increment(allowances_[c], law, taken))
        break;
      const mesh::Point to =
          fracture::next_tip(crack.tip->position, crack.tip->direction, decision.kink_angle, law.increment);
      if (!grow_tip(c, to)) return false;
      if (!end_event_.empty()) return true;
    }
  }
  return true;
}

/// What the faces take along into the grown body: forces go over by place; what is lost at the old tip appears in the
/// work of the new faces.
FaceMemory DynamicRun::remembered(const DynamicBody& before) const {
  const FaceMemory& old = step_->memory();
  FaceMemory memory;
  Index pairs = 0, old_pairs = 0;
  for (const CrackFaceLoads& crack : body_.cracks) pairs += crack.pairs.count();
  memory.stiffness = old.stiffness;
  memory.force.setZero(body_.loads.cols());
  memory.opening.setZero(pairs);
  memory.contact.setZero(pairs);
  pairs = 0;
  for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
    const crack::CrackPairs &now = body_.cracks[c].pairs, &then = before.cracks[c].pairs;
    memory.opening.segment(pairs, now.count()) = crack::crack_motion(now, state_.displacement).opening;
    for (int i = 0, j = 0; i < now.count(); ++i) {
      while (j < then.count() && then.position[j] < now.position[i] - same_place) ++j;
      if (j == then.count() || then.position[j] > now.position[i] + same_place) continue;
      memory.force[body_.first_load[c] + i] = old.force[before.first_load[c] + j];
      memory.contact[pairs + i] = old.contact[old_pairs + j];
    }
    pairs += now.count();
    old_pairs += then.count();
  }
  return memory;
}

/// Goes on with the grown body; `before` is what it was.
bool DynamicRun::take_body(Growth growth, DynamicBody& before) {
  std::string lost;
  if (!around_->keep(same_boundary_dofs(body_.body, growth.body), growth.body.dofs(), lost)) {
    return stop("at " + time_text() + " a crack has changed the face of the " + lost), false;
  }
  before = std::move(body_);
  body_ = dynamic_body(scene_, std::move(growth.body), std::move(growth.formation), rock_moves(scene_), pool_,
                       EarlierLoads{before.interior, growth.same});
  crest_ = crest_node(body_.body);
  drawn_.reset();
  return true;
}

bool DynamicRun::grow_tip(std::size_t crack, const mesh::Point& to) {
  Ledger::Visit visit(ledger_, "crack", "growth");
  const int parts = part_count(body_.body.nodes);
  Growth growth = grow(body_.body, body_.formation, static_cast<int>(crack), to, &pool_);
  if (growth.event == crack::TipEvent::refused) {
    note_event(crack, "refused", to);
    return stop("at " + time_text() + " the crack could not be cut further: " + growth.reason), false;
  }
  ledger_.count("growths");
  if (has_checkpoints()) grown_.push_back({.crack = static_cast<int>(crack), .x = to.x(), .y = to.y()});
  paths_[crack].push_back(growth.tip);
  if (growth.event == crack::TipEvent::reached_boundary) {
    const std::string boundary = boundary_at(growth.body.polygons, growth.tip);
    note_event(crack, "reached " + (boundary.empty() ? std::string("a face") : boundary), growth.tip);
  }
  if (growth.event == crack::TipEvent::reached_crack) note_event(crack, "reached a crack", growth.tip);
  if (part_count(growth.body.nodes) > parts) {
    note_event(crack, "cut through", growth.tip);
    end_event_ = "cut through";  // a part of the body floats: an end to report, not to integrate on
    return true;
  }

  Eigen::MatrixXd fields(body_.body.dofs(), 3);
  fields << state_.displacement, state_.velocity, state_.acceleration;
  const TransferredFields moved =
      transfer_fields(body_.body, body_.formation, growth.body, growth.same, growth.report, fields);
  DynamicBody before;
  if (!take_body(std::move(growth), before)) return false;
  state_.displacement = moved.values.col(0);
  state_.velocity = moved.values.col(1);
  state_.acceleration = moved.values.col(2);
  const Constraints& held = body_.supports.constraints;
  for (Index dof = 0; dof < state_.displacement.size(); ++dof) {
    if (!held.fixed[static_cast<std::size_t>(dof)]) continue;
    state_.displacement[dof] = held.displacement[dof];
    state_.velocity[dof] = state_.acceleration[dof] = 0.0;
  }
  next_ = state_;
  const FaceMemory memory = remembered(before);
  grow_waters(scene_, body_, memory.opening, waters_);
  make_step(memory);
  if (step_->status() != numerics::FactorStatus::factorised) {
    return stop("at " + time_text() + " the matrix of a time step is not positive definite"), false;
  }
  around_->load_at(number_, body_.dead_load, start_);
  end_ = start_;
  energy_.grow(step_->equations(), state_);
  if (!numerics::planted_fault("simulation/release-not-accounted")) released_ = step_->unbalanced(state_, start_);
  visit.add_entries(step_->equations().factor_entries());
  return true;
}

}  // namespace sunder::simulation
