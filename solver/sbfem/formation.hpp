#pragma once
/// Stiffness and mass of every polygon of a mesh.
///
/// Small polygons with the same orders along their edges are solved four at a time (polygon_batch.hpp), large ones one
/// by one with blocked matrix products. Which polygons share a batch depends on the mesh alone: the results have the
/// same bits for any number of threads.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "solver/material/isotropic.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::sbfem {

struct FormationOptions {
  Route route = Route::ring_doubling;
  bool with_mass = false;                ///< M as well; a material without density then gives M = 0
  numerics::ThreadPool* pool = nullptr;  ///< nullptr: the calling thread alone
  int largest_batched_size = 64;  ///< polygons of at most so many degrees of freedom are solved four at a time, >= 0
};

/// What became of the polygons, worst first.
struct FormationSummary {
  PolygonStatus worst_status = PolygonStatus::converged;
  int worst_polygon = -1;          ///< the first polygon of the worst status, -1 where all have converged
  int failed_count = 0;            ///< polygons that have not converged; their K and M are NaN
  double largest_asymmetry = 0.0;  ///< of the routes that have any, ‖K - Kᵀ‖ / ‖K‖
  int most_iterations = 0;
  int reused_count = 0;  ///< polygons taken over from an earlier formation
};

class Formation {
 public:
  using ConstMap = Eigen::Map<const Eigen::MatrixXd>;

  int polygon_count() const { return static_cast<int>(sizes_.size()); }
  bool has_mass() const { return !mass_.empty(); }
  int size(int polygon) const { return sizes_[static_cast<std::size_t>(polygon)]; }  ///< 2n
  ConstMap stiffness(int polygon) const { return map(stiffness_, polygon); }         ///< K (2n, 2n) [Pa], symmetric
  ConstMap mass(int polygon) const { return map(mass_, polygon); }                   ///< M (2n, 2n) [kg/m], symmetric
  PolygonStatus status(int polygon) const { return statuses_[static_cast<std::size_t>(polygon)]; }
  const FormationSummary& summary() const { return summary_; }

 private:
  friend struct FormationAccess;
  ConstMap map(const std::vector<double>& values, int polygon) const {
    const int N = size(polygon);
    return {values.data() + offsets_[static_cast<std::size_t>(polygon)], N, N};
  }

  std::vector<double> stiffness_, mass_;  // column-major blocks, one after the other
  std::vector<std::size_t> offsets_;
  std::vector<int> sizes_;
  std::vector<PolygonStatus> statuses_;
  std::vector<double> asymmetries_;
  std::vector<int> iterations_;
  FormationSummary summary_;
};

/// `materials[i]` is the material of the polygons that name i.
/// Throws std::invalid_argument where a material is missing or out of range, and where the scaling centre of a polygon
/// does not see one of its edges from inside (J_b <= 0), naming the polygon and the edge.
Formation form(const mesh::NodalMesh& mesh, std::span<const material::Isotropic> materials,
               const FormationOptions& options = {});

/// For each polygon of `mesh` the polygon of `before` that is the same: orders, places of the nodes, scaling centre and
/// material, bit for bit; -1 where there is none. Only the pairs that `polygon_from` (polygons; -1: none) suggests are
/// looked at. O(nodes).
[[nodiscard]] std::vector<int> same_polygons(const mesh::NodalMesh& mesh, const mesh::NodalMesh& before,
                                             std::span<const int> polygon_from);

/// form() where most polygons are those of an earlier formation, made with the same materials and options: polygon i is
/// taken over from polygon `same[i]` of `earlier`, or formed where that is -1. The same bits as forming all anew, for
/// the cost of the new ones. Throws std::invalid_argument as form(), and where sizes or the presence of a mass do not
/// match.
Formation form_again(const mesh::NodalMesh& mesh, std::span<const material::Isotropic> materials,
                     const FormationOptions& options, const Formation& earlier, std::span<const int> same);

}  // namespace sunder::sbfem
