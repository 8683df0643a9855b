/// What a mesh costs: gmsh's triangles beside our own part (dual, checks, nodes), for the Koyna section.
///
/// Sizes 2.4 m (about 730 polygons) to 0.19 m (about 1e5). Every run checks that the polygons cover the section before
/// its time counts.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "solver/mesh/check_mesh.hpp"
#include "solver/mesh/dual.hpp"
#include "solver/mesh/nodal_mesh.hpp"
#include "solver/mesh/polygon_geometry.hpp"
#include "solver/mesh/triangulation.hpp"

namespace {

using namespace sunder::mesh;

Outline koyna() {
  return {.vertices = {{0, 0}, {70, 0}, {19.25, 66.5}, {14.8, 103}, {0, 103}},
          .boundaries = {{"base", {0}}, {"downstream", {1, 2}}, {"crest", {3}}, {"upstream", {4}}}};
}

TriangulationOptions options(const benchmark::State& state) {
  return {.size = {.size = static_cast<double>(state.range(0)) * 1e-3 * edge_per_polygon_size}};
}

/// The triangles of a size, made once: setting up may not take longer than measuring.
const PolygonMesh& triangles(const benchmark::State& state) {
  static std::map<std::int64_t, PolygonMesh> made;
  const auto [at, fresh] = made.try_emplace(state.range(0));
  if (fresh) at->second = triangulate(koyna(), options(state));
  return at->second;
}

/// False, and the benchmark stops with the reason, where the polygons do not cover the section.
bool covers(benchmark::State& state, const PolygonMesh& mesh) {
  double area = 0.0;
  for (int i = 0; i < static_cast<int>(mesh.polygons.size()); ++i) area += moments(closed_line(mesh, i)).area;
  const bool right = std::abs(area / moments(koyna().vertices).area - 1.0) <= 1e-10;
  if (!right) state.SkipWithError("the polygons do not cover the section");
  return right;
}

void gmsh_triangles(benchmark::State& state) {
  if (!covers(state, triangles(state))) return;
  for (auto _ : state) benchmark::DoNotOptimize(triangulate(koyna(), options(state)));
}

void dual_polygons(benchmark::State& state) {
  const PolygonMesh mesh = dual(triangles(state));
  if (!covers(state, mesh)) return;
  for (auto _ : state) benchmark::DoNotOptimize(dual(triangles(state)));
  state.counters["polygons"] = static_cast<double>(mesh.polygons.size());
}

void checks(benchmark::State& state) {
  const PolygonMesh mesh = dual(triangles(state));
  if (!covers(state, mesh)) return;
  for (auto _ : state) check_mesh(mesh);
}

void nodes(benchmark::State& state) {
  const int order = static_cast<int>(state.range(1));
  const PolygonMesh mesh = dual(triangles(state));
  const auto asked = [order](int, int) { return order; };
  // Each edge of a closed polygon adds `order` nodes to it.
  long expected = 0, placed = 0;
  const NodalMesh nodal = place_nodes(mesh, asked);
  for (const Polygon& p : mesh.polygons) expected += static_cast<long>(order) * p.edge_count();
  for (int i = 0; i < nodal.polygon_count(); ++i) placed += static_cast<long>(nodal.polygon(i).nodes.size());
  if (placed != expected) {
    state.SkipWithError("nodes are missing");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(place_nodes(mesh, asked));
  state.counters["nodes"] = nodal.node_count();
}

BENCHMARK(gmsh_triangles)->Arg(2400)->Arg(1200)->Arg(600)->Arg(193)->Unit(benchmark::kMillisecond);
BENCHMARK(dual_polygons)->Arg(2400)->Arg(1200)->Arg(600)->Arg(193)->Unit(benchmark::kMillisecond);
BENCHMARK(checks)->Arg(2400)->Arg(1200)->Arg(600)->Arg(193)->Unit(benchmark::kMillisecond);
BENCHMARK(nodes)->Args({2400, 1})->Args({193, 1})->Args({193, 4})->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
