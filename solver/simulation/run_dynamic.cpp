// A body shaken by the ground: rest, then step after step, with growth of its cracks between steps.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "solver/fracture/propagation.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/crack_waters.hpp"
#include "solver/simulation/dynamic_record.hpp"
#include "solver/simulation/dynamic_step.hpp"
#include "solver/simulation/free_vibration.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/shaking.hpp"
#include "solver/simulation/state_transfer.hpp"
#include "solver/simulation/static_start.hpp"

namespace sunder::simulation {
namespace {

using Eigen::VectorXd;

std::string seconds_text(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", time);
  return text;
}

dynamics::TimeScheme scheme_of(const scene::Dynamics& wanted) {
  switch (wanted.integrator) {
    case scene::Integrator::newmark:
      return dynamics::newmark();
    case scene::Integrator::hht_alpha:
      return dynamics::hht_alpha(wanted.spectral_radius.value_or(0.9));
    case scene::Integrator::generalised_alpha:
      return dynamics::generalised_alpha(wanted.spectral_radius.value_or(0.9));
  }
  return dynamics::newmark();
}

/// Rayleigh damping by the frequencies of the body on rigid rock, without water.
dynamics::Rayleigh damping_of(const scene::Scene& scene, const DynamicBody& body, Ledger& ledger) {
  const scene::Dynamics& wanted = *scene.dynamics;
  if (wanted.damping_ratio == 0.0) return {};
  Ledger::Visit visit(ledger, "numerics", "modes");
  VibratingBody vibrating;
  vibrating.stiffness = body.stiffness;
  vibrating.mass = body.mass;
  const FreeVibration modes = free_vibration(vibrating, body.supports.constraints, wanted.damping_modes[1], false);
  ledger.count("factorisations");
  visit.add_entries(modes.factor_entries);
  if (modes.omega.size() < wanted.damping_modes[1]) {
    throw scene::SceneError(scene::place_of(scene, "dynamics") + "damping_modes: mode " +
                            std::to_string(wanted.damping_modes[1]) + " was not found; the body has " +
                            std::to_string(modes.omega.size()));
  }
  const double first = modes.omega[wanted.damping_modes[0] - 1], second = modes.omega[wanted.damping_modes[1] - 1];
  if (wanted.damping_modes[0] == wanted.damping_modes[1])
    return dynamics::stiffness_proportional(wanted.damping_ratio, first);
  return dynamics::rayleigh(wanted.damping_ratio, first, second);
}

/// The node whose motion is reported: on the boundary "crest" the first one, else the highest, of several the leftmost.
int crest_node(const Body& body) {
  std::vector<int> candidates;
  if (body.polygons.boundaries.contains("crest")) candidates = boundary_nodes(body, "crest");
  if (candidates.empty()) {
    for (int i = 0; i < body.nodes.node_count(); ++i) candidates.push_back(i);
  }
  const auto& x = body.nodes.coordinates();
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&x](int a, int b) { return x(1, a) != x(1, b) ? x(1, a) > x(1, b) : x(0, a) < x(0, b); });
}

class Run {
 public:
  Run(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
      Ledger& ledger, results::RunSummary& summary)
      : scene_(scene), options_(options), pool_(pool), ledger_(ledger), summary_(summary), shaking_(shaking_of(scene)) {
    const Ledger::Visit visit(ledger_, "sbfem", "polygons");
    body_ =
        dynamic_body(scene_, body, sbfem::form(body.nodes, body.materials, {.with_mass = true, .pool = &pool_}), pool_);
  }

  void go();

 private:
  void plan();
  bool begin();
  void make_step(const FaceMemory& memory);
  bool step(long long number);
  void record(double time);
  bool grow_cracks();
  bool grow_tip(std::size_t crack, const mesh::Point& to);
  void finish();

  bool keeps_checkpoints() const { return options_.resume || (scene_.output && scene_.output->checkpoint_every > 0); }
  std::filesystem::path checkpoint_file() const { return options_.output / "checkpoint"; }
  std::uint64_t key() const;
  void write_checkpoint() const;
  void resume();

  const scene::Scene& scene_;
  const RunOptions& options_;
  numerics::ThreadPool& pool_;
  Ledger& ledger_;
  results::RunSummary& summary_;
  Shaking shaking_;

  DynamicBody body_;
  std::vector<std::unique_ptr<AttachedMedium>> media_;
  std::vector<AttachedMedium*> visited_media_;
  std::vector<Remembering*> remembered_;  // the convolutions of the media, where checkpoints are kept
  std::vector<Mouth> mouths_;
  CrackWaters waters_;
  StepOptions step_options_;
  faces::FaceStepOptions face_options_;
  std::unique_ptr<DynamicStep> step_;
  MotionState state_, next_;
  StepLoad start_, end_;
  EnergyAccount energy_;
  std::vector<VectorXd> media_before_;
  VectorXd released_;  // what held the new faces together; empty but in the step after a growth event
  std::unique_ptr<DynamicRecord> record_;
  StepRecord now_;
  std::vector<fracture::SpeedAllowance> allowances_;
  std::vector<std::vector<mesh::Point>> paths_;
  results::Quantity::List events_;
  std::string final_event_;
  long long steps_ = 0, done_ = 0;
  int crest_ = 0;
};

/// Everything that the steps to come depend on and that is formed again from the scene.
std::uint64_t Run::key() const {
  const auto add = [](std::uint64_t before, const auto& matrix) {
    return fingerprint({matrix.data(), static_cast<std::size_t>(matrix.size())}, before);
  };
  const auto values = [](const Eigen::SparseMatrix<double>& matrix) {
    return Eigen::Map<const VectorXd>(matrix.valuePtr(), matrix.nonZeros());
  };
  std::uint64_t key = add(fingerprint({}), values(body_.stiffness));
  key = add(add(key, values(body_.mass)), body_.dead_load);
  const auto& [scheme, time_step, damping] = step_options_;
  const double single[] = {static_cast<double>(steps_),
                           time_step,
                           scheme.alpha_m,
                           scheme.alpha_f,
                           scheme.beta,
                           scheme.gamma,
                           damping.of_mass,
                           damping.of_stiffness};
  key = fingerprint(single, key);
  for (long long number = 0; number <= steps_; ++number) {
    key = add(key, shaking_.at(scene_.dynamics->time_step * static_cast<double>(number)));
  }
  for (const AttachedMedium* medium : visited_media_) key = add(key, medium->convolution->instantaneous_mass());
  return key;
}

void Run::write_checkpoint() const {
  Checkpoint checkpoint{.key = key(),
                        .step = done_,
                        .state = state_,
                        .medium_forces = {},
                        .medium_accelerations = {},
                        .rows = {},
                        .energy = energy_.tally()};
  const results::History& history = record_->history();
  for (std::size_t row = 0; row < history.rows(); ++row) {
    for (std::size_t column = 0; column < history.columns().size(); ++column)
      checkpoint.rows.push_back(history.at(row, column));
  }
  for (const VectorXd& force : step_->equations().medium_forces()) {
    checkpoint.medium_forces.emplace_back(force.data(), force.data() + force.size());
  }
  for (const Remembering* medium : remembered_) checkpoint.medium_accelerations.push_back(medium->accelerations());
  simulation::write_checkpoint(checkpoint_file(), checkpoint);
}

void Run::resume() {
  const Checkpoint checkpoint = read_checkpoint(checkpoint_file(), key());
  state_ = checkpoint.state;
  next_ = state_;
  done_ = checkpoint.step;
  start_.ground = shaking_.at(state_.time);
  end_ = start_;
  std::vector<VectorXd> forces;
  for (const std::vector<double>& force : checkpoint.medium_forces) {
    forces.emplace_back(Eigen::Map<const VectorXd>(force.data(), std::ssize(force)));
  }
  step_->equations().begin_with(forces);
  for (std::size_t m = 0; m < remembered_.size(); ++m) remembered_[m]->replay(checkpoint.medium_accelerations[m]);
  energy_.resume(step_->equations(), state_, checkpoint.energy);
  const std::size_t columns = record_->history().columns().size();
  for (std::size_t at = 0; at < checkpoint.rows.size(); at += columns) {
    record_->replay(std::span(checkpoint.rows).subspan(at, columns));
  }
  ledger_.count("steps", done_);
}

void Run::plan() {
  const scene::Dynamics& wanted = *scene_.dynamics;
  // a duration that is a whole number of steps but for round-off gets no step more
  steps_ = static_cast<long long>(std::fmax(std::ceil(wanted.duration / wanted.time_step - 1e-9), 1.0));
  step_options_ = {
      .scheme = scheme_of(wanted), .time_step = wanted.time_step, .damping = damping_of(scene_, body_, ledger_)};
  face_options_ = face_step_options(scene_);
  crest_ = crest_node(body_.body);
  if (scene_.reservoir) {
    auto medium =
        attach_reservoir(scene_, body_.body, {.time_step = wanted.time_step, .steps = steps_ + 1}, pool_, ledger_);
    if (medium != nullptr) {
      for (const std::string& warning : medium->warnings) summary_.warnings.push_back(warning);
      media_.push_back(std::move(medium));
    }
  }
  if (keeps_checkpoints()) {
    const auto refuse = [this](const char* what) {
      throw scene::SceneError(scene::place_of(scene_, scene_.output ? "output" : "dynamics") + what);
    };
    if (body_.cracked()) refuse("checkpoints are kept of dams without cracks only; accepted: checkpoint_every = 0");
    if (options_.output.empty()) refuse("checkpoint_every: this run has no folder to write to; accepted: 0");
    for (const auto& medium : media_) {
      auto remembering =
          std::make_unique<Remembering>(std::move(medium->convolution), static_cast<std::size_t>(steps_ + 1));
      remembered_.push_back(remembering.get());
      medium->convolution = std::move(remembering);
    }
  }
  for (const auto& medium : media_) visited_media_.push_back(medium.get());
  mouths_ =
      mouths_of(scene_, body_.body, std::vector<const AttachedMedium*>(visited_media_.begin(), visited_media_.end()));
  allowances_.resize(body_.cracks.size());
  for (const CrackFaceLoads& crack : body_.cracks)
    paths_.push_back({crack.tip ? crack.tip->position : mesh::Point::Zero()});
}

void Run::make_step(const FaceMemory& memory) {
  Ledger::Visit visit(ledger_, "numerics", "factorisation");
  const std::vector<VectorXd> forces = step_ ? step_->equations().medium_forces() : std::vector<VectorXd>();
  step_ = std::make_unique<DynamicStep>(body_, visited_media_, mouths_, waters_, step_options_, face_options_, memory,
                                        state_);
  if (!forces.empty()) step_->equations().begin_with(forces);
  ledger_.count("factorisations");
  visit.add_entries(step_->status() == numerics::FactorStatus::factorised ? step_->equations().factor_entries() : 0);
}

bool Run::begin() {
  const Ledger::Visit visit(ledger_, "simulation", "rest");
  waters_ = uniform_waters(body_, mouths_);
  const StaticStart rest = static_start(body_, mouths_, waters_, face_options_);
  ledger_.count("factorisations");
  if (rest.status != numerics::FactorStatus::factorised) {
    summary_.status =
        "stopped: the stiffness matrix is not positive definite; a part of the body hangs by round-off only";
    return false;
  }
  if (!rest.faces_found) {
    summary_.status = "stopped: contact and water between the crack faces were not found at rest";
    return false;
  }
  state_.displacement = rest.displacement;
  for (VectorXd* values : {&state_.velocity, &state_.acceleration}) values->setZero(rest.displacement.size());
  next_ = state_;
  if (scene_.crack_water && scene_.crack_water->model == scene::CrackWaterModel::moving) {
    waters_ = moving_waters(scene_, body_, mouths_, rest.faces.opening);
  }
  make_step(rest.faces);
  if (step_->status() != numerics::FactorStatus::factorised) {
    summary_.status = "stopped: the matrix of a time step is not positive definite";
    return false;
  }
  start_ = {.force = body_.dead_load, .ground = shaking_.at(0.0)};
  end_ = start_;
  record_ = std::make_unique<DynamicRecord>(RecordedParts{.cracks = body_.cracks.size(),
                                                          .media = !media_.empty(),
                                                          .contact = scene_.contact.has_value(),
                                                          .water = scene_.crack_water.has_value(),
                                                          .propagation = scene_.propagation.has_value()},
                                            static_cast<std::size_t>(steps_));
  if (options_.resume) {
    resume();
    media_before_ = step_->equations().medium_forces();
    return true;
  }
  step_->equations().begin(state_, start_.ground, visited_media_);
  energy_.begin(step_->equations(), state_);
  media_before_ = step_->equations().medium_forces();
  return true;
}

void Run::record(double time) {
  now_.time = time;
  now_.crest = state_.displacement.segment<2>(2 * crest_);
  now_.hydrodynamic_force = 0.0;
  for (std::size_t m = 0; m < visited_media_.size(); ++m) {
    const VectorXd& force = step_->equations().medium_forces()[m];
    for (std::size_t i = 0; i < visited_media_[m]->dofs.size(); ++i) {
      if (visited_media_[m]->name == "reservoir" && visited_media_[m]->dofs[i] % 2 == 0) {
        now_.hydrodynamic_force -= force[static_cast<Eigen::Index>(i)];
      }
    }
  }
  now_.cracks.resize(body_.cracks.size());
  const FaceMemory& faces = step_->memory();
  for (std::size_t c = 0, pair = 0; c < body_.cracks.size(); ++c) {
    const CrackFaceLoads& crack = body_.cracks[c];
    CrackRecord& entry = now_.cracks[c];
    entry = {};
    const Eigen::Index first = body_.first_load[c], n = crack.pairs.count();
    const auto opening = faces.opening.segment(static_cast<Eigen::Index>(pair), n);
    const auto contact = faces.contact.segment(static_cast<Eigen::Index>(pair), n);
    entry.mouth_opening = opening[0];
    entry.length = crack.pairs.tip_position;
    entry.contact_force = contact.sum();
    entry.penetration = std::fmax(0.0, -opening.minCoeff());
    if (crack.tip) {
      const Eigen::Vector3d factors =
          crack.tip->factors(state_.displacement, faces.force[first + n], faces.force[first + n + 1]);
      entry.K_I = factors[0];
      entry.K_II = factors[1];
    }
    if (waters_[c] != nullptr) {
      entry.mouth_pressure = step_->faces()->result().mouth_pressure[static_cast<Eigen::Index>(c)];
      if (scene_.crack_water->model == scene::CrackWaterModel::moving) {
        const auto& water = static_cast<const MovingWater&>(*waters_[c]);
        entry.uplift_force = water.profile().uplift_force;
        entry.peak_pressure = water.profile().peak_pressure;
        entry.wet_length = water.state().front_position;
        entry.water_content = water.state().content;
      } else {
        entry.peak_pressure = std::fmax(entry.mouth_pressure, 0.0);
        entry.uplift_force = entry.peak_pressure * crack.pairs.tip_position;
        entry.wet_length = entry.peak_pressure > 0.0 ? crack.pairs.tip_position : 0.0;
      }
    }
    pair += static_cast<std::size_t>(n);
  }
  now_.face_iterations = step_->faces() != nullptr ? step_->faces()->result().iterations : 0;
  record_->add(now_, energy_.energies());
}

bool Run::step(long long number) {
  const double time = scene_.dynamics->time_step * static_cast<double>(number);
  end_.ground = shaking_.at(time);
  if (!step_->solve(state_, start_, end_, next_)) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "stopped: contact and water between the crack faces were not found in the step to %s; the residual "
                  "is %.2g times its bound",
                  seconds_text(time).c_str(), step_->faces()->result().residual);
    summary_.status = text;
    return false;
  }
  const FaceWork work = step_->accept(next_, end_.ground);
  energy_.add(step_->equations(), state_, next_, start_, end_, media_before_, work, released_);
  released_.resize(0);
  media_before_ = step_->equations().medium_forces();
  std::swap(state_, next_);
  state_.time = time;
  std::swap(start_, end_);
  if (step_->faces() != nullptr) {
    const faces::FaceStepResult& result = step_->faces()->result();
    ledger_.count("face_iterations", result.iterations);
    ledger_.count("water_solves", result.water_trials);
    ledger_.count("stiffness_enlargements", result.enlargements);
    ledger_.count("continued_steps", result.parts > 1 ? 1 : 0);
  }
  return true;
}

/// Moves every tip that its state of stress drives. False where the run cannot go on.
bool Run::grow_cracks() {
  const scene::Propagation& wanted = *scene_.propagation;
  const fracture::PropagationLaw law{.fracture_toughness = wanted.fracture_toughness,
                                     .increment = wanted.increment,
                                     .per_step = fracture::GrowthPerStep::one_increment,
                                     .max_speed = wanted.max_speed.value_or(std::numeric_limits<double>::infinity())};
  for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
    fracture::refill(allowances_[c], law, scene_.dynamics->time_step);
    const CrackFaceLoads& crack = body_.cracks[c];
    if (!crack.tip || crack.tip->status != fracture::TipStatus::ready) continue;
    Eigen::Index last = -1;
    for (std::size_t k = 0; k <= c; ++k) last += body_.cracks[k].pairs.count();
    const bool held_closed = step_->memory().contact[last] > 0.0;
    const fracture::GrowthDecision decision =
        fracture::decide_growth({.K_I = now_.cracks[c].K_I, .K_II = now_.cracks[c].K_II}, held_closed, law);
    if (decision.verdict != fracture::GrowthVerdict::grows || !fracture::take_increment(allowances_[c], law, 0))
      continue;
    if (!grow_tip(c, fracture::next_tip(crack.tip->position, crack.tip->direction, decision.kink_angle, law.increment)))
      return false;
  }
  return true;
}

bool Run::grow_tip(std::size_t crack, const mesh::Point& to) {
  Ledger::Visit visit(ledger_, "crack", "growth");
  const int parts = part_count(body_.body.nodes);
  Growth growth = grow(body_.body, body_.formation, static_cast<int>(crack), to, &pool_);
  const auto event = [&](const std::string& word, const mesh::Point& place) {
    events_.push_back(results::Quantity::Table{{"time", state_.time},
                                               {"crack", static_cast<int>(crack)},
                                               {"event", word},
                                               {"position", results::Quantity::List{place.x(), place.y()}}});
  };
  if (growth.event == crack::TipEvent::refused) {
    summary_.status =
        "stopped: at " + seconds_text(state_.time) + " the crack could not be cut further: " + growth.reason;
    event("refused", to);
    return false;
  }
  ledger_.count("growths");
  paths_[crack].push_back(growth.tip);
  if (growth.event == crack::TipEvent::reached_boundary) {
    const std::string boundary = boundary_at(growth.body.polygons, growth.tip);
    event("reached boundary" + (boundary.empty() ? "" : " " + boundary), growth.tip);
  } else if (growth.event == crack::TipEvent::reached_crack) {
    event("reached crack", growth.tip);
  }
  if (part_count(growth.body.nodes) > parts) {
    event("cut through", growth.tip);
    final_event_ = "cut through";
    return true;  // a part of the dam floats: an end to report, not to integrate on
  }

  Eigen::MatrixXd fields(body_.body.dofs(), 3);
  fields << state_.displacement, state_.velocity, state_.acceleration;
  const TransferredFields moved =
      transfer_fields(body_.body, body_.formation, growth.body, growth.formation, growth.report, fields);
  const std::vector<int> same = same_boundary_dofs(body_.body, growth.body);
  for (AttachedMedium* medium : visited_media_) {
    for (int& dof : medium->dofs) {
      dof = same[static_cast<std::size_t>(dof)];
      if (dof < 0) {
        summary_.status =
            "stopped: at " + seconds_text(state_.time) + " a crack has changed the face of the " + medium->name;
        return false;
      }
    }
  }
  const DynamicBody before = std::move(body_);
  body_ = dynamic_body(scene_, std::move(growth.body), std::move(growth.formation), pool_);
  state_.displacement = moved.values.col(0);
  state_.velocity = moved.values.col(1);
  state_.acceleration = moved.values.col(2);
  for (Eigen::Index dof = 0; dof < state_.displacement.size(); ++dof) {
    if (!body_.supports.constraints.fixed[static_cast<std::size_t>(dof)]) continue;
    state_.displacement[dof] = body_.supports.constraints.displacement[dof];
    state_.velocity[dof] = state_.acceleration[dof] = 0.0;
  }
  next_ = state_;
  // Forces go over by place; what is lost at the old tip appears in the work of the new faces.
  const FaceMemory& old = step_->memory();
  FaceMemory memory;
  memory.stiffness = old.stiffness;
  memory.force.setZero(body_.loads.cols());
  Eigen::Index pairs = 0, old_pairs = 0;
  for (const CrackFaceLoads& faces : body_.cracks) pairs += faces.pairs.count();
  memory.opening.setZero(pairs);
  memory.contact.setZero(pairs);
  pairs = 0;
  for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
    const crack::CrackPairs &now = body_.cracks[c].pairs, &then = before.cracks[c].pairs;
    const Eigen::VectorXd opening = crack::crack_motion(now, state_.displacement).opening;
    memory.opening.segment(pairs, now.count()) = opening;
    int j = 0;
    for (int i = 0; i < now.count(); ++i) {
      while (j < then.count() && then.position[j] < now.position[i] - 1e-9) ++j;
      if (j == then.count() || then.position[j] > now.position[i] + 1e-9) continue;
      memory.force[body_.first_load[c] + i] = old.force[before.first_load[c] + j];
      memory.contact[pairs + i] = old.contact[old_pairs + j];
    }
    pairs += now.count();
    old_pairs += then.count();
  }
  grow_waters(scene_, body_, memory.opening, waters_);
  make_step(memory);
  if (step_->status() != numerics::FactorStatus::factorised) {
    summary_.status =
        "stopped: at " + seconds_text(state_.time) + " the matrix of a time step is not positive definite";
    return false;
  }
  start_.force = end_.force = body_.dead_load;
  crest_ = crest_node(body_.body);
  energy_.grow(step_->equations(), state_);
  released_ = step_->unbalanced(state_, start_);
  visit.add_entries(step_->equations().factor_entries());
  return true;
}

void Run::finish() {
  record_->write(summary_.quantities);
  summary_.quantities["energy_balance_error"] = energy_.balance_error();
  if (scene_.propagation) {
    results::Quantity::List lengths, paths;
    for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
      lengths.emplace_back(body_.cracks[c].pairs.tip_position);
      results::Quantity::List path;
      for (const mesh::Point& point : paths_[c]) path.emplace_back(results::Quantity::List{point.x(), point.y()});
      paths.emplace_back(std::move(path));
    }
    summary_.quantities["final_crack_length"] = lengths.size() == 1 ? lengths.front() : results::Quantity(lengths);
    summary_.quantities["crack_path"] = paths.size() == 1 ? paths.front() : results::Quantity(paths);
    summary_.quantities["events"] = events_;
  }
  if (!final_event_.empty()) summary_.quantities["end"] = final_event_ + " at " + seconds_text(state_.time);
  summary_.quantities["end_time"] = state_.time;
  summary_.history = record_->take_history();
  summary_.mesh = {
      .polygons = body_.body.nodes.polygon_count(), .nodes = body_.body.nodes.node_count(), .dofs = body_.body.dofs()};
  if (options_.final_body) options_.final_body(body_.body);
}

void Run::go() {
  plan();
  if (!begin()) return;
  if (done_ == 0) record(0.0);
  {
    const Ledger::Visit visit(ledger_, "dynamics", "steps");
    for (long long number = done_ + 1; number <= steps_ && summary_.completed() && final_event_.empty(); ++number) {
      if (options_.stop != nullptr && options_.stop->load()) {
        summary_.status = "stopped: interrupted at " + seconds_text(state_.time);
        if (keeps_checkpoints()) write_checkpoint();
        break;
      }
      if (!step(number)) break;
      done_ = number;
      record(state_.time);
      ledger_.count("steps");
      if (keeps_checkpoints() && scene_.output && scene_.output->checkpoint_every > 0 &&
          number % scene_.output->checkpoint_every == 0) {
        write_checkpoint();
      }
      if (scene_.propagation && !grow_cracks()) break;
      if (options_.progress && number % 16 == 0)
        options_.progress("steps", static_cast<double>(number) / static_cast<double>(steps_));
    }
  }
  if (summary_.completed() && keeps_checkpoints()) std::filesystem::remove(checkpoint_file());
  finish();
}

}  // namespace

void run_dynamic(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                 Ledger& ledger, results::RunSummary& summary) {
  Run run(scene, body, options, pool, ledger, summary);
  run.go();
}

}  // namespace sunder::simulation
