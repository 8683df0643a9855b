/// What the water behind a dam costs before the first step: the weights of its convolution (n nodes, N steps), and the
/// mass of incompressible water; the phases of a run's convolution on one and two threads (wall seconds of weights,
/// transforms and history sums); and the memory of a few exponentials over a rigid bottom. Answers are checked first:
/// the weights sum to the mass of still water, and to the same with one and two threads; the forces of a sudden
/// constant acceleration to the sum of the weights.

#include <benchmark/benchmark.h>

#include <cmath>

#include "solver/convolution/block_fft.hpp"
#include "solver/numerics/stopwatch.hpp"
#include "solver/reservoir/added_mass.hpp"
#include "solver/reservoir/face_water.hpp"
#include "solver/reservoir/modal_exponentials.hpp"

namespace {

using namespace sunder;

reservoir::FaceModes modes_of(int n, double alpha) {
  return reservoir::face_modes(reservoir::pressure_mesh(reservoir::uniform_face(100.0, n / 2, 2), 100.0),
                               {.reflection_coefficient = alpha});
}

void weights(benchmark::State& state) {
  const reservoir::FaceModes modes = modes_of(static_cast<int>(state.range(0)), 0.75);
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  const long long steps = state.range(1);
  const convolution::WeightSequence once = reservoir::face_weights(modes, 0.01, steps, &pool);
  const double still = reservoir::face_response(modes, 0.0).mass.sum().real();
  // α^(T/2) of what is cut off, T = N c Δt / H
  const double rest = std::pow(0.75, 0.072 * static_cast<double>(steps));
  if (!(std::abs(once.values.sum() / still - 1.0) <= 1e-6 + 10.0 * rest))
    return state.SkipWithError("the weights do not sum to the mass of still water");
  for (auto _ : state) benchmark::DoNotOptimize(reservoir::face_weights(modes, 0.01, steps, &pool).values.data());
}

void modal_weights(benchmark::State& state) {
  const reservoir::FaceModes modes = modes_of(static_cast<int>(state.range(0)), 1.0);
  const convolution::WeightSequence once = reservoir::modal_weights(modes, 0.01, 100);
  const double first = 1000.0 * 1440.0 * 0.005 / std::hypot(1.0, 7.2 * std::sqrt(modes.wavenumber_squared[0]));
  if (!(std::abs(once.values(0, 0) / first - 1.0) <= 1e-12)) return state.SkipWithError("the first weight is wrong");
  for (auto _ : state) benchmark::DoNotOptimize(reservoir::modal_weights(modes, 0.01, state.range(1)).values.data());
}

void incompressible(benchmark::State& state) {
  const reservoir::Face face = reservoir::uniform_face(100.0, static_cast<int>(state.range(0)), 1);
  if (!(std::abs(reservoir::incompressible_mass(face, 97.3, 1000.0).sum() / (1000.0 * 97.3 * 97.3) - 0.5427545144) <=
        1e-7))
    return state.SkipWithError("the mass is not that of the closed form");
  for (auto _ : state) benchmark::DoNotOptimize(reservoir::incompressible_mass(face, 97.3, 1000.0).data());
}

/// Weights, spectra and the steps of one run. Half of the history sums is due at powers of two of the block.
void phases(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const long long steps = state.range(1);
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  const reservoir::FaceModes modes = modes_of(n, 0.75);
  for (auto _ : state) {
    const numerics::Stopwatch of_weights;
    const convolution::WeightSequence weights = reservoir::face_weights(modes, 0.01, steps, &pool);
    const double weight_seconds = of_weights.wall();
    const numerics::Stopwatch of_transforms;
    convolution::BlockFft water(weights, steps, {.block = 32, .pool = &pool});
    const double transform_seconds = of_transforms.wall();
    const Eigen::VectorXd push = Eigen::VectorXd::Ones(water.size());
    Eigen::VectorXd force(water.size());
    const numerics::Stopwatch of_sums;
    for (long long step = 0; step < steps; ++step) {
      water.history_force(force);
      water.append(push);
    }
    const double sum_seconds = of_sums.wall();
    water.history_force(force);
    Eigen::VectorXd exact = Eigen::VectorXd::Zero(water.size());
    for (long long j = 1; j <= steps; ++j) exact += weights.dense(j) * push;
    if (!((force - exact).norm() <= 1e-9 * exact.norm())) return state.SkipWithError("the forces are wrong");
    state.counters["weights_s"] = weight_seconds;
    state.counters["transforms_s"] = transform_seconds;
    state.counters["history_sums_s"] = sum_seconds;
  }
}

void rigid_bottom_memory(benchmark::State& state) {
  const long long steps = state.range(1);
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  const reservoir::FaceModes modes = modes_of(static_cast<int>(state.range(0)), 1.0);
  for (auto _ : state) {
    const numerics::Stopwatch of_set_up;
    const convolution::ExponentialSums sums = reservoir::modal_exponentials(modes, 0.01, steps, 1e-5, &pool);
    convolution::DiagonalStateSpace water(sums);
    const double set_up = of_set_up.cpu();
    const Eigen::VectorXd push = Eigen::VectorXd::Ones(water.size());
    Eigen::VectorXd force(water.size());
    const numerics::Stopwatch of_steps;
    for (long long step = 0; step < steps; ++step) {
      water.history_force(force);
      water.append(push);
    }
    const double seconds = of_steps.cpu();
    // the sum of the first million weights, one mode after the other, without keeping them
    water.history_force(force);
    for (Eigen::Index k = 0; k < water.size(); ++k) {
      const double t = 7.2 * std::sqrt(modes.wavenumber_squared[k]), x = (1.0 - t * t) / (1.0 + t * t);
      double now = 1.0, before = 0.0, sum = 0.0, size = 1.0;
      for (long long j = 0; j < steps; ++j) {
        const double order = static_cast<double>(j);
        const double next = ((2.0 * order + 1.0) * x * now - order * before) / (order + 1.0);
        before = now;
        now = next;
        sum += now + before;
        size += std::abs(now + before);
      }
      if (!(std::abs(force[k] / sums.mass[k] - sum) <= 1e-5 * size)) return state.SkipWithError("the forces are wrong");
    }
    if (!sums.within_tolerance) return state.SkipWithError("the tolerance is not met");
    state.counters["set_up"] = set_up;
    state.counters["per_step"] = seconds / static_cast<double>(steps);
    state.counters["stated"] = sums.error.relative;
    state.counters["numbers_per_mode"] = static_cast<double>(sums.decay.rows());
    state.counters["bytes"] = water.bytes();
  }
}

BENCHMARK(phases)
    ->ArgNames({"n", "N", "threads"})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->Args({20, 10'000, 1})
    ->Args({20, 10'000, 2})
    ->Args({60, 4000, 1})
    ->Args({60, 4000, 2});
BENCHMARK(rigid_bottom_memory)
    ->ArgNames({"n", "N", "threads"})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->Args({20, 10'000, 1})
    ->Args({20, 100'000, 1})
    ->Args({20, 1'000'000, 1})
    ->Args({20, 1'000'000, 2});
BENCHMARK(weights)
    ->ArgNames({"n", "N", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->Args({20, 1000, 1})
    ->Args({20, 1000, 2})
    ->Args({20, 10'000, 1})
    ->Args({60, 1000, 1})
    ->Args({60, 1000, 2});
BENCHMARK(modal_weights)->ArgNames({"n", "N"})->Unit(benchmark::kMillisecond)->Args({20, 1000})->Args({20, 100'000});
BENCHMARK(incompressible)->ArgNames({"elements"})->Unit(benchmark::kMillisecond)->Arg(10)->Arg(40);

}  // namespace

BENCHMARK_MAIN();
