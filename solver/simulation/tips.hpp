#pragma once
/// What is known at the crack tips of a static solution.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

#include "solver/fracture/stress_intensity.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"

namespace sunder::simulation {

struct TipResult {
  int tip = -1;          ///< index into the cracks of the body's polygons
  mesh::Point position;  ///< [m]
  fracture::TipState state;
  std::array<std::complex<double>, 2> exponents{};  ///< of the singular group; ½ each on a fine boundary
  fracture::TipStatus status = fracture::TipStatus::ready;
};

/// One a tip that has not ended at a face, in the order of the scene. `formation`: of the body's polygons;
/// `displacement` (dofs) [m].
[[nodiscard]] std::vector<TipResult> tip_results(const scene::Scene& scene, const Body& body,
                                                 const sbfem::Formation& formation,
                                                 const Eigen::VectorXd& displacement);

/// Opening at the mouth of each crack (inner: at its middle) along the normal of the faces [m]; negative: overlap.
[[nodiscard]] std::vector<double> mouth_openings(const scene::Scene& scene, const Body& body,
                                                 const Eigen::VectorXd& displacement);

}  // namespace sunder::simulation
