/// Time of one polygon's stiffness, mass and modes by each route, of forming a mesh of six-sided polygons, and of
/// assembling it. Every benchmark checks its answer before it reports a time.

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/sbfem/formation.hpp"
#include "solver/sbfem/modes.hpp"
#include "solver/sbfem/polygon_solution.hpp"

namespace {

using namespace sunder;
using namespace sunder::sbfem;

const material::Isotropic concrete{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2400.0};

/// A regular polygon of order 1 up to 8 nodes, beyond with 8 edges of higher order.
Boundary polygon_of(int nodes) {
  const int edges = nodes <= 8 ? nodes : 8, order = nodes / edges;
  const Eigen::VectorXd eta = numerics::gauss_lobatto(order + 1).points;
  Boundary boundary{.nodes = Eigen::Matrix2Xd(2, nodes),
                    .orders = std::vector<int>(static_cast<std::size_t>(edges), order)};
  const auto vertex = [&](int e) -> Eigen::Vector2d {
    const double angle = 2.0 * std::numbers::pi * (e + 0.3) / edges;
    return {1.1 * std::cos(angle), 0.9 * std::sin(angle)};
  };
  for (int e = 0; e < edges; ++e) {
    for (int i = 0; i < order; ++i) {
      boundary.nodes.col(e * order + i) = 0.5 * (1.0 - eta[i]) * vertex(e) + 0.5 * (1.0 + eta[i]) * vertex(e + 1);
    }
  }
  return boundary;
}

/// ‖K u - f‖ / ‖f‖ of the state σ_xx = 1: what every polygon must carry exactly.
double stretch_error(const Boundary& polygon, const Eigen::MatrixXd& K) {
  const Eigen::Index n = polygon.nodes.cols();
  const double E = concrete.youngs_modulus, nu = concrete.poisson_ratio;
  Eigen::VectorXd u(2 * n), f = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    u[2 * i] = (1.0 - nu * nu) / E * polygon.nodes(0, i);
    u[2 * i + 1] = -nu * (1.0 + nu) / E * polygon.nodes(1, i);
  }
  Eigen::Index start = 0;
  for (const int p : polygon.orders) {
    const Eigen::VectorXd weights =
        numerics::gauss_lobatto(p + 1).weights;  // ∫ N_i dη: exact, N_i has degree p <= 2p - 1
    const double height = polygon.nodes(1, (start + p) % n) - polygon.nodes(1, start);
    for (int i = 0; i <= p; ++i) f[2 * ((start + i) % n)] += 0.5 * weights[i] * height;
    start += p;
  }
  return (K * u - f).norm() / f.norm();
}

/// ‖Tᵀ M T / (ρ area) - 1‖ of a translation.
double weight_error(const Boundary& polygon, const Eigen::MatrixXd& M) {
  double sum = 0.0, area = 0.0;
  const Eigen::Index n = polygon.nodes.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index next = (i + 1) % n;
    area += 0.5 * (polygon.nodes(0, i) * polygon.nodes(1, next) - polygon.nodes(1, i) * polygon.nodes(0, next));
    for (Eigen::Index j = 0; j < n; ++j) sum += M(2 * i, 2 * j);
  }
  return std::abs(sum / (concrete.density * area) - 1.0);
}

// Bars of the answers: round-off of a healthy polygon, with λ_max of a few hundred at 256 nodes.
constexpr double force_bar = 1e-10, weight_bar = 1e-11;

void stiffness(benchmark::State& state, Route route) {
  const Boundary polygon = polygon_of(static_cast<int>(state.range(0)));
  if (!(stretch_error(polygon, solve_polygon(coefficients(polygon, concrete), route).K) < force_bar)) {
    return state.SkipWithError("wrong stiffness");
  }
  for (auto _ : state) benchmark::DoNotOptimize(solve_polygon(coefficients(polygon, concrete), route).K.data());
}

void stiffness_and_mass(benchmark::State& state) {
  const Boundary polygon = polygon_of(static_cast<int>(state.range(0)));
  const Coefficients c = coefficients(polygon, concrete);
  if (!(weight_error(polygon, mass(c, solve_polygon(c))) < weight_bar)) return state.SkipWithError("wrong mass");
  for (auto _ : state) {
    const Coefficients own = coefficients(polygon, concrete);
    benchmark::DoNotOptimize(mass(own, solve_polygon(own)).data());
  }
}

void all_modes(benchmark::State& state) {
  const Boundary polygon = polygon_of(static_cast<int>(state.range(0)));
  const Coefficients c = coefficients(polygon, concrete);
  const ModalSolution all = modes(c);
  if (!((solve_polygon(c).K * all.Vu - all.Vq).norm() < force_bar * all.Vq.norm()))
    return state.SkipWithError("wrong modes");
  for (auto _ : state) benchmark::DoNotOptimize(modes(c).Vu.data());
}

/// Crooked hexagons in rows of `columns`, the first `count` of them.
mesh::PolygonMesh hexagons(int count, int columns) {
  mesh::PolygonMesh result;
  std::map<std::pair<int, int>, int> known;
  const double height = std::sqrt(3.0) / 2.0;
  const auto vertex = [&](int i, int j) {
    const auto [found, added] = known.try_emplace({i, j}, static_cast<int>(result.vertices.size()));
    const double crooked = 0.05 * std::sin(3.0 * i + 5.0 * j);
    if (added) result.vertices.emplace_back(0.5 * i + crooked, height * j - crooked);
    return found->second;
  };
  for (int k = 0; k < count; ++k) {
    const int column = k % columns, i = 3 * column, j = 2 * (k / columns) + column % 2;
    mesh::Polygon polygon;
    polygon.vertices = {vertex(i - 1, j - 1), vertex(i + 1, j - 1), vertex(i + 2, j),
                        vertex(i + 1, j + 1), vertex(i - 1, j + 1), vertex(i - 2, j)};
    polygon.scaling_centre = {0.5 * i, height * j};
    result.polygons.push_back(polygon);
  }
  return result;
}

mesh::NodalMesh hexagon_mesh(int count) {
  return place_nodes(hexagons(count, static_cast<int>(std::sqrt(count))), [](int, int) { return 1; });
}

/// Every polygon of the formation carries uniaxial tension and weighs its area.
bool is_right(const mesh::NodalMesh& mesh, const Formation& formation) {
  for (int i = 0; i < formation.polygon_count(); ++i) {
    const Boundary polygon = boundary_of(mesh, i);
    if (!(stretch_error(polygon, formation.stiffness(i)) < force_bar)) return false;
    if (formation.has_mass() && !(weight_error(polygon, formation.mass(i)) < weight_bar)) return false;
  }
  return true;
}

/// range: polygons, threads.
void forming(benchmark::State& state, bool with_mass) {
  const mesh::NodalMesh mesh = hexagon_mesh(static_cast<int>(state.range(0)));
  const std::vector<material::Isotropic> materials = {concrete};
  numerics::ThreadPool pool(static_cast<int>(state.range(1)));
  const FormationOptions options{.with_mass = with_mass, .pool = &pool};
  if (!is_right(mesh, form(mesh, materials, options))) return state.SkipWithError("wrong stiffness or mass");
  for (auto _ : state) benchmark::DoNotOptimize(form(mesh, materials, options).polygon_count());
}

void assembling(benchmark::State& state) {
  const mesh::NodalMesh mesh = hexagon_mesh(static_cast<int>(state.range(0)));
  const std::vector<material::Isotropic> materials = {concrete};
  numerics::ThreadPool pool(static_cast<int>(state.range(1)));
  const Formation formation = form(mesh, materials, {.pool = &pool});
  const Eigen::SparseMatrix<double> K = assemble_stiffness(mesh, formation, &pool);
  Eigen::VectorXd shift(K.rows());
  for (Eigen::Index i = 0; i < shift.size(); ++i) shift[i] = i % 2 == 0 ? 1.0 : -0.5;
  const Eigen::VectorXd force = K.selfadjointView<Eigen::Lower>() * shift;
  if (!(force.norm() < 1e-13 * K.norm() * shift.norm())) return state.SkipWithError("a translation feels a force");
  for (auto _ : state) benchmark::DoNotOptimize(assemble_stiffness(mesh, formation, &pool).valuePtr());
  state.counters["entries"] = static_cast<double>(K.nonZeros());
}

BENCHMARK_CAPTURE(stiffness, ring_doubling, Route::ring_doubling)
    ->RangeMultiplier(2)
    ->Range(4, 256)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(stiffness, matrix_sign, Route::matrix_sign)
    ->RangeMultiplier(2)
    ->Range(4, 256)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(stiffness, ordered_schur, Route::ordered_schur)
    ->RangeMultiplier(2)
    ->Range(4, 256)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(stiffness_and_mass)->RangeMultiplier(2)->Range(4, 256)->Unit(benchmark::kMicrosecond);
BENCHMARK(all_modes)->RangeMultiplier(2)->Range(4, 256)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(forming, stiffness, false)
    ->Args({718, 1})
    ->Args({718, 2})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(forming, stiffness_and_mass, true)
    ->Args({718, 1})
    ->Args({718, 2})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(assembling)
    ->Args({718, 1})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
