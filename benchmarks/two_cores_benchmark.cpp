/// Convolution and flux search on one and two threads, phase by phase.
///
/// A phase's wall time tells the speed-up that a user gets; its CPU time tells the work that sharing adds, and stays
/// meaningful on a machine that others use too: with t threads, CPU(1) / CPU(t) is the share of useful work, and the
/// speed-up on free cores is at most t times that. Answers are the same bits for both, which is checked before a time
/// is reported. Counters: <phase>_wall and <phase>_cpu [s] of one run, the least of the repetitions that Google
/// Benchmark makes within `wall`.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/pressure_tangent.hpp"
#include "solver/crackwater/segment_table.hpp"
#include "solver/numerics/stopwatch.hpp"
#include "solver/numerics/thread_pool.hpp"

namespace {

using namespace sunder;

/// Least wall and CPU time of each phase.
class Phases {
 public:
  template <class Work>
  void measure(const std::string& name, const Work& work) {
    const numerics::Stopwatch watch;
    work();
    const double wall = watch.wall(), cpu = watch.cpu();
    const auto known =
        std::find_if(phases_.begin(), phases_.end(), [&](const Phase& phase) { return phase.name == name; });
    if (known == phases_.end()) {
      phases_.push_back({name, wall, cpu});
    } else {
      known->wall = std::min(known->wall, wall);
      known->cpu = std::min(known->cpu, cpu);
    }
  }
  void report(benchmark::State& state) const {
    for (const Phase& phase : phases_) {
      state.counters[phase.name + "_wall"] = phase.wall;
      state.counters[phase.name + "_cpu"] = phase.cpu;
    }
  }

 private:
  struct Phase {
    std::string name;
    double wall, cpu;
  };
  std::vector<Phase> phases_;
};

convolution::WeightSequence fading_weights(int n, long long steps) {
  convolution::WeightSequence weights{n, false, Eigen::MatrixXd(Eigen::Index{n} * n, steps + 1)};
  for (long long j = 0; j <= steps; ++j) {
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        weights.values(Eigen::Index{column} * n + row, j) =
            std::exp(-0.002 * static_cast<double>(j)) * std::cos(0.1 * static_cast<double>(j) + std::abs(row - column));
      }
    }
  }
  return weights;
}

/// The force of the last step of a run under a known motion.
Eigen::VectorXd run(convolution::Convolution& medium, long long steps) {
  Eigen::VectorXd force(medium.size()), acceleration(medium.size());
  for (long long k = 0; k <= steps; ++k) {
    medium.history_force(force);
    for (Eigen::Index i = 0; i < acceleration.size(); ++i)
      acceleration[i] = std::sin(0.05 * static_cast<double>(k) + static_cast<double>(i));
    medium.append(acceleration);
  }
  return force;
}

/// range: threads; 60 degrees of freedom, 4000 steps.
void convolution_phases(benchmark::State& state) {
  constexpr int n = 60;
  constexpr long long steps = 4000;
  const convolution::WeightSequence weights = fading_weights(n, steps);
  convolution::BlockFft alone(weights, steps);
  const Eigen::VectorXd expected = run(alone, steps);
  numerics::ThreadPool pool(static_cast<int>(state.range(0)));
  Phases phases;
  for (auto _ : state) {
    std::unique_ptr<convolution::BlockFft> medium;
    phases.measure("transforms", [&] {
      medium = std::make_unique<convolution::BlockFft>(weights, steps, convolution::BlockFftOptions{.pool = &pool});
    });
    Eigen::VectorXd force;
    phases.measure("steps", [&] { force = run(*medium, steps); });
    if (force != expected) return state.SkipWithError("other bits than with one thread");
  }
  phases.report(state);
}

/// range: threads; 256 cracks of 450 segments, each thread its share.
void flux_search_phases(benchmark::State& state) {
  constexpr int cracks = 256, segments = 450;
  constexpr double expected = 146995198.365368616;  // N/m, closed form
  numerics::ThreadPool pool(static_cast<int>(state.range(0)));
  std::vector<double> apertures, rates;
  for (int i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / segments;
    apertures.push_back(0.10 - 0.05 * x);
    rates.push_back(-0.10 * (1.0 - x));
  }
  const crackwater::CrackLine line = crackwater::straight_crack(45.0, segments);
  std::vector<crackwater::SegmentTable> tables;
  std::vector<std::unique_ptr<crackwater::PressureSolver>> solvers;
  std::vector<crackwater::PressureTangent> tangents;
  for (int thread = 0; thread < pool.threads(); ++thread) {
    tables.emplace_back(line, crackwater::flow_law({}), crackwater::Quadrature::exact);
    solvers.push_back(std::make_unique<crackwater::PressureSolver>(line, crackwater::Water{}));
    tangents.emplace_back(segments);
  }
  std::vector<double> uplift(cracks);
  const auto each = [&](const auto& work) {
    pool.chunks(cracks, [&](int begin, int end, int thread) {
      for (int crack = begin; crack < end; ++crack) work(crack, static_cast<std::size_t>(thread));
    });
  };
  Phases phases;
  for (auto _ : state) {
    phases.measure("table", [&] {
      each([&](int, std::size_t thread) { benchmark::DoNotOptimize(tables[thread].fill(apertures, rates)); });
    });
    phases.measure("table_search_pressures", [&] {
      each([&](int crack, std::size_t thread) {
        uplift[static_cast<std::size_t>(crack)] =
            solvers[thread]->solve(apertures, rates, {490500.0, 0.0}).uplift_force;
      });
    });
    phases.measure("derivatives",
                   [&] { each([&](int, std::size_t thread) { differentiate(*solvers[thread], tangents[thread]); }); });
    for (const double value : uplift) {
      if (!(std::abs(value / expected - 1.0) <= 1e-12) || value != uplift.front())
        return state.SkipWithError("the uplift force misses its reference by more than 1e-12");
    }
  }
  phases.report(state);
}

BENCHMARK(convolution_phases)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(5)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(flux_search_phases)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(20)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
