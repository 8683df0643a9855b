#pragma once
/// The shape of a supernodal Cholesky factor of a matrix whose rows come in blocks of one sparsity pattern.
///
/// A block of b unknowns of one node is one row of the graph of nodes. CHOLMOD's analysis of that graph (elimination
/// tree, column counts, supernodes) reads b² times fewer entries, and the factor of the matrix has the same supernodes,
/// b columns and b rows for each of the graph's.

#include <cholmod.h>

#include <Eigen/SparseCore>
#include <vector>

namespace sunder::numerics {

/// Factor without values. `graph` (nodes, nodes): lower triangle, one entry a pair of coupled nodes; `order` (nodes): a
/// fill-reducing order. `common.lnz` becomes the number of entries of the factor. nullptr where memory ran out or the
/// factor has more than 2³¹ - 1 entries.
[[nodiscard]] cholmod_factor* supernodal_shape(cholmod_sparse& graph, std::vector<int>& order, int block,
                                               cholmod_common& common);

}  // namespace sunder::numerics
