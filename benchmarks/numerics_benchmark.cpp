/// Time of factorising a sparse stiffness matrix and of one back-substitution: SymmetricFactor with both orderings,
/// CHOLMOD without supernodes and Eigen's Cholesky factorisation. Every benchmark checks its residual before it reports
/// a time.

#include <benchmark/benchmark.h>
#include <cholmod.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "solver/numerics/symmetric_factor.hpp"

namespace {

using namespace sunder::numerics;
using Sparse = Eigen::SparseMatrix<double>;

/// Stiffness of a bilinear square of side 1 with E = 1 and ν = 0, by 2 x 2 Gauss points; nodes counter-clockwise.
Eigen::Matrix<double, 8, 8> stiffness_of_square() {
  const double gauss = 0.5 / std::sqrt(3.0);
  const Eigen::Vector3d moduli(1.0, 1.0, 0.5);
  Eigen::Matrix<double, 8, 8> stiffness = Eigen::Matrix<double, 8, 8>::Zero();
  for (const double x : {-gauss, gauss}) {
    for (const double y : {-gauss, gauss}) {
      Eigen::Matrix<double, 3, 8> strain = Eigen::Matrix<double, 3, 8>::Zero();
      for (int i = 0; i < 4; ++i) {
        const double side_x = i == 1 || i == 2 ? 1.0 : -1.0, side_y = i >= 2 ? 1.0 : -1.0;
        strain(0, 2 * i) = strain(2, 2 * i + 1) = side_x * (0.5 + side_y * y);
        strain(1, 2 * i + 1) = strain(2, 2 * i) = side_y * (0.5 + side_x * x);
      }
      stiffness += 0.25 * strain.transpose() * moduli.asDiagonal() * strain;
    }
  }
  return stiffness;
}

/// Stiffness of m x m such squares on springs along one side, as its lower triangle: two unknowns a node, nodes coupled
/// to their eight neighbours like those of a polygon mesh.
Sparse stiffness_of_grid(int m) {
  const Eigen::Matrix<double, 8, 8> square = stiffness_of_square();
  const int side = m + 1, dofs = 2 * side * side;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(m) * m * 36 + dofs);
  for (int row = 0; row < m; ++row) {
    for (int column = 0; column < m; ++column) {
      const int corner = row * side + column;
      const int nodes[] = {corner, corner + 1, corner + side + 1, corner + side};
      for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
          const int a = 2 * nodes[i / 2] + i % 2, b = 2 * nodes[j / 2] + j % 2;
          if (a >= b) entries.emplace_back(a, b, square(i, j));
        }
      }
    }
  }
  for (int dof = 0; dof < 2 * side; ++dof) entries.emplace_back(dof, dof, 1.0);
  Sparse lower(dofs, dofs);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// ‖K x - b‖ / (‖K‖ ‖x‖): the backward error, some ε for every stable factorisation.
bool is_solved(const Sparse& lower, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  const double error = (lower.selfadjointView<Eigen::Lower>() * x - b).norm();
  return error < 1e-13 * lower.norm() * x.norm();
}

/// CHOLMOD with AMD and without supernodes, through its own interface.
class SimplicialCholmod {
 public:
  explicit SimplicialCholmod(const Sparse& lower) {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = const_cast<int*>(lower.outerIndexPtr());
    view.i = const_cast<int*>(lower.innerIndexPtr());
    view.x = const_cast<double*>(lower.valuePtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.sorted = view.packed = 1;
    factor_ = cholmod_analyze(&view, &common_);
    cholmod_factorize(&view, factor_, &common_);
  }
  ~SimplicialCholmod() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  SimplicialCholmod(const SimplicialCholmod&) = delete;
  SimplicialCholmod& operator=(const SimplicialCholmod&) = delete;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) {
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, &right, &common_);
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution->x), b.size());
    cholmod_free_dense(&solution, &common_);
    return x;
  }

 private:
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

class Supernodal {
 public:
  Supernodal(const Sparse& lower, Ordering ordering) : factor_(lower, {.ordering = ordering, .block = 2}) {}
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = b;
    if (factor_.status() == FactorStatus::factorised) factor_.solve_in_place(x);
    return x;
  }

 private:
  SymmetricFactor factor_;
};

struct MinimumDegree : Supernodal {
  explicit MinimumDegree(const Sparse& lower) : Supernodal(lower, Ordering::minimum_degree) {}
};
struct NestedDissection : Supernodal {
  explicit NestedDissection(const Sparse& lower) : Supernodal(lower, Ordering::nested_dissection) {}
};
using EigenCholesky = Eigen::SimplicialLLT<Sparse>;

template <class Factor>
void factorise(benchmark::State& state) {
  const Sparse lower = stiffness_of_grid(static_cast<int>(state.range(0)));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 2.0);
  if (!is_solved(lower, Factor(lower).solve(b), b)) return state.SkipWithError("wrong solution");
  for (auto _ : state) benchmark::DoNotOptimize(std::make_unique<Factor>(lower));
  state.counters["dofs"] = static_cast<double>(lower.rows());
}

template <class Factor>
void back_substitute(benchmark::State& state) {
  const Sparse lower = stiffness_of_grid(static_cast<int>(state.range(0)));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.rows(), -1.0, 2.0);
  Factor factor(lower);
  if (!is_solved(lower, factor.solve(b), b)) return state.SkipWithError("wrong solution");
  for (auto _ : state) benchmark::DoNotOptimize(Eigen::VectorXd(factor.solve(b)).data());
  state.counters["dofs"] = static_cast<double>(lower.rows());
}

double least(const std::vector<double>& times) {
  return *std::ranges::min_element(times);
}

/// 39 and 223 squares a side: 3 200 and 100 352 unknowns.
void both_sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(39)
      ->Arg(223)
      ->Repetitions(3)
      ->ReportAggregatesOnly()
      ->ComputeStatistics("min", least)
      ->MeasureProcessCPUTime()
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(factorise, MinimumDegree)->Apply(both_sizes);
BENCHMARK_TEMPLATE(factorise, NestedDissection)->Apply(both_sizes);
BENCHMARK_TEMPLATE(factorise, SimplicialCholmod)->Apply(both_sizes);
BENCHMARK_TEMPLATE(factorise, EigenCholesky)->Apply(both_sizes);
BENCHMARK_TEMPLATE(back_substitute, MinimumDegree)->Apply(both_sizes);
BENCHMARK_TEMPLATE(back_substitute, NestedDissection)->Apply(both_sizes);
BENCHMARK_TEMPLATE(back_substitute, SimplicialCholmod)->Apply(both_sizes);
BENCHMARK_TEMPLATE(back_substitute, EigenCholesky)->Apply(both_sizes);

}  // namespace

BENCHMARK_MAIN();
