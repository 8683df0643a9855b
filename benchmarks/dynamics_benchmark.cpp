/// What time integration costs: one linear step of a dam of 1600 nodes without a crack and its parts, and ten seconds
/// of shaking with compressible water and with rock.
///
/// A step's answer is checked by what is out of balance after it and by the energy account, a run's by the account and
/// by the crest displacement that modal superposition of other elements has. A step that allocates is an error.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "benchmarks/scene_runs.hpp"
#include "solver/numerics/tests/allocation_count.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/scene/reader.hpp"
#include "solver/simulation/dynamic_options.hpp"
#include "solver/simulation/dynamic_step.hpp"
#include "solver/simulation/run.hpp"

namespace {

using namespace sunder;
using benchmarks::number;
using benchmarks::put_on_rock;
using namespace sunder::simulation;
using Eigen::VectorXd;

scene::Scene koyna(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::vector<scene::Override> overrides{{"mesh.order", "1"}, {"mesh.size", "2.4"}, {"dynamics.time_step", "0.01"}};
  for (const auto& [key, value] : changes) overrides.push_back({key, value});
  return scene::read_scene(std::string(SUNDER_CASES) + "/dynamics/koyna-linear.scene.toml", overrides);
}

/// The empty dam between two steps, on ground that shakes near its first and second frequency.
class ShakenDam {
 public:
  ShakenDam() : scene_(koyna({})) {
    Ledger ledger;
    Body meshed = build_body(scene_, ledger);
    sbfem::Formation formation = sbfem::form(meshed.nodes, meshed.materials, {.with_mass = true, .pool = &pool_});
    body_ = dynamic_body(scene_, std::move(meshed), std::move(formation), false, pool_);
    step = std::make_unique<DynamicStep>(body_, std::span<AttachedMedium* const>(), std::span<const Mouth>(), waters_,
                                         step_options(scene_, body_, pool_, ledger), faces::FaceStepOptions(),
                                         FaceMemory(), state);
    for (VectorXd* values : {&state.displacement, &state.velocity, &state.acceleration})
      values->setZero(body_.body.dofs());
    start.force = end.force = body_.dead_load * 0.0;
    next = state;
    energy.begin(step->equations(), state);
  }

  void move() {
    const double time = 0.01 * ++number_;
    end.ground = {std::sin(18.0 * time), 0.5 * std::cos(47.0 * time)};
    (void)step->solve(state, start, end, next);
    const FaceWork work = step->accept(next, end.ground);
    energy.add(step->equations(), state, next, start, end, media_before_, work, none_);
    std::swap(state, next);
    std::swap(start, end);
  }

  /// Says so where it is not.
  bool is_right(benchmark::State& report) const {
    // of a sum of mass and stiffness forces each of whose numbers is round-off of 1e4 times the load
    const double residual = step->unbalanced(state, start).norm() / step->equations().ground_load(start.ground).norm();
    const double energy_error = energy.balance_error();
    if (residual < 1e-9 && energy_error < 1e-10 && state.displacement.norm() > 0.0) return true;
    const std::string found =
        "residual " + std::to_string(1e12 * residual) + "e-12, energy " + std::to_string(1e12 * energy_error) + "e-12";
    report.SkipWithError(("the step is wrong: " + found).c_str());
    return false;
  }
  double nodes() const { return body_.body.nodes.node_count(); }

  std::unique_ptr<DynamicStep> step;
  MotionState state, next;
  StepLoad start, end;
  EnergyAccount energy;

 private:
  scene::Scene scene_;
  numerics::ThreadPool pool_{1};
  DynamicBody body_;
  CrackWaters waters_;
  std::vector<VectorXd> media_before_;
  VectorXd none_;
  int number_ = 0;
};

void linear_step(benchmark::State& state) {
  ShakenDam dam;
  for (int i = 0; i < 100; ++i) dam.move();
  if (!dam.is_right(state)) return;
  const long before = numerics::allocations;
  for (int i = 0; i < 100; ++i) dam.move();
  if (numerics::allocations != before) return state.SkipWithError("a step allocated");
  for (auto _ : state) dam.move();
  if (!dam.is_right(state)) return;
  state.counters["nodes"] = dam.nodes();
  state.counters["factor_entries"] = static_cast<double>(dam.step->equations().factor_entries());
}

/// The right-hand side and the back-substitution of a step.
void trial_of_a_step(benchmark::State& state) {
  ShakenDam dam;
  for (int i = 0; i < 100; ++i) dam.move();
  for (auto _ : state) benchmark::DoNotOptimize(dam.step->equations().trial(dam.state, dam.start, dam.end).data());
}

void back_substitution(benchmark::State& state) {
  ShakenDam dam;
  dam.move();
  const numerics::SymmetricFactor factor(dam.step->equations().stiffness() + 1e5 * dam.step->equations().mass(),
                                         {.block = 2});
  VectorXd b = VectorXd::Ones(dam.state.displacement.size()), x = b;
  for (auto _ : state) {
    x = b;
    factor.solve_in_place(x);
    benchmark::DoNotOptimize(x.data());
  }
}

/// K and M times two vectors each.
void products(benchmark::State& state, bool in_one_pass) {
  ShakenDam dam;
  dam.move();
  const Eigen::SparseMatrix<double> K = dam.step->equations().stiffness(), M = dam.step->equations().mass();
  const numerics::NodeProducts blocks(K, M);
  const VectorXd x = VectorXd::LinSpaced(K.rows(), -1.0, 1.0), z = x.cwiseAbs2();
  Eigen::MatrixX2d both(K.rows(), 2), K_both = both, M_both = both;
  both << x, z;
  numerics::VectorPair pair(4, K.rows() / 2), K_pair = pair, M_pair = pair;
  pair << x.reshaped(2, pair.cols()), z.reshaped(2, pair.cols());
  blocks.multiply(pair, pair, K_pair, M_pair);
  K_both.noalias() = K.selfadjointView<Eigen::Lower>() * both;
  M_both.noalias() = M.selfadjointView<Eigen::Lower>() * both;
  const auto error = [](const numerics::VectorPair& found, const Eigen::MatrixX2d& right) {
    return ((found.topRows<2>() - right.col(0).reshaped(2, found.cols())).norm() +
            (found.bottomRows<2>() - right.col(1).reshaped(2, found.cols())).norm()) /
           right.norm();
  };
  if (!(error(K_pair, K_both) < 1e-14 && error(M_pair, M_both) < 1e-14))
    return state.SkipWithError("the products are wrong");
  for (auto _ : state) {
    if (in_one_pass) {
      blocks.multiply(pair, pair, K_pair, M_pair);
    } else {
      K_both.noalias() = K.selfadjointView<Eigen::Lower>() * both;
      M_both.noalias() = M.selfadjointView<Eigen::Lower>() * both;
    }
    benchmark::DoNotOptimize(K_pair.data());
    benchmark::DoNotOptimize(M_both.data());
  }
}

void energy_of_a_step(benchmark::State& state) {
  ShakenDam dam;
  for (int i = 0; i < 100; ++i) dam.move();
  EnergyAccount energy = dam.energy;
  for (auto _ : state)
    energy.add(dam.step->equations(), dam.next, dam.state, dam.end, dam.start, {}, FaceWork(), VectorXd());
  benchmark::DoNotOptimize(&energy);
}

/// Ten seconds of shaking. `peak` [m] of the crest, to `tolerance` of itself. The first run fills the cache of the
/// rock.
void koyna_run(benchmark::State& state, const scene::Scene& scene, double peak, double tolerance) {
  const std::filesystem::path cache = std::filesystem::temp_directory_path() / "sunder-dynamics-benchmark";
  double steps_ms = INFINITY, set_up_ms = INFINITY, steps = 0.0;
  (void)run(scene, {.cache = cache});
  for (auto _ : state) {
    const results::RunSummary summary = run(scene, {.cache = cache});
    if (!summary.completed() || !(number(summary, "energy_balance_error") < 1e-9) ||
        !(std::abs(number(summary, "peak_crest_displacement") / peak - 1.0) < tolerance))
      return state.SkipWithError("the run is wrong");
    double others = 0.0;
    for (const results::PartCost& part : summary.parts) {
      if (part.part == "dynamics")
        steps_ms = std::fmin(steps_ms, 1e3 * part.seconds);
      else
        others += 1e3 * part.seconds;
    }
    for (const auto& [name, count] : summary.counts)
      if (name == "steps") steps = static_cast<double>(count);
    set_up_ms = std::fmin(set_up_ms, others);
  }
  state.counters["steps"] = steps;
  state.counters["steps_ms"] = steps_ms;
  state.counters["set_up_ms"] = set_up_ms;
}

scene::Scene ten_seconds(const std::string& water) {
  if (water.empty()) return koyna({});
  return koyna(
      {{"reservoir.boundary", "\"upstream\""}, {"reservoir.level", "91.75"}, {"reservoir.model", '"' + water + '"'}});
}
scene::Scene ten_seconds_on_rock() {
  scene::Scene scene = ten_seconds("compressible");
  put_on_rock(scene);
  return scene;
}

// peaks and tolerances of the cases dynamics/koyna-linear…, with steps of 10 ms; on rock only the order is known
void empty(benchmark::State& state) {
  koyna_run(state, ten_seconds(""), 0.03539, 0.14);
}
void incompressible_water(benchmark::State& state) {
  koyna_run(state, ten_seconds("incompressible"), 0.04315, 0.14);
}
void compressible_water(benchmark::State& state) {
  koyna_run(state, ten_seconds("compressible"), 0.04, 0.5);
}
void compressible_water_on_rock(benchmark::State& state) {
  koyna_run(state, ten_seconds_on_rock(), 0.04, 0.8);
}

BENCHMARK(linear_step)->Unit(benchmark::kMicrosecond);
BENCHMARK(trial_of_a_step)->Unit(benchmark::kMicrosecond);
BENCHMARK(back_substitution)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(products, in_one_pass, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(products, by_eigen, false)->Unit(benchmark::kMicrosecond);
BENCHMARK(energy_of_a_step)->Unit(benchmark::kMicrosecond);
BENCHMARK(empty)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(incompressible_water)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(compressible_water)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(compressible_water_on_rock)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
