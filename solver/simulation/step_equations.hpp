#pragma once
/// The equations of motion of the body between two growth events, ready to be stepped: one factorisation, one
/// back-substitution a step.
///
///     M a + C v + K u + Σ R(a) = f,    C = α M + β K
///
/// in the one-step schemes of dynamics/time_scheme.hpp, for the change d = u' - u of a step. R are the forces of
/// attached media (module convolution): their instantaneous mass W_0 belongs to the matrix, their history to the load.
/// Displacements that supports prescribe are constant; there d = v = a = 0.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "solver/dynamics/rayleigh.hpp"
#include "solver/dynamics/time_scheme.hpp"
#include "solver/numerics/node_products.hpp"
#include "solver/numerics/symmetric_factor.hpp"
#include "solver/simulation/attached_medium.hpp"
#include "solver/simulation/constraints.hpp"

namespace sunder::simulation {

struct MotionState {
  double time = 0.0;                                     ///< [s]
  Eigen::VectorXd displacement, velocity, acceleration;  ///< (dofs) [m], [m/s], [m/s²], relative to the ground
};

struct StepOptions {
  dynamics::TimeScheme scheme;
  double time_step = 0.0;  ///< [s], > 0
  dynamics::Rayleigh damping;
};

/// Forces at one end of a step (dofs) [N/m], and the acceleration of the ground that carries the supports.
struct StepLoad {
  Eigen::VectorXd force;  ///< on the body, without those of the media and between crack faces
  Eigen::Vector2d ground = Eigen::Vector2d::Zero();  ///< [m/s²]; the inertia -M r a_g is added by the step
};

/// Of the motion at a step's end, all the products that the step after it and the energy account need.
struct MotionProducts {
  numerics::VectorPair stiffness;  ///< K u and K (u + β w), w: what the velocity is without d [N/m]
  numerics::VectorPair mass;       ///< M v and M q, q: all that the mass acts on without d [kg/s], [N/m]
};

class StepEquations {
 public:
  /// `stiffness`, `mass`: lower triangles (dofs, dofs). The media must outlive the equations and have the weights of
  /// this time step.
  StepEquations(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass,
                const Constraints& constraints, std::span<const AttachedMedium* const> media,
                const StepOptions& options);

  numerics::FactorStatus status() const { return factor_.status(); }
  long long factor_entries() const { return factor_.entries(); }
  const StepOptions& options() const { return options_; }

  /// What constant unit forces at the end of a step, the columns of `loads` (dofs, m), add to d: X (dofs, m) [m²/N].
  Eigen::MatrixXd answer(const Eigen::SparseMatrix<double>& loads) const;

  /// The next step begins at `state`: a new run, or one whose motion was changed between two steps. Allocates nothing
  /// after the first call.
  void stand_at(const MotionState& state);

  /// d (dofs) without what the forces between crack faces at the end of the step add. `start` and `end` hold the loads
  /// at both ends; `start.force` includes the forces between crack faces there. `state` is where the equations stand;
  /// the histories of the media must be those of the coming step. Allocates nothing.
  const Eigen::VectorXd& trial(const MotionState& state, const StepLoad& start, const StepLoad& end);

  /// Velocity and acceleration at the end of a step with the change d, and the time. `next` may not be `state`.
  void advance(const MotionState& state, const Eigen::VectorXd& d, MotionState& next) const;

  /// A body that rests at time 0 in ground that accelerates at once: its first acceleration, (M + ΣW_0) a = -(M r +
  /// ΣW_0 r) a_g, goes into `state` and to the media. Nothing happens where `ground` is 0. Allocates.
  void begin(MotionState& state, const Eigen::Vector2d& ground, std::span<AttachedMedium* const> media);

  /// d a / d d: the acceleration that a unit of d adds [1/s²].
  double acceleration_factor() const;

  /// Ends the step and stands at its end: the media take the accelerations; their forces R at its end become those of
  /// the next start.
  void accept(const MotionState& next, const Eigen::Vector2d& ground, std::span<AttachedMedium* const> media);

  /// Σ W_j a_{n-j}, j >= 1, plus W_0 times the ground's share, of the coming step, for medium `i` (n): set by `trial`.
  const Eigen::VectorXd& medium_history(std::size_t i) const { return histories_[i]; }

  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }  ///< lower, as given
  const Eigen::SparseMatrix<double>& mass() const { return mass_; }            ///< lower, as given
  /// Of the state where the equations stand, and of the one where they stood before.
  const MotionProducts& products() const { return now_; }
  const MotionProducts& products_before() const { return before_; }
  const Constraints& constraints() const { return *constraints_; }
  std::span<const AttachedMedium* const> media() const { return media_; }

  /// M r a_g (dofs) [N/m].
  Eigen::VectorXd ground_load(const Eigen::Vector2d& ground) const { return ground_mass_.transpose() * ground; }
  const Eigen::Matrix2Xd& ground_mass() const { return ground_mass_; }  ///< (2, dofs): M r_x, M r_y [kg/m]
  /// Δuᵀ (R_before + R) [J/m] on medium `i` with its force R at the end of the last accepted step.
  double work_on_medium(std::size_t i, const Eigen::VectorXd& moved, const Eigen::VectorXd& before) const;

  /// Forces of the media at the end of the last accepted step, one after the other; to go on with in the equations
  /// after a growth event.
  const std::vector<Eigen::VectorXd>& medium_forces() const { return medium_forces_; }
  void begin_with(const std::vector<Eigen::VectorXd>& medium_forces) { medium_forces_ = medium_forces; }

 private:
  void hold(Eigen::VectorXd& values) const;
  bool stands_at(const MotionState& state) const;

  StepOptions options_;
  Eigen::SparseMatrix<double> stiffness_, mass_;
  const Constraints* constraints_;
  std::vector<int> held_;  // the prescribed dofs
  numerics::NodeProducts products_;
  std::vector<const AttachedMedium*> media_;
  numerics::SymmetricFactor factor_;
  Eigen::Matrix2Xd ground_mass_;
  numerics::VectorPair with_stiffness_, with_mass_;  // what the products are of
  MotionProducts now_, before_;
  Eigen::VectorXd d_;
  std::vector<Eigen::VectorXd> histories_, medium_forces_;
  std::vector<Eigen::VectorXd> medium_work_, medium_answer_;  // an acceleration, W_0 times it
};

}  // namespace sunder::simulation
