// Unbounded rock: what its stiffness and its weights cost. Every answer is checked before a time is reported.

#include <benchmark/benchmark.h>

#include <cmath>

#include "solver/foundation/impulse_response.hpp"
#include "solver/foundation/rock_weights.hpp"

namespace {

using namespace sunder;

constexpr material::Isotropic rock{.youngs_modulus = 2.5, .poisson_ratio = 0.25, .density = 1.0};  // G = c_s = 1

/// Sides and bottom of a block 2 x 1 with linear elements of length 1/k: 2 (4 k + 1) unknowns.
foundation::UnboundedDomain block(int k) {
  sbfem::Boundary line;
  line.open = true;
  line.orders.assign(static_cast<std::size_t>(4 * k), 1);
  line.nodes.resize(2, 4 * k + 1);
  for (int i = 0; i <= 4 * k; ++i) {
    const double s = static_cast<double>(i) / k;
    line.nodes.col(i) = s <= 1.0   ? Eigen::Vector2d(-1.0, -s)
                        : s <= 3.0 ? Eigen::Vector2d(s - 2.0, -1.0)
                                   : Eigen::Vector2d(1.0, s - 4.0);
  }
  return foundation::unbounded_domain(sbfem::coefficients(line, rock));
}

double horizontal(const Eigen::MatrixXd& matrix) {
  double sum = 0.0;
  for (Eigen::Index j = 0; j < matrix.cols(); j += 2)
    for (Eigen::Index i = 0; i < matrix.rows(); i += 2) sum += matrix(i, j);
  return sum;
}

/// n, N: weights of N steps of 0.05 b/c_s; W_N / Δt must be M(N Δt) to second order.
void BM_Weights(benchmark::State& state) {
  const foundation::UnboundedDomain domain = block(static_cast<int>(state.range(0)));
  const auto last = state.range(1);
  constexpr double dt = 0.05;
  const std::vector<double> end{dt * static_cast<double>(last)};
  const double exact = horizontal(foundation::impulse_response(domain, end).M[0]);
  double found = 0.0;
  for (auto _ : state) {
    const foundation::RockWeights weights = foundation::rock_weights(domain, dt, last);
    if (weights.path.status != foundation::StiffnessStatus::converged) return state.SkipWithError("not converged");
    found = horizontal(weights.weights.dense(last)) / dt;
    state.counters["steps"] = static_cast<double>(weights.path.steps);
  }
  if (!(std::abs(found - exact) <= 1e-5 * exact)) return state.SkipWithError("W_N is not M(t)");
  state.counters["n"] = static_cast<double>(domain.size());
}
BENCHMARK(BM_Weights)->Args({4, 1000})->Args({8, 250})->Args({8, 1000})->Args({8, 4000})->Unit(benchmark::kMillisecond);

/// n, N: the march in time, the second route.
void BM_March(benchmark::State& state) {
  const foundation::UnboundedDomain domain = block(static_cast<int>(state.range(0)));
  const auto count = static_cast<int>(state.range(1));
  constexpr double dt = 0.05;
  const std::vector<double> end{dt * count};
  const double exact = horizontal(foundation::impulse_response(domain, end).M[0]);
  double found = 0.0;
  for (auto _ : state) {
    const foundation::ImpulseSamples samples = foundation::march_impulse_response(domain, dt, count);
    if (samples.status != foundation::StiffnessStatus::converged) return state.SkipWithError("not converged");
    found = horizontal(samples.M.back());
  }
  if (!(std::abs(found - exact) <= 1e-3 * exact)) return state.SkipWithError("M is not that of the first route");
  state.counters["n"] = static_cast<double>(domain.size());
}
BENCHMARK(BM_March)->Args({4, 250})->Args({8, 250})->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
