#include "solver/faces/face_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::faces {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double least_opening = 1e-6;     // m, of the scale in inequality 1
constexpr double least_pressure = 1e3;     // Pa, of the scale in inequality 2
constexpr double least_part = 1.0 / 4096;  // of the motion, in the continuation
constexpr double enough_decrease = 1e-4;   // of the merit, times the step [Armijo 1966]

void require(bool holds, const char* name, double value, const char* bound) {
  if (!holds) throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + " must be " + bound);
}

void check(const FaceStructure& structure, const FaceStepOptions& options) {
  const Index m = structure.answer.rows();
  Index forces = 0, pairs = 0;
  for (const CrackBlock& crack : structure.cracks) {
    require(crack.first == forces, "first force of a crack", static_cast<double>(crack.first),
            "the end of the one before");
    require(crack.forces >= crack.pairs && crack.pairs >= 1, "forces of a crack", static_cast<double>(crack.forces),
            "at least its pairs, and these at least 1");
    if (crack.water != nullptr) {
      require(crack.water->pairs() == crack.pairs && crack.water->forces() == crack.forces, "water's pairs",
              static_cast<double>(crack.water->pairs()), "those of the crack");
    }
    forces += crack.forces;
    pairs += crack.pairs;
  }
  require(m == forces && structure.answer.cols() == m, "rows of the answer", static_cast<double>(m), "one a force");
  require(structure.mouth.rows() == std::ssize(structure.cracks) && structure.mouth.cols() == m,
          "rows of the mouth's answer", static_cast<double>(structure.mouth.rows()), "one a crack");
  require(structure.tributary_length.size() == pairs, "tributary lengths",
          static_cast<double>(structure.tributary_length.size()), "one a pair");
  require(structure.answer.allFinite(), "answer", std::numeric_limits<double>::quiet_NaN(), "finite");
  const auto positive = [](const char* name, double value) {
    require(value > 0.0 && std::isfinite(value), name, value, "finite and > 0");
  };
  positive("initial_stiffness", options.initial_stiffness);
  positive("penetration_tolerance", options.penetration_tolerance);
  positive("opening_tolerance", options.opening_tolerance);
  positive("pressure_tolerance", options.pressure_tolerance);
  require(options.growth_factor > 1.0 && std::isfinite(options.growth_factor), "growth_factor", options.growth_factor,
          "finite and > 1");
  require(options.max_iterations >= 1, "max_iterations", options.max_iterations, "at least 1");
  require(options.max_halvings >= 1, "max_halvings", options.max_halvings, "at least 1");
}

}  // namespace

FaceStep::FaceStep(FaceStructure structure, const FaceStepOptions& options)
    : structure_((check(structure, options), std::move(structure))),
      options_(options),
      complementarity_(structure_.tributary_length.size()) {
  for (const CrackBlock& crack : structure_.cracks) {
    for (Index pair = 0; pair < crack.pairs; ++pair) rows_.push_back(crack.first + pair);
    waters_.emplace_back(crack.forces, crack.pairs);
    wet_ = wet_ || crack.water != nullptr;
  }
  const Index m = structure_.answer.rows(), n = pair_count(), cracks = std::ssize(structure_.cracks);
  for (VectorXd* values :
       {&motion_, &motion_from_, &motion_goal_, &force_, &moved_, &right_, &solution_, &result_.force, &result_.motion})
    values->setZero(m);
  for (VectorXd* values : {&mouth_, &mouth_from_, &mouth_goal_, &result_.mouth_pressure}) values->setZero(cracks);
  for (VectorXd* values : {&free_opening_, &result_.opening, &result_.contact_force}) values->setZero(n);
  for (Iterate* iterate : {&at_, &trial_, &next_, &start_, &safe_}) {
    iterate->opening.setZero(n);
    iterate->contact.setZero(n);
    iterate->mouth.setZero(cracks);
  }
  coupled_.setIdentity(m, m);
  constrained_.setZero(n, n);
  force_by_lambda_.setZero(m, n);
  pressed_.assign(static_cast<std::size_t>(n), 0);
  factor_ = Eigen::PartialPivLU<Eigen::MatrixXd>(m);
  stiffness_ = options_.contact == ContactRule::penalty ? options_.initial_stiffness : 0.0;
}

void FaceStep::begin_with(const Eigen::Ref<const VectorXd>& opening, const Eigen::Ref<const VectorXd>& contact_force,
                          double stiffness) {
  result_.opening = opening;
  result_.contact_force = contact_force;
  if (options_.contact == ContactRule::penalty) stiffness_ = std::fmax(stiffness, options_.initial_stiffness);
}

FaceStepMemory FaceStep::memory() const {
  return {.force = result_.force,
          .motion = result_.motion,
          .opening = result_.opening,
          .contact_force = result_.contact_force,
          .mouth_pressure = result_.mouth_pressure,
          .touching = complementarity_.touching(),
          .stiffness = stiffness_};
}

void FaceStep::go_on(const FaceStepMemory& memory) {
  result_.force = memory.force;
  result_.motion = memory.motion;
  result_.opening = memory.opening;
  result_.contact_force = memory.contact_force;
  result_.mouth_pressure = memory.mouth_pressure;
  complementarity_.begin_with(memory.touching);
  stiffness_ = memory.stiffness;
}

double FaceStep::compliance(Index pair) const {
  return options_.contact == ContactRule::penalty ? 1.0 / (stiffness_ * structure_.tributary_length[pair]) : 0.0;
}

/// f, its derivatives, and y = f + λ.
void FaceStep::apply_water(const Iterate& at, double time_step) {
  force_.setZero();
  water_found_ = true;
  for (std::size_t c = 0, pair = 0; c < structure_.cracks.size(); ++c) {
    const CrackBlock& crack = structure_.cracks[c];
    if (crack.water != nullptr) {
      const double* first = at.opening.data() + pair;
      // a trial whose own solution was not found still has a best answer, on which no step may end
      water_found_ &= crack.water->trial({first, static_cast<std::size_t>(crack.pairs)},
                                         at.mouth[static_cast<Index>(c)], time_step, waters_[c]);
      force_.segment(crack.first, crack.forces) = waters_[c].force;
      ++result_.water_trials;
    }
    pair += static_cast<std::size_t>(crack.pairs);
  }
  for (Index pair = 0; pair < pair_count(); ++pair) force_[rows_[static_cast<std::size_t>(pair)]] += at.contact[pair];
}

/// The largest of inequalities 1 … 3 as a multiple of its bound; `apply_water` must have been called for `at`.
double FaceStep::merit(const Iterate& at) {
  moved_ = motion_;
  moved_.noalias() += structure_.answer * force_;
  double worst = 0.0;
  for (Index pair = 0; pair < pair_count(); ++pair) {
    const Index row = rows_[static_cast<std::size_t>(pair)];
    worst = std::fmax(worst, std::abs(at.opening[pair] - moved_[row]) / opening_bound_);
    if (options_.contact == ContactRule::none) continue;
    const double gap = at.opening[pair] + compliance(pair) * at.contact[pair];
    const double pressed = at.contact[pair] * structure_.answer(row, row);
    worst = std::fmax(worst, std::abs(std::fmin(gap, pressed)) / opening_bound_);
  }
  for (Index c = 0; c < at.mouth.size(); ++c) {
    const double answer = mouth_[c] + structure_.mouth.row(c).dot(force_);
    worst = std::fmax(worst, std::abs(at.mouth[c] - answer) / pressure_bound_);
  }
  return std::isfinite(worst) && water_found_ ? worst : std::numeric_limits<double>::infinity();
}

/// (I - J S - j R), factorised, and in `right_` the forces f + J (g* - g) + j (p* - p) of the linear problem.
void FaceStep::couple_water(const Iterate& at) {
  coupled_.setIdentity();
  right_.setZero();
  Index pair = 0;
  for (std::size_t c = 0; c < structure_.cracks.size(); ++c) {
    const CrackBlock& crack = structure_.cracks[c];
    if (crack.water != nullptr) {
      auto rows = coupled_.middleRows(crack.first, crack.forces);
      auto right = right_.segment(crack.first, crack.forces);
      const WaterForces& water = waters_[c];
      // the pairs are the first forces of the block
      rows.noalias() -= water.by_opening * structure_.answer.middleRows(crack.first, crack.pairs);
      rows.noalias() -= water.by_mouth * structure_.mouth.row(static_cast<Index>(c));
      right = water.force;
      right.noalias() +=
          water.by_opening * (motion_.segment(crack.first, crack.pairs) - at.opening.segment(pair, crack.pairs));
      right += (mouth_[static_cast<Index>(c)] - at.mouth[static_cast<Index>(c)]) * water.by_mouth;
    }
    pair += crack.pairs;
  }
  factor_.compute(coupled_);
}

/// What a unit of λ at each of these pairs does to all forces, and to the openings with its spring's give.
void FaceStep::press(std::span<const Index> pairs) {
  for (const Index pair : pairs) {
    if (pressed_[static_cast<std::size_t>(pair)] != 0) continue;
    pressed_[static_cast<std::size_t>(pair)] = 1;
    const Index row = rows_[static_cast<std::size_t>(pair)];
    auto force = force_by_lambda_.col(pair);
    if (wet_) {
      right_.setZero();
      right_[row] = 1.0;
      solution_ = factor_.solve(right_);
      force = solution_;
      moved_.noalias() = structure_.answer * force;
    } else {
      force.setZero();
      force[row] = 1.0;
      moved_ = structure_.answer.col(row);
    }
    for (Index i = 0; i < pair_count(); ++i) constrained_(i, pair) = moved_[rows_[static_cast<std::size_t>(i)]];
    constrained_(pair, pair) += compliance(pair);
  }
}

/// Contact of the linear problem from its openings without; `next.opening` holds these and takes what λ adds. False
/// where it has no solution.
bool FaceStep::touch(Iterate& next) {
  std::ranges::fill(pressed_, static_cast<char>(0));
  const auto will_read = [this](std::span<const Index> pairs) { press(pairs); };
  if (complementarity_.solve(constrained_, free_opening_, next.contact, will_read) == ComplementarityStatus::singular)
    return false;
  for (Index pair = 0; pair < pair_count(); ++pair) {
    const double lambda = next.contact[pair];
    if (lambda == 0.0) continue;
    next.opening += lambda * constrained_.col(pair);
    next.opening[pair] -= compliance(pair) * lambda;
  }
  return true;
}

/// Newton's step from `at`, where the water was applied: y = f + J (g* + S y - g) + j (p* + R y - p) + λ. Only pairs
/// that touch cost a solve each.
bool FaceStep::predict(const Iterate& at, Iterate& next) {
  if (wet_) {
    couple_water(at);
    force_ = factor_.solve(right_);
    moved_ = motion_;
    moved_.noalias() += structure_.answer * force_;
  } else {
    force_.setZero();
    moved_ = motion_;
  }
  if (!moved_.allFinite()) return false;
  for (Index i = 0; i < pair_count(); ++i) free_opening_[i] = moved_[rows_[static_cast<std::size_t>(i)]];
  next.opening = free_opening_;
  next.contact.setZero();
  if (options_.contact != ContactRule::none) {
    if (!touch(next)) return false;
    for (Index pair = 0; pair < pair_count(); ++pair) {  // y of the linear problem, for the mouths
      if (next.contact[pair] != 0.0) force_ += next.contact[pair] * force_by_lambda_.col(pair);
    }
  }
  next.mouth = mouth_;
  next.mouth.noalias() += structure_.mouth * force_;
  return next.opening.allFinite() && next.mouth.allFinite();
}

/// From `at_`; leaves the solution there. False where the residual stopped falling.
bool FaceStep::newton(double time_step) {
  apply_water(at_, time_step);
  double now = merit(at_);
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    ++result_.iterations;
    const bool met = now <= 1.0 || (iteration > 0 && numerics::planted_fault("faces/one-iteration-is-enough"));
    if (met && !enlarge()) return true;
    if (met) now = merit(at_);  // a stiffer spring: the old answer no longer fits
    if (!predict(at_, next_)) return false;
    double share = 1.0, best = std::numeric_limits<double>::infinity();
    for (int halving = 0;; ++halving) {
      trial_.opening = at_.opening + share * (next_.opening - at_.opening);
      trial_.contact = at_.contact + share * (next_.contact - at_.contact);
      trial_.mouth = at_.mouth + share * (next_.mouth - at_.mouth);
      apply_water(trial_, time_step);
      best = merit(trial_);
      if (best <= 1.0 || best < (1.0 - enough_decrease * share) * now) break;
      if (halving >= options_.max_halvings) {
        apply_water(at_, time_step);  // the forces belong to the best answer
        merit(at_);
        return false;
      }
      share *= 0.5;
    }
    std::swap(at_, trial_);
    now = best;
  }
  return now <= 1.0 && !enlarge();
}

/// True where the faces overlap by more than the tolerance and the spring could be made stiffer.
bool FaceStep::enlarge() {
  if (options_.contact != ContactRule::penalty || numerics::planted_fault("faces/penalty-never-enlarged")) return false;
  double penetration = 0.0;
  for (Index i = 0; i < pair_count(); ++i) penetration = std::fmax(penetration, -at_.opening[i]);
  // half of inequality 1 is left to what the last correction moves
  if (penetration <= options_.penetration_tolerance - 0.5 * opening_bound_) return false;
  if (stiffness_ > std::numeric_limits<double>::max() / options_.growth_factor / 1e8) return false;
  stiffness_ *= options_.growth_factor;
  ++result_.enlargements;
  return true;
}

/// What the structure answers to the forces found.
void FaceStep::finish() {
  result_.force = force_;
  result_.motion = motion_;
  result_.motion.noalias() += structure_.answer * force_;
  result_.largest_penetration = 0.0;
  for (Index i = 0; i < pair_count(); ++i) {
    result_.opening[i] = result_.motion[rows_[static_cast<std::size_t>(i)]];
    result_.largest_penetration = std::fmax(result_.largest_penetration, -result_.opening[i]);
  }
  result_.contact_force = at_.contact;
  result_.mouth_pressure = mouth_;
  result_.mouth_pressure.noalias() += structure_.mouth * force_;
  result_.residual = merit(at_);
  result_.stiffness = stiffness_;
}

const FaceStepResult& FaceStep::solve(const Eigen::Ref<const VectorXd>& motion,
                                      const Eigen::Ref<const VectorXd>& mouth_pressure, double time_step) {
  result_.iterations = result_.water_trials = result_.enlargements = result_.parts = 0;
  double largest = 0.0;
  for (const Index row : rows_) largest = std::fmax(largest, std::abs(motion[row]));
  opening_bound_ = options_.opening_tolerance * (largest + least_opening);
  pressure_bound_ =
      options_.pressure_tolerance * (mouth_pressure.size() > 0 ? mouth_pressure.cwiseAbs().maxCoeff() : 0.0) +
      options_.pressure_tolerance * least_pressure;
  motion_goal_ = motion;
  mouth_goal_ = mouth_pressure;
  // what would have led to the last accepted answer
  motion_from_ = result_.motion;
  motion_from_.noalias() -= structure_.answer * result_.force;
  mouth_from_ = result_.mouth_pressure;
  mouth_from_.noalias() -= structure_.mouth * result_.force;
  start_.opening = result_.opening;
  start_.contact = result_.contact_force;
  start_.mouth = mouth_pressure;
  start_.mouth.noalias() += structure_.mouth * result_.force;

  at_ = start_;
  motion_ = motion_goal_;
  mouth_ = mouth_goal_;
  result_.parts = 1;
  result_.status = FaceStatus::solved;
  if (newton(time_step)) {
    finish();
    return result_;
  }
  // Continuation: from no motion to the whole of it.
  safe_ = start_;
  double reached = 0.0, part = 0.5;
  while (reached < 1.0 && part >= least_part) {
    const double to = std::fmin(1.0, reached + part);
    motion_ = motion_from_ + to * (motion_goal_ - motion_from_);
    mouth_ = mouth_from_ + to * (mouth_goal_ - mouth_from_);
    at_ = safe_;
    ++result_.parts;
    if (newton(time_step)) {
      reached = to;
      safe_ = at_;
      part *= 2.0;
    } else {
      part *= 0.5;
    }
  }
  motion_ = motion_goal_;
  mouth_ = mouth_goal_;
  if (reached < 1.0) {
    result_.status = FaceStatus::not_converged;
    at_ = safe_;
    apply_water(at_, time_step);
  }
  finish();
  return result_;
}

void FaceStep::accept() {
  for (const CrackBlock& crack : structure_.cracks) {
    if (crack.water != nullptr) crack.water->accept();
  }
}

}  // namespace sunder::faces
