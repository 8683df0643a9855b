#pragma once
/// Coefficient matrices of a polygon: its geometry and material, integrated along the boundary.
///
/// With x = ξ x_b(η) from the scaling centre, J_b = x_b y_b' - y_b x_b' > 0 and
///     b1 = (1/J_b) [y_b' 0; 0 -x_b'; -x_b' y_b'],  b2 = (1/J_b) [-y_b 0; 0 x_b; x_b -y_b],  B1 = b1 N,  B2 = b2 N':
///     E0 = ∫ B1ᵀ D B1 J_b dη,  E1 = ∫ B2ᵀ D B1 J_b dη,  E2 = ∫ B2ᵀ D B2 J_b dη,  M0 = ∫ ρ Nᵀ N J_b dη
/// the displacements obey E0 ξ² u'' + (E0 - E1 + E1ᵀ) ξ u' - E2 u = 0 [Song 2018, Eq. (2.118)].

#include <Eigen/Core>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::sbfem {

/// The boundary of one polygon seen from its scaling centre.
struct Boundary {
  Eigen::Matrix2Xd nodes;   ///< (2, n) [m], relative to the scaling centre, counter-clockwise
  std::vector<int> orders;  ///< polynomial order of each edge; sum = n where closed, n - 1 where open
  bool open = false;        ///< a crack polygon: first node on the lower face, last on the upper
};

Boundary boundary_of(const mesh::NodalMesh& mesh, int polygon);

struct Coefficients {
  Eigen::MatrixXd E0, E1, E2;  ///< (2n, 2n) [Pa]; degrees of freedom x0 y0 x1 y1 …
  Eigen::MatrixXd M0;          ///< (2n, 2n) [kg/m]; empty where the density is 0
};

/// Straight edges of order p are integrated exactly with p + 1 Gauss points.
/// Throws std::invalid_argument naming the edge where J_b <= 0: the centre does not see that edge from inside.
Coefficients coefficients(const Boundary& boundary, const material::Isotropic& material);

}  // namespace sunder::sbfem
