#pragma once
/// Forces between the faces of a crack, as the equations of the whole body see them, and what they do at the tip.
///
/// A pair force y_i [N/m] pushes the two nodes of a pair apart along the pair's normal. Inside the tip polygon the
/// faces have no nodes: pressure there is linear, p(ξ) = y_a + y_b ξ from the tip (ξ = 0) to the last pair (ξ = 1), and
/// acts as the consistent loads of its two powers. The displacement conjugate to a force is loads' column · u: for a
/// pair its opening.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "solver/crack/crack_faces.hpp"
#include "solver/fracture/stress_intensity.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

/// K_I, K_II and T as linear functions of the body's displacement and of the pressure inside the tip polygon.
struct TipFactors {
  std::vector<int> dofs;             ///< (2k) of the body on the tip polygon's boundary
  Eigen::Matrix3Xd of_displacement;  ///< (3, 2k) [Pa √m / m], [Pa / m]
  Eigen::Matrix<double, 3, 2> of_pressure = Eigen::Matrix<double, 3, 2>::Zero();  ///< a unit of y_a, of y_b [√m], [-]
  Eigen::Vector3d of_constant_loads = Eigen::Vector3d::Zero();  ///< weight, given pressure on the faces [Pa √m], [Pa]
  mesh::Point position = mesh::Point::Zero();                   ///< of the tip [m]
  double direction = 0.0;                                       ///< of the crack there [rad]
  fracture::TipStatus status = fracture::TipStatus::ready;

  /// {K_I, K_II, T} for u (dofs) [m] and the pressures y_a, y_b [Pa].
  Eigen::Vector3d factors(const Eigen::Ref<const Eigen::VectorXd>& displacement, double y_a, double y_b) const;
};

struct CrackFaceLoads {
  crack::CrackPairs pairs;            ///< (n)
  Eigen::SparseMatrix<double> loads;  ///< (dofs, m): n pair forces; where there is a tip also y_a and y_b
  Eigen::VectorXd edge_share;         ///< (n) ∫ N_i ds over the edges of the faces, without the tip polygon [m]
  std::optional<TipFactors> tip;      ///< absent where the crack has ended at a face

  Eigen::Index count() const { return loads.cols(); }  ///< m
  /// (m): forces of a unit of uniform pressure.
  Eigen::VectorXd uniform_share() const;
};

/// Of body.polygons.cracks[crack]. `formation`: of the body's polygons. `scene` tells how the factors are read and what
/// acts inside the tip polygon for good: weight, and the pressure given with the crack; water that moves is not there.
[[nodiscard]] CrackFaceLoads crack_face_loads(const scene::Scene& scene, const Body& body,
                                              const sbfem::Formation& formation, int crack);

}  // namespace sunder::simulation
