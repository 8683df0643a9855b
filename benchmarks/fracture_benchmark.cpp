// From the boundary of a cracked plate that is one polygon to its stress intensity factors: coefficients, stiffness,
// loads, displacements, factors. Every answer is checked against a converged figure before it is timed; a wrong one is
// an error, not a time. Counters: relative error of K_I (and K_II), unknowns, edges.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "solver/fracture/singular_modes.hpp"
#include "solver/fracture/tests/cracked_plate.hpp"
#include "solver/fracture/tip_resolution.hpp"

namespace {

using namespace sunder;
using namespace sunder::fracture;
using testing::Plate;

struct Problem {
  std::vector<Eigen::Vector2d> corners;  // relative to the tip
  std::vector<int> singular_corners;
  material::Isotropic material;
  bool sheared = false;          // unit shear on top and a held base; else unit tension above and below
  double K_I = 0.0, K_II = 0.0;  // converged figures
};

// a/W = ½, half height H/W = 1: F = 2.8254653223, converged to 2e-10.
Problem edge_crack() {
  return {.corners = {{-0.5, 0}, {-0.5, -1}, {0.5, -1}, {0.5, 1}, {-0.5, 1}, {-0.5, 0}},
          .singular_corners = {},
          .material = {.youngs_modulus = 1.0, .poisson_ratio = 0.3},
          .K_I = 2.8254653223 * std::sqrt(0.5 * std::numbers::pi)};
}

// W = 7, L = 16, a = 3.5, plane strain, ν = ¼: K_I = 34.04254, K_II = 4.53694, converged to 1e-6.
Problem sheared_crack() {
  return {.corners = {{-3.5, 0}, {-3.5, -8}, {3.5, -8}, {3.5, 8}, {-3.5, 8}, {-3.5, 0}},
          .singular_corners = {1, 2},
          .material = {.youngs_modulus = 1.0, .poisson_ratio = 0.25},
          .sheared = true,
          .K_I = 34.04254,
          .K_II = 4.53694};
}

Eigen::VectorXd top_shear(const sbfem::Boundary& boundary) {
  const double top = boundary.nodes.row(1).maxCoeff();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(boundary.nodes.size());
  Eigen::Index start = 0;
  for (std::size_t e = 0; e < boundary.orders.size(); ++e) {
    const Eigen::Index end = start + boundary.orders[e];
    if (boundary.nodes(1, start) == top && boundary.nodes(1, end) == top) {
      load += sbfem::edge_traction(boundary, static_cast<int>(e), Eigen::Matrix2Xd(Eigen::Vector2d(1, 0)));
    }
    start = end;
  }
  return load;
}

TipState boundary_to_factors(const Problem& problem, const ResolvedOutline& outline) {
  const Plate plate =
      testing::make_plate(sbfem::testing::boundary(outline.vertices, outline.orders, true), problem.material);
  Eigen::VectorXd u;
  if (problem.sheared) {
    const double base = plate.boundary.nodes.row(1).minCoeff();
    u = testing::clamped_displacement(plate, top_shear(plate.boundary),
                                      [base](const Eigen::Vector2d& x) { return x.y() < base + 1e-9; });
  } else {
    u = testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0));
  }
  const CrackTip tip =
      crack_tip(plate.boundary, plate.coefficients, plate.solution, plate.material, {.exponents = false});
  return tip_state(tip, u);
}

void run(benchmark::State& state, const Problem& problem, const ResolvedOutline& outline, double bar) {
  const auto error = [&](const TipState& at_tip) {
    const double first = std::abs(at_tip.factors.K_I / problem.K_I - 1.0);
    return problem.K_II == 0.0 ? first : std::max(first, std::abs(at_tip.factors.K_II / problem.K_II - 1.0));
  };
  const double found = error(boundary_to_factors(problem, outline));
  if (!(found <= bar)) {
    std::ostringstream message;
    message << "relative error " << found << " exceeds " << bar;
    state.SkipWithError(message.str().c_str());
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(boundary_to_factors(problem, outline));
  state.counters["relative_error"] = found;
  state.counters["edges"] = static_cast<double>(outline.orders.size());
  double unknowns = 2.0;
  for (const int order : outline.orders) unknowns += 2.0 * order;
  state.counters["unknowns"] = unknowns;
}

// Divided by the rule of fracture/tip_resolution.hpp for a tolerance of 10^-k: nothing is tuned to the plate.
void edge_crack_by_rule(benchmark::State& state) {
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  const Problem problem = edge_crack();
  run(state, problem, resolve_outline(problem.corners, {.tolerance = tolerance}), tolerance);
}
BENCHMARK(edge_crack_by_rule)->ArgName("digits")->Arg(2)->Arg(4)->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond);

// Twelve edges of half the width, one order for all: the layout to compare with.
void edge_crack_twelve_edges(benchmark::State& state) {
  const int order = static_cast<int>(state.range(0));
  const ResolvedOutline outline{.vertices = testing::edge_cracked_plate(0.5, 1.0, {2, 2, 4, 2, 2}),
                                .orders = std::vector<int>(12, order)};
  run(state, edge_crack(), outline, order == 4 ? 1e-4 : order == 6 ? 1e-6 : 1e-8);
}
BENCHMARK(edge_crack_twelve_edges)->ArgName("order")->Arg(4)->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond);

// Tolerances 1e-4 and, as the figures are good for 1e-6, 3e-6.
void sheared_crack_by_rule(benchmark::State& state) {
  const double tolerance = 1e-6 * static_cast<double>(state.range(0));
  const Problem problem = sheared_crack();
  run(state, problem,
      resolve_outline(problem.corners, {.tolerance = tolerance, .singular_corners = problem.singular_corners}),
      tolerance);
}
BENCHMARK(sheared_crack_by_rule)->ArgName("tolerance_e-6")->Arg(100)->Arg(10)->Unit(benchmark::kMillisecond);

// What reading the factors costs when the polygon is solved: on the twelve-edge plate of order 6.
void crack_tip_of_a_solved_polygon(benchmark::State& state) {
  const auto extraction = static_cast<Extraction>(state.range(0));
  const Problem problem = edge_crack();
  const Plate plate = testing::make_plate(
      testing::open_boundary(testing::edge_cracked_plate(0.5, 1.0, {2, 2, 4, 2, 2}), 6), problem.material);
  const Eigen::VectorXd u = testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0));
  const auto read = [&] {
    return crack_tip(plate.boundary, plate.coefficients, plate.solution, plate.material,
                     {.extraction = extraction, .exponents = false});
  };
  const double error = std::abs(tip_state(read(), u).factors.K_I / problem.K_I - 1.0);
  // The pointwise stress is one order p slower.
  if (!(error <= (extraction == Extraction::pointwise_stress ? 1e-2 : 1e-6))) {
    state.SkipWithError("K_I is wrong");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(read());
  state.counters["relative_error"] = error;
}
BENCHMARK(crack_tip_of_a_solved_polygon)
    ->ArgName("extraction")
    ->DenseRange(0, static_cast<int>(Extraction::pointwise_stress))
    ->Unit(benchmark::kMicrosecond);

// One product with F: what a time step pays.
void factors_of_a_time_step(benchmark::State& state) {
  const Problem problem = edge_crack();
  const Plate plate = testing::make_plate(
      testing::open_boundary(testing::edge_cracked_plate(0.5, 1.0, {2, 2, 4, 2, 2}), 6), problem.material);
  const Eigen::VectorXd u = testing::free_displacement(plate, testing::remote_tension(plate.boundary, {0, 1}, 1.0));
  const CrackTip tip =
      crack_tip(plate.boundary, plate.coefficients, plate.solution, plate.material, {.exponents = false});
  if (!(std::abs(tip_state(tip, u).factors.K_I / problem.K_I - 1.0) <= 1e-6)) {
    state.SkipWithError("K_I is wrong");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(tip_state(tip, u));
}
BENCHMARK(factors_of_a_time_step)->Unit(benchmark::kNanosecond);

}  // namespace

BENCHMARK_MAIN();
