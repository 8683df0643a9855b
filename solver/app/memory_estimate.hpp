#pragma once
/// How much memory a run will need, before it needs it.

#include "solver/mesh/nodal_mesh.hpp"

namespace sunder::app {

/// Entries of the Cholesky factor of a plane mesh with n unknowns, two a node: 14.4 n (log₂ n - 7.5). The law is that
/// of nested dissection, 31/2 n log₂ n to leading order [George 1973]; both constants fit SymmetricFactor::entries() on
/// hexagonal meshes of order 1 from 800 to 980 000 unknowns to 4 %.
[[nodiscard]] double factor_entries(double unknowns);

/// Entries of the lower triangle of the stiffness matrix: two unknowns a node, nodes coupled where they share a
/// polygon.
[[nodiscard]] long long stiffness_entries(const mesh::NodalMesh& nodes);

/// Bytes at the peak of a static run: the program with its libraries, mesh and polygons, the stiffness matrix (12 bytes
/// an entry, twice while it is assembled) and its factor (8 bytes an entry). Meant to a factor of two; on Koyna
/// sections of order 1, 2754 and 41636 polygons, it says 76 and 427 MB where the program peaks at 76 and 439 MB.
[[nodiscard]] double memory_estimate(const mesh::NodalMesh& nodes);

}  // namespace sunder::app
