#pragma once
/// The ways to read stress intensity factors, as an option.

namespace sunder::fracture {

/// How K_I and K_II are read from a displacement. All but the last converge with the order 2p of the boundary.
enum class Extraction {
  reciprocity,        ///< default: Betti's theorem with Williams' exterior r^-½ fields; needs no exponents at all
  energy_projection,  ///< Williams' r^½ fields fitted to the singular modes in the energy of the polygon
  crack_opening_displacement,  ///< opening of the singular modes at the mouth
  m_integral,                  ///< interaction integral of the singular modes on the boundary
  pointwise_stress,            ///< the seed paper's; converges with order p only, offered for comparison
};

}  // namespace sunder::fracture
