/// What crack water costs: the seed paper's 45 m crack by every search and rule, long cracks, a marched step, many
/// cracks.
///
/// Every run checks its answer against the closed form before its time counts. `evaluations` are friction gradients of
/// segments that the searches visited in one solve, beside its time; a solve that allocates is an error.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "solver/crackwater/filling_march.hpp"
#include "solver/crackwater/pressure_profile.hpp"
#include "solver/crackwater/pressure_tangent.hpp"
#include "solver/numerics/tests/allocation_count.hpp"

namespace {

using namespace sunder::crackwater;
using sunder::numerics::allocations;

constexpr double head = 490500.0;  // Pa
constexpr int reference_segments = 450;

struct Motion {
  std::vector<double> apertures, rates;
};

Motion reference_motion(int segments, double rate) {
  Motion motion;
  for (int i = 0; i <= segments; ++i) {
    const double x = static_cast<double>(i) / segments;
    motion.apertures.push_back(0.10 - 0.05 * x);
    motion.rates.push_back(rate * (1.0 - x));
  }
  return motion;
}

struct Case {
  const char* name;
  double rate;                     // m/s at the upstream mouth
  double uplift, midpoint_uplift;  // N/m: closed form; midpoint scheme with 450 segments
};
constexpr Case cases[] = {{"opening", 0.10, 1233201.40063765116, 1233302.073280455},
                          {"static", 0.0, 14715000.0, 14714975.777837213},
                          {"closing", -0.10, 146995198.365368616, 146994000.725856}};
constexpr const char* search_names[] = {"bisection", "itp", "toms748", "newton", "prefix_moments"};

bool right(benchmark::State& state, double uplift, double expected) {
  const bool good = std::abs(uplift / expected - 1.0) <= 1e-12;
  if (!good) state.SkipWithError("the uplift force misses its reference by more than 1e-12");
  return good;
}

void solve(benchmark::State& state, const Case& c, Search search, Quadrature quadrature) {
  PressureSolver solver(straight_crack(45.0, reference_segments), {}, {.quadrature = quadrature, .search = search});
  const Motion motion = reference_motion(reference_segments, c.rate);
  const PressureProfile& p = solver.solve(motion.apertures, motion.rates, {head, 0.0});
  if (!right(state, p.uplift_force, quadrature == Quadrature::exact ? c.uplift : c.midpoint_uplift)) return;
  const long before = allocations;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force);
  if (allocations - before > 4) state.SkipWithError("a solve allocated");  // the harness itself allocates a few times
  state.counters["residuals"] = p.residual_evaluations;
  state.counters["evaluations"] = static_cast<double>(p.gradient_evaluations);
}

/// One sweep: the time of a gradient evaluation is that over 450 ("items").
void sweep(benchmark::State& state, double flux) {
  SegmentTable table(straight_crack(45.0, reference_segments), flow_law({}), Quadrature::exact);
  const Motion motion = reference_motion(reference_segments, -0.10);
  if (!table.fill(motion.apertures, motion.rates)) return state.SkipWithError("unusable input");
  const double at_root = head - table.loss(-1.65874217599189056, 0, reference_segments, false).value;
  if (!(std::abs(at_root) <= 1e-12 * 2.0 * 4.3e6)) return state.SkipWithError("the pressures are not met at the root");
  for (auto _ : state) {
    benchmark::DoNotOptimize(flux);
    benchmark::DoNotOptimize(table.loss(flux, 0, reference_segments, false).value);
  }
  state.SetItemsProcessed(state.iterations() * reference_segments);
}

void length(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0));
  PressureSolver solver(straight_crack(45.0, segments), {});
  const Motion motion = reference_motion(segments, -0.10);
  if (!right(state, solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force, cases[2].uplift)) return;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force);
  state.SetComplexityN(segments);
}

void tangent(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0));
  PressureSolver solver(straight_crack(45.0, segments), {});
  PressureTangent derivatives(segments);
  const Motion motion = reference_motion(segments, -0.10);
  if (!right(state, solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force, cases[2].uplift)) return;
  differentiate(solver, derivatives);
  // A shift of all pressures by the mouths' shifts the forces by the length of the crack.
  const Eigen::Index last = derivatives.nodal_force.cols() - 1;
  const double shift = derivatives.nodal_force.rightCols(2).sum();
  if (!(std::abs(shift / 45.0 - 1.0) <= 1e-10) || last < 1) return state.SkipWithError("mouth pressures do not add up");
  for (auto _ : state) {
    differentiate(solver, derivatives);
    benchmark::DoNotOptimize(derivatives.pressure.data());
  }
}

/// What one iteration of a step coupled with the structure asks for: pressures and their derivatives.
void solve_and_tangent(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0)) - 1;
  PressureSolver solver(straight_crack(45.0, segments), {});
  PressureTangent derivatives(segments);
  const Motion motion = reference_motion(segments, -0.10);
  if (!right(state, solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force, cases[2].uplift)) return;
  const long before = allocations;
  for (auto _ : state) {
    (void)solver.solve(motion.apertures, motion.rates, {head, 0.0});
    differentiate(solver, derivatives);
    benchmark::DoNotOptimize(derivatives.nodal_force.data());
  }
  if (allocations - before > 4) state.SkipWithError("a solve or its tangent allocated");
}

/// The same of a march: a trial step and its derivatives, half of the crack full.
void trial_and_tangent(benchmark::State& state) {
  const int segments = static_cast<int>(state.range(0)) - 1;
  const std::vector<double> apertures(static_cast<std::size_t>(segments) + 1, 0.001);
  FillingMarch march(straight_crack(20.0, segments), {}, apertures, {.initially_full = false});
  PressureTangent derivatives(segments);
  for (int k = 0; k < 400; ++k) (void)march.step(apertures, {head, {}}, 0.02);
  const double exact = 9.789253354002815;  // m after 8 s, closed form; the march is of first order in the segments
  if (!(std::abs(march.state().front_position - exact) <= 20.0 / segments))
    return state.SkipWithError("the front is wrong");
  const long before = allocations;
  for (auto _ : state) {
    (void)march.trial(apertures, {head, {}}, 0.02);
    differentiate(march, derivatives);
    benchmark::DoNotOptimize(derivatives.nodal_force.data());
  }
  if (allocations - before > 4) state.SkipWithError("a trial or its tangent allocated");
}

/// A dry crack filling: steps over the time in which the front runs through it.
void marched_step(benchmark::State& state) {
  const std::vector<double> apertures(reference_segments + 1, 0.001);
  const auto fresh = [&] {
    return FillingMarch(straight_crack(45.0, reference_segments), {}, apertures, {.initially_full = false});
  };
  FillingMarch march = fresh();
  for (int k = 0; k < 100; ++k) (void)march.step(apertures, {head, {}}, 0.1);
  const double exact = 11.6446647038851;  // m after 10 s, closed form; the march is of first order: 1e-2
  if (!(std::abs(march.state().front_position / exact - 1.0) <= 1e-2)) return state.SkipWithError("the front is wrong");
  if (!(std::abs(march.state().balance_error) <= 1e-13 * march.state().moved))
    return state.SkipWithError("water is lost");
  for (auto _ : state) {
    if (march.state().front_position > 40.0) {
      state.PauseTiming();
      march = fresh();
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(march.step(apertures, {head, {}}, 0.1).content);
  }
  state.counters["evaluations"] =
      static_cast<double>(march.state().gradient_evaluations) / static_cast<double>(march.state().steps);
}

/// 256 cracks, each thread its share: cracks share nothing.
void many_cracks(benchmark::State& state) {
  constexpr int cracks = 256;
  PressureSolver solver(straight_crack(45.0, reference_segments), {});
  const Motion motion = reference_motion(reference_segments, -0.10);
  if (!right(state, solver.solve(motion.apertures, motion.rates, {head, 0.0}).uplift_force, cases[2].uplift)) return;
  const int share = cracks / state.threads();
  for (auto _ : state) {
    for (int k = 0; k < share; ++k) {
      benchmark::DoNotOptimize(solver.solve(motion.apertures, motion.rates, {head + k, 0.0}).uplift_force);
    }
  }
  state.SetItemsProcessed(state.iterations() * share);
}

void register_solves() {
  for (const Quadrature quadrature : {Quadrature::exact, Quadrature::midpoint}) {
    for (const Search search :
         {Search::bisection, Search::itp, Search::toms748, Search::newton, Search::prefix_moments}) {
      for (const Case& c : cases) {
        const std::string name = std::string("solve/") + (quadrature == Quadrature::exact ? "exact/" : "midpoint/") +
                                 search_names[static_cast<int>(search)] + "/" + c.name;
        benchmark::RegisterBenchmark(name.c_str(), solve, c, search, quadrature);
      }
    }
  }
}

BENCHMARK_CAPTURE(sweep, one_way, 3.0);
BENCHMARK_CAPTURE(sweep, turning, -1.65874217599189056);
BENCHMARK(length)->RangeMultiplier(10)->Range(100, 1'000'000)->Complexity();
BENCHMARK(tangent)->Arg(20)->Arg(100)->Arg(450);
BENCHMARK(solve_and_tangent)->Arg(20)->Arg(50)->Arg(100);
BENCHMARK(trial_and_tangent)->Arg(20)->Arg(50)->Arg(100);
BENCHMARK(marched_step);
BENCHMARK(many_cracks)->ThreadRange(1, 2)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  register_solves();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
