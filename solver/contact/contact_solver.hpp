#pragma once
/// Contact of crack faces: which pairs of opposite points press on each other, and how strongly.
///
/// The body is known by its flexibility alone. With g⁰ the gap of n pairs without contact [m] (negative: the faces
/// would penetrate each other; whatever else acts, water for one, is in it) and F (n, n) the gap that unit pair forces
/// open [m²/N], the gap is
///
///     g = g⁰ + F λ,      λ ≥ 0 pair forces [N/m], positive where the faces press
///
///   exact    0 ≤ λ ⊥ g ≥ 0                                          Signorini
///   penalty  λ_i = k L_i max(0, -g_i), L_i the tributary length; k grows from `initial_stiffness` by
///            `growth_factor` until the largest penetration is within its tolerance       [seed paper, Eq. (12)]
///
/// The penalty is solved in its flexibility form 0 ≤ λ ⊥ g + λ/(k L) ≥ 0: both models are one complementarity problem,
/// of F and of F + diag(1/(k L)). So a larger k costs no factorisation of the body and makes nothing ill-conditioned:
/// the limit k → ∞ is the exact model, its error is λ/(k L), and k = 1e24 N/m³ is as accurate as 1e10.
/// The method, and why it ends, is in contact/bounded_minimum.hpp; it cannot chatter between states.
///
/// Friction [Coulomb]: |τ| ≤ μ λ; where the pair slides, τ opposes it with μ λ; where not, the sliding since the stick
/// point p stays zero (penalty: -τ/(k L)). F is then (2n, 2n), normal pairs first, and s = s⁰ + F_s (λ, τ). The stick
/// points move only in `accept`, so that a time step may be solved again and again before it is accepted. Each solve is
/// a sequence of problems with given bounds μ λ [Panagiotopoulos 1975]: every one has a solution and ends; the sequence
/// converges where the coupling of λ and τ times μ is a contraction (a straight crack between like materials has next
/// to no coupling); steps are halved when they grow; and where it does not converge the status says so.

#include <Eigen/Core>

#include "solver/contact/bounded_minimum.hpp"

namespace sunder::contact {

enum class ContactModel { penalty, exact };

struct ContactOptions {
  ContactModel model = ContactModel::penalty;
  double initial_stiffness = 1e8;       ///< k of the first solve [N/m³], > 0
  double growth_factor = 10.0;          ///< of k [-], > 1
  double maximum_stiffness = 1e24;      ///< [N/m³], ≥ initial_stiffness
  double penetration_tolerance = 1e-4;  ///< largest -g accepted [m], > 0; in the exact model it only proves the gate
  double friction_coefficient = 0.0;    ///< μ [-], ≥ 0
  double friction_tolerance = 1e-10;    ///< change of the bounds μ λ ≤ tolerance · largest of them, > 0
  int friction_iterations = 200;        ///< ≥ 1
};

enum class ContactStatus {
  converged,              ///< and the largest penetration is within its tolerance
  penetration_too_large,  ///< k would exceed `maximum_stiffness`
  no_solution,            ///< the faces cannot part: forces grow without end (prescribed motions press them together)
  friction_not_converged,
  not_converged,   ///< round-off used up the pivots or, in the exact model, exceeds the tolerance
  unusable_input,  ///< g⁰ or s⁰ has a wrong length or is not finite: nothing is changed
};

struct ContactResult {
  ContactStatus status = ContactStatus::converged;
  double stiffness = 0.0;  ///< k at the end [N/m³]; 0 in the exact model
  int enlargements = 0;    ///< of k in this solve
  int iterations = 0;      ///< steps of the active set, over all k
  int friction_iterations = 0;
  int closed = 0;                    ///< pairs with λ > 0
  Eigen::VectorXd pair_force;        ///< λ (n) [N/m], ≥ 0
  Eigen::VectorXd gap;               ///< g (n) [m]
  Eigen::VectorXd shear_force;       ///< τ (n) [N/m] along the crack, on the upper face; empty without friction
  double largest_penetration = 0.0;  ///< max(0, -g_i) [m], from g = g⁰ + F λ
  double largest_tension = 0.0;      ///< max(0, -λ_i) [N/m]: 0 by construction
  double complementarity = 0.0;  ///< max |λ_i (g_i + λ_i/(k L_i))| / max λ [m]: what separates it from a solution
};

/// Throws std::invalid_argument naming the value and its bound.
void check(const ContactOptions& options);

/// Solves the contact of the same faces again and again, each time from the answer before: its pairs, and its k, which
/// never shrinks.
class ContactSolver {
 public:
  explicit ContactSolver(const ContactOptions& options = {});  ///< throws as `check`

  /// The faces, at the start and whenever the body or its cracks have changed: F (n, n), with friction (2n, 2n), and
  /// the tributary lengths L (n) [m], ≥ 0 (a pair without length has no spring). n = 0 is allowed. Forgets pairs and
  /// stick points, keeps k. Throws std::invalid_argument where shapes do not fit, a value is not finite, a length or a
  /// diagonal entry is negative, or |F_ij - F_ji| > 1e-6 √(F_ii F_jj). Allocates; nothing after it does.
  void set_faces(const Eigen::Ref<const Eigen::MatrixXd>& F, const Eigen::Ref<const Eigen::VectorXd>& tributary_length);

  /// g⁰ (n) [m]; with friction also s⁰ (n) [m], the sliding without contact. Never throws or allocates.
  const ContactResult& solve(const Eigen::Ref<const Eigen::VectorXd>& gap) noexcept;
  const ContactResult& solve(const Eigen::Ref<const Eigen::VectorXd>& gap,
                             const Eigen::Ref<const Eigen::VectorXd>& sliding) noexcept;

  /// Moves the stick points to where the last solve left the faces. Without friction it does nothing.
  void accept() noexcept;

  /// Overwrites each column of `change`, a change of g⁰ (n) or, with friction, of g⁰ and s⁰ (2n), with the change of λ
  /// (and τ) that follows: dλ_A = -(F + 1/(k L))_AA⁻¹ dg_A on the pairs in contact, 0 elsewhere, at constant k. Where a
  /// pair just touches it is the derivative of one side. With friction sliding pairs keep dτ = ±μ dλ, by the iteration
  /// of the solve; false where that did not converge. Allocates nothing.
  bool differentiate(Eigen::Ref<Eigen::MatrixXd> change) noexcept;

  void forget();  ///< the next solve starts cold: no pair in contact, k at `initial_stiffness`; stick points stay

  const ContactResult& result() const { return result_; }
  const ContactOptions& options() const { return options_; }
  int pairs() const { return n_; }

 private:
  bool with_friction() const { return options_.friction_coefficient > 0.0; }
  void set_stiffness(double k);
  const ContactResult& solve_prepared() noexcept;
  MinimumStatus solve_at_stiffness() noexcept;
  MinimumStatus settle_friction() noexcept;
  void read_answer() noexcept;
  void answer_of_free() noexcept;
  double sliding_sign(int pair) const noexcept;

  ContactOptions options_;
  int n_ = 0;
  double stiffness_ = 0.0;
  bool friction_settled_ = true;
  Eigen::MatrixXd F_;
  Eigen::VectorXd length_, softness_;                    ///< L; 1/(k L), (n) or (2n)
  Eigen::VectorXd load_, lower_, upper_;                 ///< g⁰ (and s⁰ - p), bounds of λ (and τ)
  Eigen::VectorXd bound_, stick_, work_;                 ///< μ λ (n); p (n); (n) or (2n)
  Eigen::VectorXd free_change_, change_, bound_change_;  ///< for differentiate: (n) or (2n), likewise, (n)
  BoundedMinimum minimum_;
  ContactResult result_;
};

}  // namespace sunder::contact
