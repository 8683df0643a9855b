/// Time of one linear step of a dam without a crack: trial motion, new velocity and acceleration. The motion under the
/// Koyna record is checked before a time is reported, and that no step asks for memory.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string>

#include "solver/dynamics/ground_motion.hpp"
#include "solver/simulation/dynamic_body.hpp"
#include "solver/simulation/free_vibration.hpp"
#include "solver/simulation/step_equations.hpp"

namespace {
std::atomic<long> memory_requests{0};
}

// Eigen and CHOLMOD ask the C library, so it is counted there and not at operator new.
extern "C" void* __libc_malloc(std::size_t size);     // NOLINT(bugprone-reserved-identifier)
extern "C" void* malloc(std::size_t size) noexcept {  // NOLINT(readability-inconsistent-declaration-parameter-name)
  memory_requests.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace {

using namespace sunder;

constexpr double time_step = 0.01, gravity = 9.81;

scene::Scene dam(double size) {
  scene::Scene scene;
  scene.name = "dam";
  scene.analysis = scene::Analysis::dynamic;
  scene.geometry = scene::Geometry{.outline = {{0.0, 0.0}, {70.0, 0.0}, {19.25, 66.5}, {14.8, 103.0}, {0.0, 103.0}},
                                   .holes = {},
                                   .boundaries = {{"base", {0}}, {"upstream", {4}}}};
  scene.mesh.size = size;
  scene.material = material::Isotropic{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2450.0};
  scene.supports = {{.boundary = "base", .point = {}, .fix = {true, true}}};
  return scene;
}

simulation::DynamicBody body_of(const scene::Scene& scene) {
  numerics::ThreadPool pool(1);
  simulation::Ledger ledger;
  simulation::Body body = simulation::build_body(scene, ledger);
  sbfem::Formation formation = sbfem::form(body.nodes, body.materials, {.with_mass = true, .pool = &pool});
  return simulation::dynamic_body(scene, std::move(body), std::move(formation), pool);
}

/// A record of smooth noise in both directions, 10 s, 0.3 g.
Eigen::Vector2d ground(double time) {
  return 0.1 * gravity *
         Eigen::Vector2d(std::sin(17.0 * time) + std::sin(31.0 * time) + std::sin(7.0 * time), std::sin(43.0 * time));
}

struct Shaken {
  const simulation::DynamicBody& body;
  simulation::StepEquations equations;
  simulation::MotionState state, next;
  simulation::StepLoad start, end;
  Eigen::VectorXd moved;

  Shaken(const simulation::DynamicBody& of, const simulation::StepOptions& options)
      : body(of), equations(of.stiffness, of.mass, of.supports.constraints, {}, options) {
    for (Eigen::VectorXd* values :
         {&state.displacement, &state.velocity, &state.acceleration, &start.force, &end.force, &moved}) {
      values->setZero(of.stiffness.rows());
    }
    next = state;
  }

  void step() {
    end.ground = ground(state.time + time_step);
    equations.advance(state, equations.trial(state, start, end), next);
    equations.accept(next, end.ground, {});
    std::swap(state, next);
    std::swap(start, end);
  }

  double stored() const {
    return 0.5 * state.displacement.dot(body.stiffness.selfadjointView<Eigen::Lower>() * state.displacement) +
           0.5 * state.velocity.dot(body.mass.selfadjointView<Eigen::Lower>() * state.velocity);
  }
};

/// Energy kept by the undamped scheme over 10 s, as a part of the largest: what came in by trapezoids is what is
/// stored, to round-off of 1000 steps.
double imbalance(const simulation::DynamicBody& body) {
  Shaken dam(body, {.scheme = dynamics::newmark(), .time_step = time_step, .damping = {}});
  double input = 0.0, largest = 0.0, worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::VectorXd before = dam.state.displacement;
    const Eigen::Vector2d ground_before = dam.start.ground;
    dam.step();
    dam.moved = dam.state.displacement - before;
    input -= 0.5 * dam.equations.work_of_ground(dam.moved, ground_before + dam.start.ground);
    const double stored = dam.stored();
    largest = std::max(largest, stored);
    worst = std::max(worst, std::abs(stored - input));
  }
  return worst / largest;
}

/// range: size of the polygons in decimetres.
void linear_step(benchmark::State& state) {
  const simulation::DynamicBody body = body_of(dam(0.1 * static_cast<double>(state.range(0))));
  if (imbalance(body) > 1e-9) return state.SkipWithError("the energy of the undamped dam does not balance");
  const simulation::FreeVibration modes = simulation::free_vibration(
      {.stiffness = body.stiffness, .mass = body.mass, .bubble_omega_squared = {}, .bubble_coupling = {}},
      body.supports.constraints, 2, false);
  Shaken dam(body, {.scheme = dynamics::newmark(),
                    .time_step = time_step,
                    .damping = dynamics::rayleigh(0.05, modes.omega[0], modes.omega[1])});
  dam.step();
  const long before = memory_requests;
  for (int i = 0; i < 100; ++i) dam.step();
  const long asked = memory_requests - before;
  for (auto _ : state) dam.step();
  state.counters["nodes"] = static_cast<double>(body.stiffness.rows() / 2);
  state.counters["factor_entries"] = static_cast<double>(dam.equations.factor_entries());
  state.counters["memory_requests"] = static_cast<double>(asked);
  if (asked != 0) state.SkipWithError("a step asked for memory");
}

void back_substitution(benchmark::State& state) {
  const simulation::DynamicBody body = body_of(dam(0.1 * static_cast<double>(state.range(0))));
  Eigen::SparseMatrix<double> matrix = body.stiffness;
  Eigen::VectorXd force = Eigen::VectorXd::Ones(matrix.rows());
  simulation::eliminate(body.supports.constraints, matrix.diagonal().mean(), matrix, force);
  const numerics::SymmetricFactor factor(matrix, {.block = 2});
  Eigen::VectorXd solution = force;
  factor.solve_in_place(solution);
  if ((matrix.selfadjointView<Eigen::Lower>() * solution - force).norm() > 1e-9 * force.norm())
    return state.SkipWithError("the solution leaves a residual");
  for (auto _ : state) {
    solution = force;
    factor.solve_in_place(solution);
    benchmark::DoNotOptimize(solution.data());
  }
}

double least(const std::vector<double>& times) {
  return *std::ranges::min_element(times);
}

void five_times(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(48)
      ->Arg(24)
      ->Arg(12)
      ->Repetitions(5)
      ->ReportAggregatesOnly()
      ->ComputeStatistics("min", least)
      ->Unit(benchmark::kMicrosecond);
}

BENCHMARK(linear_step)->Apply(five_times);
BENCHMARK(back_substitution)->Apply(five_times);

}  // namespace

BENCHMARK_MAIN();
