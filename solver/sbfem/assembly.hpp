#pragma once
/// Global sparse matrices from the matrices of the polygons.
///
/// Degree of freedom 2 i + c is component c of node i. Only the lower triangle is stored, columns compressed, rows
/// ascending: what a sparse Cholesky factorisation reads. Work and memory grow with the number of entries. Every entry
/// is summed over its polygons in ascending order: the same bits for any number of threads.

#include <Eigen/SparseCore>

#include "solver/mesh/nodal_mesh.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/sbfem/formation.hpp"

namespace sunder::sbfem {

/// K (2 nodes, 2 nodes) [Pa], lower triangle.
Eigen::SparseMatrix<double> assemble_stiffness(const mesh::NodalMesh& mesh, const Formation& formation,
                                               numerics::ThreadPool* pool = nullptr);

/// M (2 nodes, 2 nodes) [kg/m], lower triangle. Throws std::invalid_argument where the formation was made without mass.
Eigen::SparseMatrix<double> assemble_mass(const mesh::NodalMesh& mesh, const Formation& formation,
                                          numerics::ThreadPool* pool = nullptr);

struct AssembledMatrices {
  Eigen::SparseMatrix<double> stiffness, mass;  ///< of one pattern
};

/// Both, the pattern found once. Throws as assemble_mass.
AssembledMatrices assemble(const mesh::NodalMesh& mesh, const Formation& formation,
                           numerics::ThreadPool* pool = nullptr);

}  // namespace sunder::sbfem
