#include "solver/app/memory_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace sunder::app {

double factor_entries(double unknowns) {
  const double logarithm = std::log2(std::max(unknowns, 1.0));
  return 14.4 * unknowns * std::max(logarithm - 7.5, 0.0);
}

long long stiffness_entries(const mesh::NodalMesh& nodes) {
  std::vector<std::pair<int, int>> couples;
  for (int i = 0; i < nodes.polygon_count(); ++i) {
    const std::span<const int> list = nodes.polygon(i).nodes;
    for (int a : list)
      for (int b : list)
        if (a > b) couples.emplace_back(a, b);
  }
  std::sort(couples.begin(), couples.end());
  couples.erase(std::unique(couples.begin(), couples.end()), couples.end());
  return 4 * static_cast<long long>(couples.size()) + 3 * static_cast<long long>(nodes.node_count());
}

double memory_estimate(const mesh::NodalMesh& nodes) {
  constexpr double program_bytes = 55e6;  // its libraries, most of all gmsh
  constexpr double node_bytes = 1500.0;   // coordinates and indices, and the stiffness of half a hexagon
  const double entries = static_cast<double>(stiffness_entries(nodes));
  const double factor = std::max(factor_entries(2.0 * nodes.node_count()), entries);
  return program_bytes + node_bytes * nodes.node_count() + 24.0 * entries + 8.0 * factor;
}

}  // namespace sunder::app
