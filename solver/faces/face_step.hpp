#pragma once
/// The forces between the faces of all cracks at the end of one time step: contact, water and the structure's own
/// answer, solved together.
///
/// Forces y (m) [N/m] act on the pairs of faces, positive where they push them apart, and, as resultants of pressure,
/// inside tip polygons. The structure, condensed to them once between two growth events, answers
///
///     v = v* + S y,    g = v at the pairs,    p = p* + R y
///
/// v: displacements conjugate to y [m], g: openings, p: pressures at the mouths [Pa]; a star: without these forces.
/// With the water's forces f(g, p) and contact forces λ
///
///     y = f + λ,    0 ≤ λ  ⊥  g + λ/(k L) ≥ 0,    k → ∞ for exact contact
///
/// k is a spring per area of face [N/m³], L the pairs' tributary lengths [m] [seed paper, Eq. (12)]. It enters as a
/// compliance, so a stiffer spring costs no factorisation and spoils no digit. Water pressure answers a closing face
/// with about rate²/aperture³ and may be a hundred times stiffer than the dam: taken from the step before, it would
/// make the step unstable. Newton's method on (g, λ, p) with the water's tangents, contact as a complementarity problem
/// in each iteration, halved steps where the residual does not fall; where that fails, the trial motion is reached in
/// several parts (continuation), each from the solution of the one before.
///
/// Accepted is what satisfies, with 0 ≤ scales from the trial motion,
///     1.  |g - g* - (S y)_g|∞ ≤ opening_tolerance · (|g*|∞ + 1 μm)     motion and water
///     2.  |p - p* - R y|∞ ≤ pressure_tolerance · (|p*|∞ + 1 kPa)       mouth
///     3.  |min(g + λ/(k L), λ S_ii)|∞ ≤ the bound of 1                 complementarity
///     4.  -g ≤ penetration_tolerance                                   with contact
/// and where the water's own solution was found: its balance then holds to round-off.

#include <Eigen/Core>
#include <Eigen/LU>
#include <memory>
#include <span>
#include <vector>

#include "solver/faces/complementarity.hpp"
#include "solver/faces/face_water.hpp"

namespace sunder::faces {

/// One crack's place among the forces.
struct CrackBlock {
  Eigen::Index first = 0;      ///< its first force
  Eigen::Index pairs = 0;      ///< forces first … first + pairs - 1 act on its pairs
  Eigen::Index forces = 0;     ///< of the block, >= pairs
  FaceWater* water = nullptr;  ///< nullptr: dry
};

/// The structure between two growth events.
struct FaceStructure {
  std::vector<CrackBlock> cracks;
  Eigen::MatrixXd answer;            ///< S (m, m) [m²/N], symmetric positive semidefinite
  Eigen::MatrixXd mouth;             ///< R (cracks, m) [1/m]
  Eigen::VectorXd tributary_length;  ///< L (pairs of all cracks, one after the other) [m], > 0
};

enum class ContactRule { none, penalty, exact };

struct FaceStepOptions {
  ContactRule contact = ContactRule::none;
  double initial_stiffness = 1e8;       ///< k [N/m³], > 0
  double growth_factor = 10.0;          ///< > 1
  double penetration_tolerance = 1e-4;  ///< [m], > 0
  double opening_tolerance = 1e-9;      ///< > 0
  double pressure_tolerance = 1e-9;     ///< > 0
  int max_iterations = 60;              ///< of Newton's method, each part of a continuation
  int max_halvings = 40;                ///< of a Newton step: a kink may lie 1e-12 of it away
};

enum class FaceStatus {
  solved,
  not_converged,  ///< the best answer is given; `residual` says how far it is off
};

struct FaceStepResult {
  FaceStatus status = FaceStatus::not_converged;
  Eigen::VectorXd force;             ///< y (m) [N/m]
  Eigen::VectorXd motion;            ///< v (m) [m]
  Eigen::VectorXd opening;           ///< g (pairs) [m]
  Eigen::VectorXd contact_force;     ///< λ (pairs) [N/m], >= 0
  Eigen::VectorXd mouth_pressure;    ///< p (cracks) [Pa]
  double stiffness = 0.0;            ///< the last k [N/m³]; 0 without penalty
  double largest_penetration = 0.0;  ///< max(-g, 0) [m]
  double residual = 0.0;             ///< of inequalities 1 … 3, as a multiple of their bounds
  int enlargements = 0, iterations = 0, water_trials = 0, parts = 0;
};

/// What one solve leaves for the next: its answer and the pairs that touched, from which the next one starts.
struct FaceStepMemory {
  Eigen::VectorXd force, motion, opening, contact_force, mouth_pressure;  ///< as in FaceStepResult
  std::vector<char> touching;                                             ///< (pairs)
  double stiffness = 0.0;                                                 ///< k [N/m³]
};

/// Solves step after step. Holds all memory: `solve` allocates nothing.
class FaceStep {
 public:
  /// Throws std::invalid_argument naming the value and its bound. The water objects must outlive the FaceStep.
  FaceStep(FaceStructure structure, const FaceStepOptions& options);

  /// `motion` v* (m) [m], `mouth_pressure` p* (cracks) [Pa], `time_step` [s] > 0. Starts from the last accepted answer.
  const FaceStepResult& solve(const Eigen::Ref<const Eigen::VectorXd>& motion,
                              const Eigen::Ref<const Eigen::VectorXd>& mouth_pressure, double time_step);

  /// The water of the last solve moves on.
  void accept();

  /// The answer from which the first solve starts, as after a growth event: openings and contact forces (pairs), k.
  void begin_with(const Eigen::Ref<const Eigen::VectorXd>& opening,
                  const Eigen::Ref<const Eigen::VectorXd>& contact_force, double stiffness);

  FaceStepMemory memory() const;
  /// Goes on as the FaceStep of the same structure that `memory` is of.
  void go_on(const FaceStepMemory& memory);

  const FaceStepResult& result() const { return result_; }
  const FaceStructure& structure() const { return structure_; }
  Eigen::Index pair_count() const { return static_cast<Eigen::Index>(rows_.size()); }

 private:
  struct Iterate {
    Eigen::VectorXd opening, contact, mouth;
  };

  bool newton(double time_step);
  void apply_water(const Iterate& at, double time_step);
  double merit(const Iterate& at);
  bool predict(const Iterate& at, Iterate& next);
  void couple_water(const Iterate& at);
  void press(std::span<const Eigen::Index> pairs);
  bool touch(Iterate& next);
  bool enlarge();
  double compliance(Eigen::Index pair) const;
  void finish();

  FaceStructure structure_;
  FaceStepOptions options_;
  std::vector<Eigen::Index> rows_;  // force of each pair
  std::vector<WaterForces> waters_;
  bool wet_ = false;
  bool water_found_ = true;  // by all waters at the place where they were applied last
  // for one solve: what is approached, and what the continuation has reached
  Eigen::VectorXd motion_, mouth_, motion_from_, mouth_from_, motion_goal_, mouth_goal_;
  Eigen::VectorXd force_, moved_;
  Iterate at_, trial_, next_, start_, safe_;
  double stiffness_ = 0.0, opening_bound_ = 1.0, pressure_bound_ = 1.0;
  // the linear problem of an iteration
  Eigen::MatrixXd coupled_, constrained_;
  Eigen::VectorXd right_, solution_, free_opening_;
  Eigen::MatrixXd force_by_lambda_;  // (m, pairs): y of a unit of each λ, the columns that `pressed_` says
  std::vector<char> pressed_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  ComplementarityProblem complementarity_;
  FaceStepResult result_;
};

}  // namespace sunder::faces
