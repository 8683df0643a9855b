// A body shaken by the ground: rest, then step after step. Growth of its cracks between steps: dynamic_growth.cpp.

#include <cmath>
#include <cstdio>

#include "solver/simulation/analyses.hpp"
#include "solver/simulation/dynamic_run.hpp"
#include "solver/simulation/static_start.hpp"

namespace sunder::simulation {

using Eigen::Index;
using Eigen::VectorXd;

DynamicRun::DynamicRun(const scene::Scene& scene, const Body& body, const RunOptions& options,
                       numerics::ThreadPool& pool, Ledger& ledger, results::RunSummary& summary)
    : scene_(scene), options_(options), pool_(pool), ledger_(ledger), summary_(summary) {
  Ledger::Visit visit(ledger_, "sbfem", "polygons");
  body_ = dynamic_body(scene_, body, sbfem::form(body.nodes, body.materials, {.with_mass = true, .pool = &pool_}),
                       rock_moves(scene_), pool_);
  visit.add_entries(body_.stiffness.nonZeros() + body_.mass.nonZeros());
}

std::string DynamicRun::time_text() const {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", state_.time);
  return text;
}

void DynamicRun::make_step(const FaceMemory& memory) {
  Ledger::Visit visit(ledger_, "numerics", "factorisation");
  charge_faces();
  const std::vector<VectorXd> forces = step_ ? step_->equations().medium_forces() : std::vector<VectorXd>();
  step_ = std::make_unique<DynamicStep>(body_, around_->media(), mouths_, waters_, step_options_, face_options_, memory,
                                        state_);
  if (!forces.empty()) step_->equations().begin_with(forces);
  ledger_.count("factorisations");
  if (step_->status() == numerics::FactorStatus::factorised) visit.add_entries(step_->equations().factor_entries());
}

/// Moves what the faces cost since their equations were made to the part that asked for them.
void DynamicRun::charge_faces() {
  if (step_) ledger_.move("dynamics", face_part(), step_->face_work());
}

/// Moves what each step cost outside the body to the parts that did it.
void DynamicRun::charge_parts() {
  charge_faces();
  for (const auto& water : waters_) {
    if (const auto* moving = dynamic_cast<const MovingWater*>(water.get())) {
      ledger_.move(face_part(), "crackwater", moving->work());
    }
  }
  for (const AttachedMedium* medium : around_->constant_media()) {
    ledger_.move("dynamics", medium->worker, medium->work);
  }
}

bool DynamicRun::begin() {
  step_options_ = step_options(scene_, body_, pool_, ledger_);
  face_options_ = face_step_options(scene_);
  crest_ = crest_node(body_.body);
  around_ = std::make_unique<Surroundings>(scene_, body_.body, options_.cache, pool_, ledger_);
  for (const std::string& warning : around_->warnings()) summary_.warnings.push_back(warning);
  if (!around_->failure().empty()) return stop("the response of the rock was not found: " + around_->failure()), false;
  mouths_ = mouths_of(scene_, body_.body, around_->constant_media());
  allowances_.resize(body_.cracks.size());
  for (const CrackFaceLoads& crack : body_.cracks)
    paths_.push_back({crack.tip ? crack.tip->position : mesh::Point::Zero()});

  const Ledger::Visit visit(ledger_, "simulation", "rest");
  waters_ = uniform_waters(body_, mouths_);
  const Constraints held = supports_of(scene_, body_.body, false).constraints;
  const StaticStart rest = static_start(body_, held, mouths_, waters_, face_options_);
  ledger_.count("factorisations");
  if (rest.status != numerics::FactorStatus::factorised) {
    return stop("the stiffness matrix is not positive definite; a part of the body hangs by round-off only"), false;
  }
  if (!rest.faces_found) return stop("contact and water between the crack faces were not found at rest"), false;
  state_.displacement = rest.displacement;
  for (VectorXd* values : {&state_.velocity, &state_.acceleration}) values->setZero(rest.displacement.size());
  state_.time = around_->time_at(0);
  if (rock_moves(scene_)) around_->hold_rock(rest.reaction);
  if (scene_.crack_water && scene_.crack_water->model == scene::CrackWaterModel::moving) {
    waters_ = moving_waters(scene_, body_, mouths_, rest.faces.opening);
  }
  make_step(rest.faces);
  if (step_->status() != numerics::FactorStatus::factorised)
    return stop("the matrix of a time step is not positive definite"), false;
  around_->load_at(0, body_.dead_load, start_);
  end_ = start_;
  step_->equations().begin(state_, start_.ground, around_->media());
  next_ = state_;
  energy_.begin(step_->equations(), state_);
  media_before_ = step_->equations().medium_forces();
  return true;
}

CrackRecord DynamicRun::observe_crack(std::size_t crack, Index first_pair) const {
  const CrackFaceLoads& faces = body_.cracks[crack];
  const FaceMemory& memory = step_->memory();
  const Index first = body_.first_load[crack], n = faces.pairs.count();
  const auto opening = memory.opening.segment(first_pair, n);
  CrackRecord record{.mouth_opening = opening[0],
                     .length = faces.pairs.tip_position,
                     .contact_force = memory.contact.segment(first_pair, n).sum(),
                     .penetration = std::fmax(0.0, -opening.minCoeff())};
  if (faces.tip) {
    const Eigen::Vector3d factors =
        faces.tip->factors(state_.displacement, memory.force[first + n], memory.force[first + n + 1]);
    record.K_I = factors[0];
    record.K_II = factors[1];
  }
  if (waters_[crack] == nullptr || number_ == 0) return record;
  record.mouth_pressure = step_->faces()->result().mouth_pressure[static_cast<Index>(crack)];
  if (scene_.crack_water->model == scene::CrackWaterModel::moving) {
    const auto& water = static_cast<const MovingWater&>(*waters_[crack]);
    record.uplift_force = water.profile().uplift_force;
    record.peak_pressure = water.profile().peak_pressure;
    record.wet_length = water.state().front_position;
    record.water_content = water.state().content;
  } else {
    record.peak_pressure = std::fmax(record.mouth_pressure, 0.0);
    record.uplift_force = record.peak_pressure * record.length;
    record.wet_length = record.peak_pressure > 0.0 ? record.length : 0.0;
  }
  return record;
}

/// Overwrites the record; its memory is used again.
void DynamicRun::observe(StepRecord& record) const {
  record.time = state_.time;
  record.crest = state_.displacement.segment<2>(2 * crest_);
  record.hydrodynamic_force = 0.0;
  for (std::size_t m = 0; m < around_->media().size(); ++m) {
    const AttachedMedium& medium = *around_->media()[m];
    if (medium.name == "reservoir") record.hydrodynamic_force = -step_->equations().medium_forces()[m].sum();
  }
  record.cracks.clear();
  Index pair = 0;
  for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
    record.cracks.push_back(observe_crack(c, pair));
    pair += body_.cracks[c].pairs.count();
  }
  const bool stepped = step_->faces() != nullptr && number_ > 0;
  record.face_iterations = stepped ? step_->faces()->result().iterations : 0;
  record.face_residual = stepped ? step_->faces()->result().residual : 0.0;
}

bool DynamicRun::step(long long number) {
  around_->load_at(number, body_.dead_load, end_);
  if (!step_->solve(state_, start_, end_, next_)) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "contact and water between the crack faces were not found in the step after %.6g s; residual %.2g of its bound",
        state_.time, step_->faces()->result().residual);
    return stop(text), false;
  }
  const FaceWork work = step_->accept(next_, end_.ground);
  energy_.add(step_->equations(), state_, next_, start_, end_, media_before_, work, released_);
  released_.resize(0);
  media_before_ = step_->equations().medium_forces();
  std::swap(state_, next_);
  std::swap(start_, end_);
  number_ = number;
  state_.time = around_->time_at(number);
  note_felt();
  if (step_->faces() != nullptr) {
    const faces::FaceStepResult& result = step_->faces()->result();
    ledger_.count("face_iterations", result.iterations);
    ledger_.count("water_solves", result.water_trials);
    ledger_.count("stiffness_enlargements", result.enlargements);
    ledger_.count("continued_steps", result.parts > 1 ? 1 : 0);
  }
  return true;
}

void DynamicRun::finish() {
  results::Quantity& found = summary_.quantities;
  record_->write(found);
  found["energy_balance_error"] = energy_.balance_error();
  found["end_time"] = state_.time;
  for (const AttachedMedium* medium : around_->media()) {
    if (medium->memory_error) found[medium->name + "_memory_error"] = *medium->memory_error;
  }
  if (!end_event_.empty()) found["end"] = end_event_ + " at " + time_text();
  if (scene_.propagation) {
    results::Quantity::List lengths, paths;
    for (std::size_t c = 0; c < body_.cracks.size(); ++c) {
      lengths.emplace_back(body_.cracks[c].pairs.tip_position);
      results::Quantity::List path;
      for (const mesh::Point& point : paths_[c]) path.emplace_back(results::Quantity::List{point.x(), point.y()});
      paths.emplace_back(std::move(path));
    }
    found["final_crack_length"] = lengths.size() == 1 ? lengths.front() : results::Quantity(lengths);
    found["crack_path"] = paths.size() == 1 ? paths.front() : results::Quantity(paths);
    found["events"] = events_;
  }
  if (!profiles_.empty()) found["profiles"] = profiles_;
  if (fields_ != nullptr) fields_->commit();
  summary_.history = record_->take_history();
  summary_.mesh = {
      .polygons = body_.body.nodes.polygon_count(), .nodes = body_.body.nodes.node_count(), .dofs = body_.body.dofs()};
  if (options_.final_body) options_.final_body(body_.body);
}

void DynamicRun::go() {
  if (!begin()) return;
  const long long steps = around_->steps();
  record_ = std::make_unique<DynamicRecord>(RecordedParts{.cracks = body_.cracks.size(),
                                                          .media = !around_->media().empty(),
                                                          .contact = scene_.contact.has_value(),
                                                          .water = scene_.crack_water.has_value(),
                                                          .propagation = scene_.propagation.has_value()},
                                            static_cast<std::size_t>(steps));
  if (has_checkpoints()) identity_ = identity();  // of the body before it grows
  if (options_.resume) {
    go_on();
  } else {
    observe(now_);
    record_->add(now_, energy_.energies());
    write_fields();
  }
  {
    const Ledger::Visit visit(ledger_, "dynamics", "steps");
    for (long long number = number_ + 1; number <= steps; ++number) {
      if (options_.stop != nullptr && options_.stop->load()) {
        stop("interrupted at " + time_text());
        if (has_checkpoints()) keep();
        break;
      }
      if (!step(number)) break;
      observe(now_);
      record_->add(now_, energy_.energies());
      note_profiles();
      write_fields();
      ledger_.count("steps");
      if (scene_.propagation && number < steps && !grow_cracks()) break;
      if (!end_event_.empty()) break;
      if (wants_checkpoint(number)) keep();
      if (options_.progress && number % 16 == 0)
        options_.progress("steps", static_cast<double>(number) / static_cast<double>(steps));
    }
  }
  charge_parts();
  if (has_checkpoints() && summary_.completed()) std::filesystem::remove(checkpoint_file(options_.output));
  finish();
}

void run_dynamic(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                 Ledger& ledger, results::RunSummary& summary) {
  DynamicRun(scene, body, options, pool, ledger, summary).go();
}

}  // namespace sunder::simulation
