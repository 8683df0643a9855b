#include "solver/numerics/symmetric_factor.hpp"

#include <cholmod.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "solver/numerics/factor_panels.hpp"
#include "solver/numerics/supernodal_shape.hpp"
#include "solver/numerics/supernodal_values.hpp"

namespace sunder::numerics {
namespace {

constexpr int nested_dissection_pays_from = 50'000;  // rows; measured, see the header

using Sparse = Eigen::SparseMatrix<double>;

cholmod_sparse view_of(const Sparse& lower) {
  cholmod_sparse view{};
  view.nrow = static_cast<size_t>(lower.rows());
  view.ncol = static_cast<size_t>(lower.cols());
  view.nzmax = static_cast<size_t>(lower.nonZeros());
  view.p = const_cast<int*>(lower.outerIndexPtr());
  view.i = const_cast<int*>(lower.innerIndexPtr());
  view.x = const_cast<double*>(lower.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

/// The graph of the nodes: one row for every `block` rows.
Sparse node_graph(const Sparse& lower, int block) {
  const int nodes = static_cast<int>(lower.rows()) / block;
  Sparse graph(nodes, nodes);
  std::vector<int> starts(nodes + 1, 0), neighbours;
  neighbours.reserve(static_cast<size_t>(lower.nonZeros()) / (block * block) + nodes);
  std::vector<int> last_seen(nodes, -1);
  for (int node = 0; node < nodes; ++node) {
    for (int column = node * block; column < (node + 1) * block; ++column) {
      for (Sparse::InnerIterator entry(lower, column); entry; ++entry) {
        const int neighbour = static_cast<int>(entry.row()) / block;
        if (neighbour >= node && last_seen[neighbour] != node) {
          last_seen[neighbour] = node;
          neighbours.push_back(neighbour);
        }
      }
    }
    std::sort(neighbours.begin() + starts[node], neighbours.end());
    starts[node + 1] = static_cast<int>(neighbours.size());
  }
  graph.resizeNonZeros(static_cast<Eigen::Index>(neighbours.size()));
  std::copy(starts.begin(), starts.end(), graph.outerIndexPtr());
  std::copy(neighbours.begin(), neighbours.end(), graph.innerIndexPtr());
  std::fill_n(graph.valuePtr(), neighbours.size(), 1.0);
  return graph;
}

}  // namespace

struct SymmetricFactor::Implementation {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  FactorPanels panels;
  PanelWork work;
  int rows = 0;
  FactorStatus status = FactorStatus::too_large;
  int failed_row = -1;

  Implementation() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.nmethods = 1;
    common.postorder = 1;
  }
  ~Implementation() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  std::vector<int> fill_reducing_order(cholmod_sparse& graph, const FactorOptions& options) {
    const bool dissect = options.ordering == Ordering::nested_dissection ||
                         (options.ordering == Ordering::automatic && rows >= nested_dissection_pays_from);
    std::vector<int> order(graph.nrow);
    const int ordered = dissect ? cholmod_metis(&graph, nullptr, 0, 1, order.data(), &common)
                                : cholmod_amd(&graph, nullptr, 0, order.data(), &common);
    if (!ordered) std::iota(order.begin(), order.end(), 0);
    return order;
  }

  void analyse(const Sparse& lower, const FactorOptions& options) {
    const Sparse nodes = options.block > 1 ? node_graph(lower, options.block) : Sparse();
    cholmod_sparse graph = view_of(options.block > 1 ? nodes : lower);
    std::vector<int> order = fill_reducing_order(graph, options);
    common.method[0].ordering = CHOLMOD_GIVEN;
    factor = supernodal_shape(graph, order, options.block, common);
  }

  void factorise(const Sparse& lower) {
    failed_row = -1;
    status = FactorStatus::too_large;
    if (factor == nullptr) return;
    if (factor->xtype == CHOLMOD_PATTERN) cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, factor, &common);
    if (factor->xtype != CHOLMOD_REAL) return;  // memory ran out
    const int failed = supernodal_values(lower, *factor);
    factor->minor = failed < 0 ? factor->n : static_cast<size_t>(failed);
    if (failed >= 0) {
      status = FactorStatus::not_positive_definite;
      failed_row = static_cast<const int*>(factor->Perm)[failed];
    } else {
      status = FactorStatus::factorised;
      invert_panels();
    }
  }

  /// The factor's numbers become those of `solve_with_panels`; its diagonal is then inverted.
  void invert_panels() {
    const auto list = [](const void* first, std::size_t size) {
      return std::span<const int>(static_cast<const int*>(first), size);
    };
    panels = {.first_column = list(factor->super, factor->nsuper + 1),
              .first_row = list(factor->pi, factor->nsuper + 1),
              .first_value = list(factor->px, factor->nsuper),
              .row = list(factor->s, factor->ssize),
              .order = list(factor->Perm, factor->n),
              .values = static_cast<double*>(factor->x)};
    invert_diagonal_blocks(panels);
  }
};

SymmetricFactor::SymmetricFactor(const Sparse& lower, const FactorOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  if (lower.rows() != lower.cols()) throw std::invalid_argument("SymmetricFactor: the matrix is not square");
  if (options.block < 1 || lower.rows() % options.block != 0) {
    throw std::invalid_argument("SymmetricFactor: rows must be a multiple of block >= 1");
  }
  if (!lower.isCompressed()) throw std::invalid_argument("SymmetricFactor: the matrix is not compressed");
  implementation_->rows = static_cast<int>(lower.rows());
  implementation_->analyse(lower, options);
  implementation_->factorise(lower);
}

SymmetricFactor::SymmetricFactor(SymmetricFactor&&) noexcept = default;
SymmetricFactor& SymmetricFactor::operator=(SymmetricFactor&&) noexcept = default;
SymmetricFactor::~SymmetricFactor() = default;

void SymmetricFactor::refactorise(const Sparse& lower) {
  implementation_->factorise(lower);
}

FactorStatus SymmetricFactor::status() const {
  return implementation_->status;
}
int SymmetricFactor::failed_row() const {
  return implementation_->failed_row;
}
int SymmetricFactor::rows() const {
  return implementation_->rows;
}

double SymmetricFactor::pivot_ratio() const {
  // a quotient of two entries of the diagonal: the same of their inverses
  return cholmod_rcond(implementation_->factor, &implementation_->common);
}

long long SymmetricFactor::entries() const {
  return implementation_->factor == nullptr ? 0 : static_cast<long long>(implementation_->common.lnz);
}

void SymmetricFactor::solve_in_place(Eigen::Ref<Eigen::MatrixXd> B) const {
  solve_with_panels(implementation_->panels, B, implementation_->work);
}

}  // namespace sunder::numerics
