#include "solver/contact/contact_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/require.hpp"

namespace sunder::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::planted_fault;
using numerics::refuse;
using numerics::require_not_negative;
using numerics::require_positive;

std::string entry(const char* name, Eigen::Index i) {
  return std::string(name) + "[" + std::to_string(i) + "]";
}

std::string entry(const char* name, Eigen::Index i, Eigen::Index j) {
  return std::string(name) + "(" + std::to_string(i) + ", " + std::to_string(j) + ")";
}

void check_flexibility(const Eigen::Ref<const MatrixXd>& F) {
  for (Eigen::Index j = 0; j < F.cols(); ++j) {
    for (Eigen::Index i = 0; i < F.rows(); ++i) {
      if (!std::isfinite(F(i, j))) refuse(entry("F", i, j), F(i, j), "finite");
    }
    if (F(j, j) < 0.0) refuse(entry("F", j, j), F(j, j), ">= 0");
  }
  for (Eigen::Index j = 0; j < F.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i) {
      const double round_off = 1e-6 * std::sqrt(F(i, i)) * std::sqrt(F(j, j));
      if (std::abs(F(i, j) - F(j, i)) > round_off) {
        refuse(entry("F", i, j), F(i, j), "symmetric, but its mirror image is " + std::to_string(F(j, i)));
      }
    }
  }
}

}  // namespace

void check(const ContactOptions& options) {
  require_positive("initial_stiffness", options.initial_stiffness);
  if (!(options.growth_factor > 1.0 && std::isfinite(options.growth_factor))) {
    refuse("growth_factor", options.growth_factor, "finite and > 1");
  }
  if (!(options.maximum_stiffness >= options.initial_stiffness && std::isfinite(options.maximum_stiffness))) {
    refuse("maximum_stiffness", options.maximum_stiffness,
           "finite and >= initial_stiffness = " + std::to_string(options.initial_stiffness));
  }
  require_positive("penetration_tolerance", options.penetration_tolerance);
  require_not_negative("friction_coefficient", options.friction_coefficient);
  require_positive("friction_tolerance", options.friction_tolerance);
  if (options.friction_iterations < 1) refuse("friction_iterations", options.friction_iterations, ">= 1");
}

ContactSolver::ContactSolver(const ContactOptions& options) : options_(options) {
  check(options);
  stiffness_ = options.initial_stiffness;
  set_faces(MatrixXd(), VectorXd());
}

void ContactSolver::set_faces(const Eigen::Ref<const MatrixXd>& F, const Eigen::Ref<const VectorXd>& tributary_length) {
  const Eigen::Index n = tributary_length.size(), all = with_friction() ? 2 * n : n;
  if (F.rows() != all || F.cols() != all) {
    throw std::invalid_argument("F is " + std::to_string(F.rows()) + " x " + std::to_string(F.cols()) + " for " +
                                std::to_string(n) + " pairs; it must be " + std::to_string(all) + " x " +
                                std::to_string(all) + (with_friction() ? ", with friction" : ""));
  }
  for (Eigen::Index i = 0; i < n; ++i) require_not_negative(entry("tributary_length", i), tributary_length[i]);
  check_flexibility(F);

  n_ = static_cast<int>(n);
  F_ = 0.5 * (F + F.transpose());
  length_ = tributary_length;
  for (VectorXd* v : {&softness_, &load_, &lower_, &work_, &free_change_, &change_}) v->setZero(all);
  upper_.setConstant(all, std::numeric_limits<double>::infinity());
  for (VectorXd* v : {&bound_, &stick_, &bound_change_, &result_.pair_force, &result_.gap}) v->setZero(n);
  result_.shear_force.setZero(with_friction() ? n : 0);
  minimum_.resize(static_cast<int>(all));
  minimum_.set_matrix(F_, softness_);
  set_stiffness(stiffness_);
}

void ContactSolver::set_stiffness(double k) {
  stiffness_ = k;
  if (options_.model == ContactModel::exact) return;
  for (int i = 0; i < n_; ++i) {
    const double length = planted_fault("contact/whole-length-at-the-mouth") && i == 0 ? 2.0 * length_[i] : length_[i];
    const bool spring = std::isfinite(1.0 / (k * length));
    softness_[i] = spring ? 1.0 / (k * length) : 0.0;
    upper_[i] = spring ? std::numeric_limits<double>::infinity() : 0.0;
    if (planted_fault("contact/spring-sign")) softness_[i] = -std::min(softness_[i], 0.5 * F_(i, i));
    if (with_friction()) softness_[n_ + i] = softness_[i];
  }
  minimum_.set_diagonal(F_, softness_);
}

void ContactSolver::forget() {
  minimum_.forget();
  bound_.setZero();
  set_stiffness(options_.initial_stiffness);
}

const ContactResult& ContactSolver::solve(const Eigen::Ref<const VectorXd>& gap) noexcept {
  if (gap.size() != n_ || with_friction() || !gap.allFinite()) {
    result_.status = ContactStatus::unusable_input;
    return result_;
  }
  load_ = gap;
  return solve_prepared();
}

const ContactResult& ContactSolver::solve(const Eigen::Ref<const VectorXd>& gap,
                                          const Eigen::Ref<const VectorXd>& sliding) noexcept {
  if (!with_friction()) return solve(gap);
  if (gap.size() != n_ || sliding.size() != n_ || !gap.allFinite() || !sliding.allFinite()) {
    result_.status = ContactStatus::unusable_input;
    return result_;
  }
  load_.head(n_) = gap;
  load_.tail(n_) = sliding - stick_;
  return solve_prepared();
}

const ContactResult& ContactSolver::solve_prepared() noexcept {
  result_.enlargements = result_.iterations = result_.friction_iterations = 0;
  if (n_ == 0) {
    result_.status = ContactStatus::converged;
    result_.stiffness = options_.model == ContactModel::exact ? 0.0 : stiffness_;
    return result_;
  }
  for (;;) {
    const MinimumStatus status = solve_at_stiffness();
    read_answer();
    const double tolerance = options_.penetration_tolerance * (planted_fault("contact/gate-not-enforced") ? 1e6 : 1.0);
    const bool within = result_.largest_penetration <= tolerance;
    const bool exact = options_.model == ContactModel::exact;
    if (status == MinimumStatus::none) {
      result_.status = ContactStatus::no_solution;
    } else if (status == MinimumStatus::not_found || (exact && !within)) {
      result_.status = ContactStatus::not_converged;
    } else if (!friction_settled_) {
      result_.status = ContactStatus::friction_not_converged;
    } else if (within) {
      result_.status = ContactStatus::converged;
    } else if (stiffness_ * options_.growth_factor > options_.maximum_stiffness * (1.0 + 1e-9)) {
      result_.status = ContactStatus::penetration_too_large;
    } else {
      set_stiffness(stiffness_ * options_.growth_factor);
      ++result_.enlargements;
      continue;
    }
    return result_;
  }
}

MinimumStatus ContactSolver::solve_at_stiffness() noexcept {
  friction_settled_ = true;
  if (planted_fault("contact/faces-glued")) lower_.head(n_).setConstant(-std::numeric_limits<double>::infinity());
  if (with_friction()) return settle_friction();
  const MinimumReport report = minimum_.solve(load_, lower_, upper_);
  result_.iterations += report.pivots;
  return report.status;
}

/// Bounds μ λ of the last answer, until they no longer change.
MinimumStatus ContactSolver::settle_friction() noexcept {
  double share = 1.0, before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < options_.friction_iterations; ++i) {
    upper_.tail(n_) = (planted_fault("contact/friction-not-bounded") ? 10.0 : 1.0) * bound_;
    lower_.tail(n_) = -upper_.tail(n_);
    const MinimumReport report = minimum_.solve(load_, lower_, upper_);
    result_.iterations += report.pivots;
    ++result_.friction_iterations;
    if (report.status != MinimumStatus::found) return report.status;
    work_.head(n_) = options_.friction_coefficient * minimum_.x().head(n_);
    const double change = (work_.head(n_) - bound_).cwiseAbs().maxCoeff();
    if (!(change > options_.friction_tolerance * work_.head(n_).maxCoeff())) return MinimumStatus::found;
    if (!(change < before)) share *= 0.5;
    before = change;
    bound_ += share * (work_.head(n_) - bound_);
  }
  friction_settled_ = false;
  return MinimumStatus::found;
}

void ContactSolver::read_answer() noexcept {
  const auto x = minimum_.x().head(n_);
  result_.stiffness = options_.model == ContactModel::exact ? 0.0 : stiffness_;
  result_.pair_force = x;
  if (with_friction()) result_.shear_force = minimum_.x().tail(n_);
  result_.gap = minimum_.gradient().head(n_) - softness_.head(n_).cwiseProduct(x);
  result_.closed = static_cast<int>((x.array() > 0.0).count());
  result_.largest_penetration = std::max(0.0, -result_.gap.minCoeff());
  result_.largest_tension = std::max(0.0, -x.minCoeff());
  const double largest = x.maxCoeff();
  result_.complementarity =
      largest > 0.0 ? x.cwiseProduct(minimum_.gradient().head(n_)).cwiseAbs().maxCoeff() / largest : 0.0;
}

void ContactSolver::accept() noexcept {
  if (!with_friction()) return;
  // -τ/(k L) is how far the spring along the crack is strained: what remains is the stick point.
  stick_ += minimum_.gradient().tail(n_);
}

}  // namespace sunder::contact
