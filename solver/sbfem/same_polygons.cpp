#include <algorithm>

#include "solver/numerics/planted_fault.hpp"
#include "solver/sbfem/formation.hpp"

namespace sunder::sbfem {

std::vector<int> same_polygons(const mesh::NodalMesh& mesh, const mesh::NodalMesh& before,
                               std::span<const int> polygon_from) {
  std::vector<int> same(static_cast<std::size_t>(mesh.polygon_count()), -1);
  const bool trust_blindly = numerics::planted_fault("sbfem/stale-polygon");
  for (std::size_t i = 0; i < same.size() && i < polygon_from.size(); ++i) {
    const int from = trust_blindly ? static_cast<int>(i) : polygon_from[i];
    if (from < 0 || from >= before.polygon_count()) continue;
    const mesh::NodalPolygon a = mesh.polygon(static_cast<int>(i)), b = before.polygon(from);
    if (trust_blindly && a.nodes.size() == b.nodes.size()) {
      same[i] = from;
      continue;
    }
    if (a.open != b.open || !std::ranges::equal(a.orders, b.orders) || a.material != b.material ||
        a.scaling_centre != b.scaling_centre)
      continue;
    const bool places = std::ranges::equal(a.nodes, b.nodes, [&](int in_new, int in_old) {
      return mesh.coordinates().col(in_new) == before.coordinates().col(in_old);
    });
    if (places) same[i] = from;
  }
  return same;
}

}  // namespace sunder::sbfem
