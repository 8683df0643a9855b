#pragma once
/// Small polygons of equally many nodes, solved together: stiffness and mass as in polygon_solution.hpp and mass(),
/// each polygon in its own lane of the scalar S (numerics/lanes.hpp; `double` holds one polygon).
///
/// A lane takes its own shifts and stops at its own convergence, so that its result does not depend on its neighbours.

#include <span>
#include <vector>

#include "solver/sbfem/reference_edge.hpp"

namespace sunder::sbfem {

/// Moduli of the material of each lane: σ = D ε with D = [direct coupled 0; coupled direct 0; 0 0 shear].
template <class S>
struct BatchMaterial {
  S direct, coupled, shear;  ///< [Pa]
  S density;                 ///< [kg/m³]
};

/// Everything that solving a batch writes to; keep it for the next batch. N = 2 nodes, m = N - 2, matrices row-major.
template <class S>
struct PolygonBatch {
  int size = 0;         ///< N of the present batch
  std::vector<S> x, y;  ///< nodes relative to the scaling centre [m]
  BatchMaterial<S> material;
  std::vector<S> E0, F, E2;  ///< (N, N), F = E1ᵀ; scaled by solve()
  std::vector<S> scale;      ///< (N) P = diag(E0)^-1/2
  std::vector<S> K, M;       ///< (N, N) results, scaled: divide by scale_i scale_j for [Pa], [kg/m]
  S converged, iterations;   ///< 1 or 0; merges of rings
  S largest_exponent;        ///< estimate of λ_max

  std::vector<S> mirror, rate, e0, f, e2, A, B, C, Z, next, factor, inverse, vector;  // work

  explicit PolygonBatch(int largest_size);
};

/// E0, F, E2 of polygons that share the orders of their edges. `references[p]` is the edge of order p. J_b > 0 is not
/// asked.
template <class S>
void fill_coefficients(PolygonBatch<S>& batch, std::span<const int> orders, std::span<const ReferenceEdge> references);

/// K from E0, F, E2. Where `converged` is 0, K of that lane is not to be used.
template <class S>
void solve_stiffness(PolygonBatch<S>& batch);

/// M after solve_stiffness, for polygons that share the orders of their edges. Clears `converged` where the mass of a
/// translation is not density times area to 1e-6.
template <class S>
void solve_mass(PolygonBatch<S>& batch, std::span<const int> orders, std::span<const ReferenceEdge> references);

}  // namespace sunder::sbfem
