/// What the water behind a dam costs before the first step: the weights of its convolution (n nodes, N steps), and the
/// mass of incompressible water. Answers are checked first: the weights sum to the mass of still water, and to the same
/// with one and two threads.

#include <benchmark/benchmark.h>

#include <cmath>

#include "solver/reservoir/added_mass.hpp"
#include "solver/reservoir/face_water.hpp"

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
