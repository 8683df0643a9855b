#pragma once
/// Cholesky factorisation of a sparse symmetric positive definite matrix, made once and solved with many times.
///
/// CHOLMOD's supernodal factorisation, solved with by partitioned inverses (factor_panels.hpp). Nodes with two unknowns
/// each are ordered as one (half the graph, a fraction of the ordering time); approximate minimum degree below 50 000
/// rows, METIS nested dissection above. Which ordering wins depends on the mesh: of polygons with six sides METIS
/// took 3.8 s instead of 5.9 s at 4e5 rows, of bilinear squares at 1e5 rows it is the slower one
/// (benchmarks/numerics_benchmark), so the threshold is a guard for large meshes.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace sunder::numerics {

enum class FactorStatus {
  factorised,
  not_positive_definite,  ///< `failed_row` of the matrix is where the pivot was not positive
  too_large,              ///< more than 2³¹ - 1 entries in the factor, or memory ran out
};

enum class Ordering { automatic, minimum_degree, nested_dissection };

struct FactorOptions {
  Ordering ordering = Ordering::automatic;
  int block = 1;  ///< rows i·block … i·block + block - 1 belong to one node and share its sparsity pattern
};

class SymmetricFactor {
 public:
  /// Factorises. `lower` (n, n) holds the lower triangle, compressed; entries above the diagonal are not read.
  explicit SymmetricFactor(const Eigen::SparseMatrix<double>& lower, const FactorOptions& options = {});
  SymmetricFactor(SymmetricFactor&&) noexcept;
  SymmetricFactor& operator=(SymmetricFactor&&) noexcept;
  ~SymmetricFactor();

  /// Factorises a matrix of the same pattern and options again; the ordering is kept.
  void refactorise(const Eigen::SparseMatrix<double>& lower);

  FactorStatus status() const;
  int failed_row() const;      ///< row of the first pivot that is not positive, -1 where there is none
  double pivot_ratio() const;  ///< (smallest / largest pivot of L)², a cheap lower estimate of 1 / condition
  long long entries() const;   ///< entries of the factor L
  int rows() const;

  /// Overwrites B (n, m), or a vector b (n), with A⁻¹ B. Precondition: status() == factorised. Allocates nothing after
  /// the first call with the same m.
  void solve_in_place(Eigen::Ref<Eigen::MatrixXd> B) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace sunder::numerics
