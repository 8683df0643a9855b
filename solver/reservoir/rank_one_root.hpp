#pragma once
/// The inverse square root of a diagonal matrix plus a complex multiple of a dyad, as the bottom of the reservoir makes
/// it.
///
///     (diag(d) + σ b bᵀ + S² I)^-½ = Σ_j v_j v_jᵀ / √(S² + μ_j)
///
/// μ_j are the roots of 1 + σ Σ_i b_i² / (d_i - μ) = 0 and v_j has the components n_j b_i / (d_i - μ_j), n_j such that
/// v_jᵀ v_j = 1. All roots are improved together [Aberth 1973], from those of the last call: along a contour two or
/// three rounds suffice, O(m²) each. In terms of μ_j - d_j, which keeps its digits when σ is small.

#include <Eigen/Core>
#include <complex>

namespace sunder::reservoir {

class RankOneRoot {
 public:
  /// `d` (m) ascending, distinct; `b` (m).
  RankOneRoot(Eigen::VectorXd d, Eigen::VectorXd b);

  /// Roots and vectors of σ. `fresh`: starts anew instead of from the last σ. Where the roots fail their check (Σ μ_j =
  /// Σ d_i + σ bᵀb and Σ (bᵀv_j)² = bᵀb, both to 1e-9) the eigenvectors of the full matrix are taken instead.
  void decompose(std::complex<double> sigma, bool fresh);

  const Eigen::VectorXcd& values() const { return mu_; }        ///< μ (m)
  const Eigen::MatrixXcd& vectors() const { return vectors_; }  ///< (m, m), v_jᵀ v_j = 1
  int rounds() const { return rounds_; }                        ///< of the last decomposition
  bool from_full_matrix() const { return full_; }               ///< the last one was

 private:
  bool improve(std::complex<double> sigma);
  bool form_vectors(std::complex<double> sigma);
  void take_full_matrix(std::complex<double> sigma);

  Eigen::VectorXd d_, b_, b2_;
  Eigen::VectorXcd shift_, mu_;  // μ_j - d_j
  Eigen::MatrixXcd vectors_;
  int rounds_ = 0;
  bool full_ = false;
};

}  // namespace sunder::reservoir
