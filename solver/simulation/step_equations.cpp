#include "solver/simulation/step_equations.hpp"

#include <cassert>
#include <utility>

#include "solver/numerics/planted_fault.hpp"

namespace sunder::simulation {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Adds `factor` Σ W_0 to a lower triangle and puts the identity at prescribed dofs.
SparseMatrix with_media(SparseMatrix matrix, const Constraints& constraints,
                        std::span<const AttachedMedium* const> media, double factor) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const AttachedMedium* medium : media) {
    if (numerics::planted_fault("simulation/instantaneous-mass-on-load-side")) continue;
    const Eigen::MatrixXd& W = medium->convolution->instantaneous_mass();
    for (Index j = 0; j < W.cols(); ++j) {
      for (Index i = 0; i < W.rows(); ++i) {
        const int row = medium->dofs[static_cast<std::size_t>(i)], column = medium->dofs[static_cast<std::size_t>(j)];
        if (row >= column) entries.emplace_back(row, column, factor * 0.5 * (W(i, j) + W(j, i)));
      }
    }
  }
  if (!entries.empty()) {
    SparseMatrix added(matrix.rows(), matrix.cols());
    added.setFromTriplets(entries.begin(), entries.end());
    matrix += added;
  }
  VectorXd none = VectorXd::Zero(matrix.rows());
  Constraints resting(static_cast<int>(matrix.rows()));
  resting.fixed = constraints.fixed;
  eliminate(resting, matrix.diagonal().cwiseAbs().mean(), matrix, none);
  matrix.makeCompressed();
  return matrix;
}

/// Lower triangle of c_M M + c_C C + c_K K + c_W Σ W_0.
SparseMatrix matrix_of_step(const SparseMatrix& stiffness, const SparseMatrix& mass, const Constraints& constraints,
                            std::span<const AttachedMedium* const> media, const StepOptions& options) {
  const dynamics::StepFactors factors = dynamics::step_factors(options.scheme, options.time_step);
  const double of_mass = factors.mass + options.damping.of_mass * factors.damping;
  const double of_stiffness = factors.stiffness + options.damping.of_stiffness * factors.damping;
  const double of_media =
      (1.0 - options.scheme.alpha_f) / (options.scheme.beta * options.time_step * options.time_step);
  return with_media(of_mass * mass + of_stiffness * stiffness, constraints, media, of_media);
}

}  // namespace

StepEquations::StepEquations(const SparseMatrix& stiffness, const SparseMatrix& mass, const Constraints& constraints,
                             std::span<const AttachedMedium* const> media, const StepOptions& options)
    : options_(options),
      stiffness_(stiffness),
      mass_(mass),
      constraints_(&constraints),
      products_(stiffness, mass),
      media_(media.begin(), media.end()),
      factor_(matrix_of_step(stiffness, mass, constraints, media, options), {.block = 2}) {
  const Index dofs = stiffness.rows();
  ground_mass_.resize(2, dofs);
  for (int component = 0; component < 2; ++component) {
    VectorXd direction = VectorXd::Zero(dofs);
    for (Index dof = component; dof < dofs; dof += 2) direction[dof] = 1.0;
    ground_mass_.row(component) = (mass_.selfadjointView<Eigen::Lower>() * direction).transpose();
  }
  d_.setZero(dofs);
  for (numerics::VectorPair* values :
       {&with_stiffness_, &with_mass_, &now_.stiffness, &now_.mass, &before_.stiffness, &before_.mass})
    values->setZero(4, dofs / 2);
  for (int dof = 0; dof < static_cast<int>(dofs); ++dof) {
    if (constraints.fixed[static_cast<std::size_t>(dof)]) held_.push_back(dof);
  }
  for (const AttachedMedium* medium : media_) {
    const Index n = std::ssize(medium->dofs);
    for (std::vector<VectorXd>* list : {&histories_, &medium_forces_, &medium_work_, &medium_answer_})
      list->push_back(VectorXd::Zero(n));
  }
}

void StepEquations::hold(VectorXd& values) const {
  for (const int dof : held_) values[dof] = 0.0;
}

Eigen::MatrixXd StepEquations::answer(const SparseMatrix& loads) const {
  Eigen::MatrixXd X = (1.0 - options_.scheme.alpha_f) * Eigen::MatrixXd(loads);
  for (const int dof : held_) X.row(dof).setZero();
  if (X.cols() > 0) factor_.solve_in_place(X);
  return X;
}

void StepEquations::begin(MotionState& state, const Eigen::Vector2d& ground, std::span<AttachedMedium* const> media) {
  if (ground.squaredNorm() == 0.0) return;
  VectorXd right = -ground_load(ground);
  for (std::size_t m = 0; m < media_.size(); ++m) {
    const AttachedMedium& medium = *media_[m];
    VectorXd& known = medium_work_[m];
    for (std::size_t i = 0; i < medium.dofs.size(); ++i) {
      known[static_cast<Index>(i)] = medium.driven_by == DrivenBy::total ? ground[medium.dofs[i] % 2] : 0.0;
    }
    histories_[m] = medium.convolution->instantaneous_mass() * known;
    for (std::size_t i = 0; i < medium.dofs.size(); ++i) right[medium.dofs[i]] -= histories_[m][static_cast<Index>(i)];
  }
  hold(right);
  const numerics::SymmetricFactor inertia(with_media(mass_, *constraints_, media_, 1.0), {.block = 2});
  if (inertia.status() != numerics::FactorStatus::factorised) return;  // massless: there is no acceleration to find
  inertia.solve_in_place(right);
  state.acceleration = right;
  accept(state, ground, media);
}

double StepEquations::acceleration_factor() const {
  return 1.0 / (options_.scheme.beta * options_.time_step * options_.time_step);
}

double StepEquations::work_on_medium(std::size_t i, const VectorXd& moved, const VectorXd& before) const {
  double work = 0.0;
  for (std::size_t k = 0; k < media_[i]->dofs.size(); ++k) {
    const auto row = static_cast<Index>(k);
    work += moved[media_[i]->dofs[k]] * (before[row] + medium_forces_[i][row]);
  }
  return work;
}

void StepEquations::stand_at(const MotionState& state) {
  const auto [am, af, beta, gamma] = options_.scheme;
  const double dt = options_.time_step, alpha = options_.damping.of_mass, damping_beta = options_.damping.of_stiffness;
  // a' = d/(β Δt²) + a0,  v' = γ d/(β Δt) + v0:  what d leaves out
  const double of_v = -1.0 / (beta * dt), of_a = -(0.5 - beta) / beta;
  const double v0_of_v = 1.0 + gamma * dt * of_v, v0_of_a = dt * (1.0 - gamma) + gamma * dt * of_a;
  const double w_of_v = (1.0 - af) * v0_of_v + af, w_of_a = (1.0 - af) * v0_of_a;
  const double q_of_v = (1.0 - am) * of_v + alpha * w_of_v, q_of_a = (1.0 - am) * of_a + am + alpha * w_of_a;
  const auto node_by_node = [](const VectorXd& values) {
    return Eigen::Map<const Eigen::Matrix2Xd>(values.data(), 2, values.size() / 2);
  };
  const auto u = node_by_node(state.displacement), v = node_by_node(state.velocity),
             a = node_by_node(state.acceleration);
  for (Index node = 0; node < u.cols(); ++node) {
    with_stiffness_.col(node).head<2>() = u.col(node);
    // prescribed displacements act through K like all others
    with_stiffness_.col(node).tail<2>() =
        u.col(node) + (damping_beta * w_of_v) * v.col(node) + (damping_beta * w_of_a) * a.col(node);
    with_mass_.col(node).head<2>() = v.col(node);
    with_mass_.col(node).tail<2>() = q_of_v * v.col(node) + q_of_a * a.col(node);
  }
  std::swap(now_, before_);
  products_.multiply(with_stiffness_, with_mass_, now_.stiffness, now_.mass);
}

bool StepEquations::stands_at(const MotionState& state) const {
  return with_stiffness_.topRows<2>() == state.displacement.reshaped(2, state.displacement.size() / 2) &&
         with_mass_.topRows<2>() == state.velocity.reshaped(2, state.velocity.size() / 2);
}

const VectorXd& StepEquations::trial(const MotionState& state, const StepLoad& start, const StepLoad& end) {
  assert(stands_at(state));
  const auto [am, af, beta, gamma] = options_.scheme;
  const double of_v = -1.0 / (beta * options_.time_step), of_a = -(0.5 - beta) / beta;  // of a', without d
  const VectorXd &v = state.velocity, &a = state.acceleration;
  const double ground_sign = numerics::planted_fault("simulation/inertia-load-sign") ? -1.0 : 1.0;
  const Eigen::Vector2d ground = ground_sign * ((1.0 - af) * end.ground + af * start.ground);
  d_ = (1.0 - af) * end.force + af * start.force;
  for (Index node = 0; node < now_.mass.cols(); ++node) {
    d_.segment<2>(2 * node) -= ground_mass_.middleCols<2>(2 * node).transpose() * ground +
                               now_.stiffness.col(node).tail<2>() + now_.mass.col(node).tail<2>();
  }
  for (std::size_t m = 0; m < media_.size(); ++m) {
    const AttachedMedium& medium = *media_[m];
    VectorXd& history = histories_[m];
    VectorXd& known = medium_work_[m];
    {
      const numerics::Meter::Lap lap(medium.work);
      medium.convolution->history_force(history);
    }
    const Eigen::MatrixXd& W = medium.convolution->instantaneous_mass();
    if (medium.driven_by == DrivenBy::total) {  // the part of its acceleration that is known beforehand: the ground's
      for (std::size_t i = 0; i < medium.dofs.size(); ++i)
        known[static_cast<Index>(i)] = end.ground[medium.dofs[i] % 2];
      history.noalias() += W * known;
    }
    for (std::size_t i = 0; i < medium.dofs.size(); ++i) {
      const int dof = medium.dofs[i];
      known[static_cast<Index>(i)] = numerics::planted_fault("simulation/instantaneous-mass-on-load-side")
                                         ? a[dof]
                                         : of_v * v[dof] + of_a * a[dof];
    }
    VectorXd& answer = medium_answer_[m];
    answer.noalias() = W * known;
    for (std::size_t i = 0; i < medium.dofs.size(); ++i) {
      const auto row = static_cast<Index>(i);
      d_[medium.dofs[i]] -= (1.0 - af) * (history[row] + answer[row]) + af * medium_forces_[m][row];
    }
  }
  hold(d_);
  factor_.solve_in_place(d_);
  return d_;
}

void StepEquations::advance(const MotionState& state, const VectorXd& d, MotionState& next) const {
  const auto [am, af, beta, gamma] = options_.scheme;
  const double dt = options_.time_step;
  next.displacement = state.displacement + d;
  next.acceleration =
      (1.0 / (beta * dt * dt)) * d - (1.0 / (beta * dt)) * state.velocity - ((0.5 - beta) / beta) * state.acceleration;
  next.velocity = state.velocity + (dt * (1.0 - gamma)) * state.acceleration + (dt * gamma) * next.acceleration;
  next.time = state.time + dt;
}

void StepEquations::accept(const MotionState& next, const Eigen::Vector2d& ground,
                           std::span<AttachedMedium* const> media) {
  for (std::size_t m = 0; m < media.size(); ++m) {
    AttachedMedium& medium = *media[m];
    VectorXd& felt = medium_work_[m];
    for (std::size_t i = 0; i < medium.dofs.size(); ++i)
      felt[static_cast<Index>(i)] = next.acceleration[medium.dofs[i]];
    medium_forces_[m] = histories_[m];  // the ground's share is in it
    medium_forces_[m].noalias() += medium.convolution->instantaneous_mass() * felt;
    if (medium.driven_by == DrivenBy::total) {
      for (std::size_t i = 0; i < medium.dofs.size(); ++i) felt[static_cast<Index>(i)] += ground[medium.dofs[i] % 2];
    }
    const numerics::Meter::Lap lap(medium.work);
    medium.convolution->append(felt);
  }
  stand_at(next);
}

}  // namespace sunder::simulation
