#pragma once
/// Degrees of freedom whose displacement is known beforehand, and what they do to the equations.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::simulation {

/// Degree of freedom 2·node + component (0: x, 1: y).
struct Constraints {
  std::vector<char> fixed;       ///< (dofs): 1 where the displacement is prescribed
  Eigen::VectorXd displacement;  ///< (dofs) [m]: the prescribed value, 0 elsewhere

  explicit Constraints(int dofs) : fixed(dofs, 0), displacement(Eigen::VectorXd::Zero(dofs)) {}
  void prescribe(int dof, double value) {
    fixed[dof] = 1;
    displacement[dof] = value;
  }
};

/// Eliminates the prescribed displacements in place: their columns go to the right side, their rows become
/// `scale`·u = `scale`·prescribed. The pattern stays. `lower` (n, n) is the lower triangle, `force` (n).
void eliminate(const Constraints& constraints, double scale, Eigen::SparseMatrix<double>& lower,
               Eigen::VectorXd& force);

/// The same for a mass matrix of homogeneous constraints: rows and columns become zero.
void remove_inertia(const Constraints& constraints, Eigen::SparseMatrix<double>& lower_mass);

/// Numbers the parts of the body that hang together by shared nodes: the part of each node, and how many there are.
std::vector<int> parts_of(const mesh::NodalMesh& mesh, int& count);

/// A rigid motion that the constraints leave to a part of the body.
struct FreeMotion {
  mesh::Point somewhere;  ///< a node of that part [m]
  int motions = 0;        ///< how many independent ones: 1 … 3
};

/// The parts of the body (polygons joined by nodes) that can still move rigidly; empty where none can.
std::vector<FreeMotion> free_motions(const mesh::NodalMesh& mesh, const Constraints& constraints);

}  // namespace sunder::simulation
