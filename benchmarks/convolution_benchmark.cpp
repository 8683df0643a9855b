/// What a convolution costs, by every method, at N = 1e3, 1e4, 1e5 steps and n = 20, 60, 120 degrees of freedom.
///
/// The weights fade like water behind a dam (damped Bessel functions in mixed modes). Every run compares its forces
/// with the plain sum at steps spread over the whole history before its time counts: 1e-12 of the largest force for
/// exact methods, the stated error for the state space. `set_up` and `per_step` are CPU seconds; `ratio` is the plain
/// sum's time over the method's, set-up included, `ratio_steps` without. The plain sum is timed on its last steps of a
/// full history: a step is one product over all earlier accelerations, so the run is exactly half of N such steps; its
/// time is that, extrapolated. `gflops` of the blocked sum stand beside those of Eigen's product of two 512 x 512
/// matrices. A method whose memory would pass 6 GB is left out, by name.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <tuple>

#include "solver/convolution/block_fft.hpp"
#include "solver/convolution/direct_sum.hpp"
#include "solver/convolution/state_space.hpp"
#include "solver/numerics/stopwatch.hpp"

namespace {

using namespace sunder;
using convolution::WeightSequence;

constexpr double most_bytes = 6e9;

struct Problem {
  WeightSequence weights;
  Eigen::MatrixXd acceleration;
  double plain_seconds = 0.0;                   // of the whole run, extrapolated
  std::map<long long, Eigen::VectorXd> forces;  // at some steps, summed directly
  double largest = 0.0;
};

WeightSequence fading_weights(int n, long long steps) {
  std::mt19937_64 generator(5);
  Eigen::MatrixXd mix(n, n);
  for (double& x : mix.reshaped()) x = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
  WeightSequence weights{n, false, Eigen::MatrixXd::Zero(Eigen::Index{n} * n, steps + 1)};
  Eigen::VectorXd d(n);
  for (long long j = 0; j <= steps; ++j) {
    const double t = 0.144 * static_cast<double>(j);
    const double fade = std::exp(-0.144 * t);  // 0.75^(t/2)
    if (fade < 1e-17) break;                   // zero to round-off: still as many products for the exact methods
    for (int k = 0; k < n; ++k) d[k] = fade * ::j0((k + 0.5) * 3.14159265358979 * t) / (k + 0.5);
    weights.values.col(j) = (mix * d.asDiagonal() * mix.transpose()).reshaped();
  }
  return weights;
}

Problem& problem(int n, long long steps) {
  static std::map<std::pair<int, long long>, std::unique_ptr<Problem>> all;
  std::unique_ptr<Problem>& found = all[{n, steps}];
  if (found != nullptr) return *found;
  all.clear();  // one at a time: they are large
  std::unique_ptr<Problem>& made = all[{n, steps}];
  made = std::make_unique<Problem>();
  made->weights = fading_weights(n, steps);
  std::mt19937_64 generator(9);
  made->acceleration.resize(n, steps + 1);
  for (double& x : made->acceleration.reshaped()) x = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
  convolution::DirectSum plain(made->weights, steps);
  Eigen::VectorXd force(n);
  double seconds = 0.0;
  int timed = 0;
  for (long long k = 0; k <= steps; ++k) {
    const bool sample = k > 0 && (k % std::max<long long>(steps / 40, 1) == 0 || k > steps - 3);
    if (sample) {
      const numerics::Stopwatch watch;
      plain.history_force(force);
      if (k > steps - 3) seconds += watch.cpu(), ++timed;
      made->forces[k] = force;
      made->largest = std::fmax(made->largest, force.cwiseAbs().maxCoeff());
    }
    plain.append(made->acceleration.col(k));
  }
  made->plain_seconds = 0.5 * seconds / timed * static_cast<double>(steps);
  return *made;
}

/// Largest error at the sampled steps, of the largest force; the run's CPU seconds.
std::pair<double, double> run(const Problem& p, convolution::Convolution& water) {
  Eigen::VectorXd force(p.weights.size);
  double error = 0.0;
  auto next = p.forces.begin();
  const numerics::Stopwatch watch;
  for (Eigen::Index k = 0; k < p.acceleration.cols(); ++k) {
    water.history_force(force);
    water.append(p.acceleration.col(k));
    if (next != p.forces.end() && next->first == k) {
      error = std::fmax(error, (force - next->second).cwiseAbs().maxCoeff());
      ++next;
    }
  }
  return {error / p.largest, watch.cpu()};
}

template <class Make>
void measure(benchmark::State& state, double bytes, double allowed, const Make& make) {
  const int n = static_cast<int>(state.range(0));
  const long long steps = state.range(1);
  if (bytes > most_bytes) return state.SkipWithError("needs more than 6 GB");
  const Problem& p = problem(n, steps);
  for (auto _ : state) {
    const numerics::Stopwatch watch;
    auto [water, stated] = make(p);
    const double set_up = watch.cpu();
    const auto [error, seconds] = run(p, *water);
    if (!(error <= std::fmax(allowed, stated))) return state.SkipWithError("the forces are wrong");
    state.counters["error"] = error;
    state.counters["stated"] = stated;
    state.counters["set_up"] = set_up;
    state.counters["per_step"] = seconds / static_cast<double>(steps);
    state.counters["ratio"] = p.plain_seconds / (set_up + seconds);
    state.counters["ratio_steps"] = p.plain_seconds / seconds;
    state.counters["plain_seconds"] = p.plain_seconds;
    state.counters["gflops"] =
        1e-9 * static_cast<double>(n) * n * static_cast<double>(steps) * static_cast<double>(steps) / seconds;
  }
}

double weight_bytes(const benchmark::State& state) {
  const double n = static_cast<double>(state.range(0)), N = static_cast<double>(state.range(1));
  return 8.0 * n * n * N;
}

using Made = std::pair<std::unique_ptr<convolution::Convolution>, double>;

void block_fft(benchmark::State& state) {
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  measure(state, 4.0 * weight_bytes(state), 1e-12, [&](const Problem& p) {
    return Made(std::make_unique<convolution::BlockFft>(p.weights, state.range(1),
                                                        convolution::BlockFftOptions{.block = 32, .pool = &pool}),
                0.0);
  });
}

void blocked_direct(benchmark::State& state) {
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  measure(state, 2.0 * weight_bytes(state), 1e-12, [&](const Problem& p) {
    return Made(std::make_unique<convolution::DirectSum>(p.weights, state.range(1),
                                                         convolution::DirectOptions{.block = 32, .pool = &pool}),
                0.0);
  });
}

/// Reduced from the weights that are not zero.
void state_space(benchmark::State& state) {
  numerics::ThreadPool pool(static_cast<int>(state.range(2)));
  measure(state, 2.0 * weight_bytes(state), 0.0, [&](const Problem& p) {
    const long long kept = std::min<long long>(state.range(1), 700);
    const convolution::StateSpaceModel model =
        convolution::reduce(convolution::truncated(p.weights, kept), {.tolerance = 1e-4, .pool = &pool});
    // beyond `kept` the weights are below 1e-6 of the first; the certificate counts them as an error of the model
    const convolution::KernelError error = convolution::certify(model, p.weights, &pool);
    state.counters["states"] = static_cast<double>(model.decay.size());
    // the error of the force is at most error.absolute times the largest acceleration √n
    const double stated = error.absolute * std::sqrt(static_cast<double>(p.weights.size)) / p.largest;
    state.counters["stated_relative"] = error.relative;
    return Made(std::make_unique<convolution::StateSpace>(model), stated);
  });
}

void matrix_product(benchmark::State& state) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(512, 512), b = Eigen::MatrixXd::Random(512, 512);
  Eigen::MatrixXd c(512, 512);
  const numerics::Stopwatch watch;
  for (auto _ : state) {
    c.noalias() = a * b;
    benchmark::DoNotOptimize(c.data());
  }
  state.counters["gflops"] = 2.0 * std::pow(512.0, 3) * static_cast<double>(state.iterations()) * 1e-9 / watch.cpu();
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"n", "N", "threads"})->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const auto& [n, N] :
       {std::pair{20, 1000}, {20, 10'000}, {60, 1000}, {60, 10'000}, {120, 1000}, {120, 10'000}, {20, 100'000}})
    for (const int threads : {1, 2}) b->Args({n, N, threads});
}

/// The blocked sum at N = 1e5 takes minutes: it stays quadratic.
void shorter_sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"n", "N", "threads"})->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const auto& [n, N] : {std::pair{20, 1000}, {20, 10'000}, {60, 1000}, {120, 1000}})
    for (const int threads : {1, 2}) b->Args({n, N, threads});
}

BENCHMARK(matrix_product);
BENCHMARK(blocked_direct)->Apply(shorter_sizes);
BENCHMARK(block_fft)->Apply(sizes);
BENCHMARK(state_space)->Apply([](benchmark::internal::Benchmark* b) {
  b->ArgNames({"n", "N", "threads"})->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const int N : {1000, 10'000, 100'000})
    for (const int threads : {1, 2}) b->Args({20, N, threads});
});

}  // namespace

BENCHMARK_MAIN();
