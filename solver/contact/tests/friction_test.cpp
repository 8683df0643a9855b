#include <gtest/gtest.h>

#include <cmath>

#include "solver/contact/contact_solver.hpp"
#include "solver/contact/tests/flexibilities.hpp"

namespace sunder::contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd one(double value) {
  return VectorXd::Constant(1, value);
}

ContactOptions rough(double mu) {
  return {.model = ContactModel::exact, .friction_coefficient = mu, .friction_tolerance = 1e-14};
}

TEST(Friction, OnePairSticksBelowItsBoundAndSlidesAtIt) {
  // λ = -g⁰/F_n = 5, so |τ| ≤ 2.5; sticking needs τ = -s⁰/F_t.
  const MatrixXd F{{0.2, 0.0}, {0.0, 0.1}};
  ContactSolver solver(rough(0.5));
  solver.set_faces(F, one(1.0));
  for (const double s : {-1.0, -0.26, -0.24, -0.1, 0.0, 0.1, 0.24, 0.26, 1.0}) {
    const ContactResult& result = solver.solve(one(-1.0), one(s));
    ASSERT_EQ(result.status, ContactStatus::converged);
    EXPECT_NEAR(result.pair_force[0], 5.0, 1e-14);
    EXPECT_NEAR(result.shear_force[0], std::abs(s) < 0.25 ? -s / 0.1 : std::copysign(2.5, -s), 1e-13) << s;
  }
  EXPECT_EQ(solver.solve(one(1.0), one(1.0)).shear_force[0], 0.0);  // open: nothing rubs
}

TEST(Friction, CouplingOfPressureAndShearFollowsItsClosedForm) {
  // Sliding towards +s: τ = -μ λ, λ (F_nn - μ F_nt) = -g⁰.
  const double Fn = 0.2, Ft = 0.3, c = 0.05, mu = 0.6;
  ContactSolver solver(rough(mu));
  solver.set_faces(MatrixXd{{Fn, c}, {c, Ft}}, one(1.0));
  const ContactResult& result = solver.solve(one(-1.0), one(10.0));
  ASSERT_EQ(result.status, ContactStatus::converged);
  EXPECT_NEAR(result.pair_force[0] * (Fn - mu * c), 1.0, 1e-13);
  EXPECT_NEAR(result.shear_force[0], -mu * result.pair_force[0], 1e-12);
  MatrixXd change = MatrixXd::Zero(2, 1);
  change(0, 0) = -1.0;
  EXPECT_TRUE(solver.differentiate(change));
  EXPECT_NEAR(change(0, 0) * (Fn - mu * c), 1.0, 1e-12);
  EXPECT_NEAR(change(1, 0), -mu * change(0, 0), 1e-12);
}

TEST(Friction, RemembersWhereItStuck) {
  // To and fro under constant pressure: the loop of an elastic, ideally plastic spring with bound 2.5.
  ContactSolver solver(rough(0.5));
  solver.set_faces(MatrixXd{{0.2, 0.0}, {0.0, 0.1}}, one(1.0));
  double stick = 0.0;
  for (const double s : {0.1, 0.4, 0.6, 0.5, 0.2, -0.3, -0.6, -0.5, 0.0, 0.7}) {
    double tau = -(s - stick) / 0.1;
    if (std::abs(tau) > 2.5) tau = std::copysign(2.5, tau);
    stick = s + 0.1 * tau;
    EXPECT_NEAR(solver.solve(one(-1.0), one(s)).shear_force[0], tau, 1e-12) << s;
    EXPECT_NEAR(solver.solve(one(-1.0), one(s)).shear_force[0], tau, 1e-12) << s;  // solving again moves nothing
    solver.accept();
  }
}

TEST(Friction, ManyPairsObeyTheLawInEachOfThem) {
  const int n = 30;
  MatrixXd F = MatrixXd::Zero(2 * n, 2 * n);
  F.topLeftCorner(n, n) = F.bottomRightCorner(n, n) = tests::face_flexibility(n);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      F(i, n + j) = 0.2e-10 * std::atan(0.5 * (i - j));
      F(n + j, i) = F(i, n + j);
    }
  }
  for (const ContactModel model : {ContactModel::exact, ContactModel::penalty}) {
    const double mu = 0.4, k = 1e12;
    ContactOptions options = rough(mu);
    options.model = model;
    options.initial_stiffness = k;
    ContactSolver solver(options);
    solver.set_faces(F, VectorXd::Constant(n, 0.5));
    const double softness = model == ContactModel::exact ? 0.0 : 1.0 / (k * 0.5);
    for (int step = 0; step < 20; ++step) {
      VectorXd gap(n), sliding(n);
      for (int i = 0; i < n; ++i) {
        gap[i] = 1e-3 * (std::sin(0.3 * step) + std::cos(0.2 * i));
        sliding[i] = 2e-4 * std::sin(0.1 * i + 0.5 * step);
      }
      const ContactResult result = solver.solve(gap, sliding);
      ASSERT_EQ(result.status, ContactStatus::converged) << step;
      VectorXd all(2 * n);
      all << result.pair_force, result.shear_force;
      const VectorXd moved = sliding + F.bottomRows(n) * all + softness * result.shear_force;
      const double scale = result.pair_force.maxCoeff();
      for (int i = 0; i < n; ++i) {
        EXPECT_LE(std::abs(result.shear_force[i]), mu * result.pair_force[i] + 1e-12 * scale);
        const bool slides = std::abs(result.shear_force[i]) > mu * result.pair_force[i] - 1e-9 * scale;
        if (slides) {
          EXPECT_LE(moved[i] * result.shear_force[i], 1e-12 * scale) << i;
        } else {
          EXPECT_NEAR(moved[i], 0.0, 1e-12) << i;  // stick point 0: nothing was accepted
        }
      }
      solver.forget();
    }
  }
}

TEST(Friction, SaysWhereItDoesNotConverge) {
  // μ F_nt > F_nn: pressing and sliding feed each other, no contraction.
  ContactOptions options = rough(2.0);
  options.friction_iterations = 30;
  ContactSolver solver(options);
  solver.set_faces(MatrixXd{{0.2, 0.19}, {0.19, 0.3}}, one(1.0));
  const ContactResult& result = solver.solve(one(-1.0), one(10.0));
  EXPECT_EQ(result.status, ContactStatus::friction_not_converged);
  EXPECT_TRUE(result.pair_force.allFinite());
  EXPECT_EQ(solver.solve(one(-1.0)).status, ContactStatus::unusable_input);  // the sliding is missing
}

}  // namespace
}  // namespace sunder::contact
