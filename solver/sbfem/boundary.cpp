#include "solver/sbfem/coefficients.hpp"

namespace sunder::sbfem {

Boundary boundary_of(const mesh::NodalMesh& mesh, int polygon) {
  const mesh::NodalPolygon source = mesh.polygon(polygon);
  Boundary boundary;
  boundary.nodes.resize(2, static_cast<Eigen::Index>(source.nodes.size()));
  for (std::size_t i = 0; i < source.nodes.size(); ++i) {
    boundary.nodes.col(static_cast<Eigen::Index>(i)) = mesh.coordinates().col(source.nodes[i]) - source.scaling_centre;
  }
  boundary.orders.assign(source.orders.begin(), source.orders.end());
  boundary.open = source.open;
  return boundary;
}

}  // namespace sunder::sbfem
