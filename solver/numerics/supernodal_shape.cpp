#include "solver/numerics/supernodal_shape.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

namespace sunder::numerics {
namespace {

/// Columns in which CHOLMOD counts when it joins small supernodes are nodes here.
struct NodesAsColumns {
  NodesAsColumns(cholmod_common& of, int block) : common(of) {
    for (int i = 0; i < 3; ++i) {
      columns[i] = common.nrelax[i];
      common.nrelax[i] /= static_cast<std::size_t>(block);
    }
  }
  ~NodesAsColumns() { std::copy_n(columns, 3, common.nrelax); }
  NodesAsColumns(const NodesAsColumns&) = delete;
  NodesAsColumns& operator=(const NodesAsColumns&) = delete;

  cholmod_common& common;
  std::size_t columns[3] = {};
};

std::span<const int> ints(const void* first, std::size_t count) {
  return {static_cast<const int*>(first), count};
}

/// values[i] -> block · values[i] … block · values[i] + block - 1
void expand(std::span<const int> values, int block, int* to) {
  for (const int value : values) {
    for (int k = 0; k < block; ++k) *to++ = block * value + k;
  }
}

void scale(std::span<const int> values, int factor, int* to) {
  for (const int value : values) *to++ = factor * value;
}

cholmod_factor* expanded(const cholmod_factor& nodes, int block, cholmod_common& common) {
  const auto b = static_cast<std::size_t>(block);
  cholmod_factor* factor = cholmod_allocate_factor(b * nodes.n, &common);
  if (factor == nullptr) return nullptr;
  factor->ordering = nodes.ordering;
  factor->is_ll = 1;
  factor->is_super = 1;
  factor->nsuper = nodes.nsuper;
  factor->ssize = b * nodes.ssize;
  factor->xsize = b * b * nodes.xsize;
  factor->maxcsize = b * b * nodes.maxcsize;
  factor->maxesize = b * nodes.maxesize;
  factor->super = cholmod_malloc(factor->nsuper + 1, sizeof(int), &common);
  factor->pi = cholmod_malloc(factor->nsuper + 1, sizeof(int), &common);
  factor->px = cholmod_malloc(factor->nsuper + 1, sizeof(int), &common);
  factor->s = cholmod_malloc(factor->ssize, sizeof(int), &common);
  if (common.status < CHOLMOD_OK) {
    cholmod_free_factor(&factor, &common);
    return nullptr;
  }
  expand(ints(nodes.Perm, nodes.n), block, static_cast<int*>(factor->Perm));
  scale(ints(nodes.super, nodes.nsuper + 1), block, static_cast<int*>(factor->super));
  scale(ints(nodes.pi, nodes.nsuper + 1), block, static_cast<int*>(factor->pi));
  scale(ints(nodes.px, nodes.nsuper + 1), block * block, static_cast<int*>(factor->px));
  expand(ints(nodes.s, nodes.ssize), block, static_cast<int*>(factor->s));
  // a column of c nodes is b columns, of b c, b c - 1, … entries
  auto* counts = static_cast<int*>(factor->ColCount);
  common.lnz = 0.0;
  for (const int count : ints(nodes.ColCount, nodes.n)) {
    for (int k = 0; k < block; ++k) common.lnz += * counts++ = block * count - k;
  }
  return factor;
}

}  // namespace

cholmod_factor* supernodal_shape(cholmod_sparse& graph, std::vector<int>& order, int block, cholmod_common& common) {
  cholmod_factor* nodes = nullptr;
  {
    const NodesAsColumns joined(common, block);
    nodes = cholmod_analyze_p(&graph, order.data(), nullptr, 0, &common);
  }
  if (nodes == nullptr || block == 1) return nodes;
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  const auto b = static_cast<std::uint64_t>(block);
  cholmod_factor* factor = nodes->xsize * b * b > most ? nullptr : expanded(*nodes, block, common);
  cholmod_free_factor(&nodes, &common);
  return factor;
}

}  // namespace sunder::numerics
