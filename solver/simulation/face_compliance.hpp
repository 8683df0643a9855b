#pragma once
/// The body as its crack faces feel it: which motion pairs of forces across the cracks cause, and how far they open
/// them.
///
/// With B the pair operator (opening = Bᵀ u, pair forces λ act as B λ) and K̂ the factorised matrix of the body, static
/// stiffness or effective matrix of a time step,
///
///     X = K̂⁻¹ B,      F = Bᵀ X,      u = u⁰ + X λ,      opening = Bᵀ u⁰ + F λ
///
/// once a factorisation; after it contact and water are problems of the faces alone. X is kept (dofs · pairs numbers:
/// 4 MB for the Koyna section with 100 pairs), so that the accepted motion costs a product instead of a second
/// back-substitution, and the motion and F belong to each other to round-off.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "solver/crack/crack_faces.hpp"
#include "solver/numerics/symmetric_factor.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

/// The pairs of all cracks, one crack after the other.
struct FacePairs {
  crack::CrackPairs pairs;  ///< `position` counts anew on each crack; `tip_position` has no meaning here
  std::vector<int> crack;   ///< (n): index in body.polygons.cracks, one a tip

  int count() const { return pairs.count(); }
};

/// The middle of an inner crack, from which the faces to both its tips run, is one pair with the lengths of both.
[[nodiscard]] FacePairs face_pairs(const mesh::PolygonMesh& polygons, const mesh::NodalMesh& nodes);

/// B (dofs, n): column i is the normal of pair i at its upper node and minus the normal at its lower one. With
/// `tangential` (dofs, 2n): the second half likewise along the crack, t = (n_y, -n_x), the direction of `sliding`.
[[nodiscard]] Eigen::SparseMatrix<double> pair_operator(const crack::CrackPairs& pairs, Eigen::Index dofs,
                                                        bool tangential);

struct FaceCompliance {
  Eigen::SparseMatrix<double> B;  ///< (dofs, m)
  Eigen::MatrixXd X;              ///< (dofs, m) [m²/N], zero at prescribed dofs
  Eigen::MatrixXd F;              ///< (m, m) [m²/N], symmetric
};

/// `factor`: of the matrix whose rows of prescribed dofs are those of the identity, times any number (see
/// constraints.hpp); `fixed` (dofs): 1 there. Precondition: the factor is ready. O(m) back-substitutions, in blocks.
[[nodiscard]] FaceCompliance face_compliance(const numerics::SymmetricFactor& factor, Eigen::SparseMatrix<double> B,
                                             std::span<const char> fixed);

}  // namespace sunder::simulation
