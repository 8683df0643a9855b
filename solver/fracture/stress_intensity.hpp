#pragma once
/// Stress intensity factors and T-stress of a crack polygon.

#include <Eigen/Core>

#include "solver/material/isotropic.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace sunder::fracture {

struct StressIntensityFactors {
  double K_I = 0.0;   ///< [Pa √m], negative where the faces overlap
  double K_II = 0.0;  ///< [Pa √m]
};

enum class Extraction {
  energy_projection,           ///< default: Williams' fields fitted in the energy of the polygon
  crack_opening_displacement,  ///< cheapest
  m_integral,                  ///< interaction integral on the boundary
  pointwise_stress,            ///< the seed paper's; slow to converge, offered for comparison
};

}  // namespace sunder::fracture
