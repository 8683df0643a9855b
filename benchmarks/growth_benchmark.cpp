/// Time of one growth event of a gravity dam of about 700 polygons, by part: cutting, forming, the fields carried over,
/// assembling and factorising, and the compliance of the crack's faces. Every benchmark checks its answer before it
/// reports a time.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "solver/crack/crack_faces.hpp"
#include "solver/numerics/symmetric_factor.hpp"
#include "solver/sbfem/assembly.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/state_transfer.hpp"
#include "solver/simulation/static_loads.hpp"

namespace {

using namespace sunder;
using simulation::Body;

/// Koyna's section with a crack from its upstream face that has grown to 10 m in increments of 0.5 m.
struct Dam {
  scene::Scene scene;
  Body body;
  sbfem::Formation formation;
  mesh::Point next;  ///< where the tip goes
};

Dam grown_dam() {
  Dam dam;
  dam.scene.name = "dam";
  dam.scene.geometry = scene::Geometry{.outline = {{0.0, 0.0}, {70.0, 0.0}, {19.25, 66.5}, {14.8, 103.0}, {0.0, 103.0}},
                                       .holes = {},
                                       .boundaries = {{"base", {0}}, {"upstream", {4}}}};
  dam.scene.mesh.size = 2.4;
  dam.scene.material = material::Isotropic{.youngs_modulus = 25e9, .poisson_ratio = 0.2, .density = 2450.0};
  scene::Crack crack;
  crack.path = {{0.0, 60.0}, {1.0, 60.0}};
  dam.scene.cracks = {crack};
  dam.scene.supports = {{.boundary = "base", .point = {}, .fix = {true, true}}};
  simulation::Ledger ledger;
  dam.body = simulation::build_body(dam.scene, ledger);
  dam.formation = sbfem::form(dam.body.nodes, dam.body.materials, {.with_mass = true});
  mesh::Point tip(1.0, 60.0);
  const auto ahead = [&](int i) { return mesh::Point(0.5 * std::cos(0.02 * i), -0.5 * std::sin(0.02 * i)); };
  for (int i = 0; i < 18; ++i) {
    tip += ahead(i);
    simulation::Growth growth = simulation::grow(dam.body, dam.formation, 0, tip);
    dam.body = std::move(growth.body);
    dam.formation = std::move(growth.formation);
  }
  dam.next = tip + ahead(18);
  return dam;
}

const Dam& dam() {
  static const Dam made = grown_dam();
  return made;
}

const simulation::Growth& grown() {
  static const simulation::Growth made = simulation::grow(dam().body, dam().formation, 0, dam().next);
  return made;
}

void count(benchmark::State& state) {
  state.counters["polygons"] = static_cast<double>(grown().body.nodes.polygon_count());
  state.counters["dofs"] = static_cast<double>(grown().body.dofs());
}

bool tip_is_there() {
  return grown().event == crack::TipEvent::advanced && (grown().tip - dam().next).norm() == 0.0;
}

void cutting(benchmark::State& state) {
  if (!tip_is_there()) return state.SkipWithError("wrong answer");
  for (auto _ : state) {
    mesh::PolygonMesh polygons = dam().body.polygons;
    benchmark::DoNotOptimize(crack::advance_tip(polygons, 0, dam().next, dam().body.discretisation.cut));
  }
  count(state);
}

void placing_nodes(benchmark::State& state) {
  Body body = grown().body;
  simulation::place_nodes(body);
  if (body.nodes.coordinates() != grown().body.nodes.coordinates()) return state.SkipWithError("wrong answer");
  for (auto _ : state) simulation::place_nodes(body);
  count(state);
}

bool same_bits(const sbfem::Formation& a, const sbfem::Formation& b) {
  for (int i = 0; i < a.polygon_count(); ++i) {
    const auto bytes = static_cast<std::size_t>(a.stiffness(i).size()) * sizeof(double);
    if (std::memcmp(a.stiffness(i).data(), b.stiffness(i).data(), bytes) != 0) return false;
    if (std::memcmp(a.mass(i).data(), b.mass(i).data(), bytes) != 0) return false;
  }
  return true;
}

void forming_what_changed(benchmark::State& state) {
  const Body& body = grown().body;
  const auto form = [&] {
    const std::vector<int> same = sbfem::same_polygons(body.nodes, dam().body.nodes, grown().report.polygon_from);
    return sbfem::form_again(body.nodes, body.materials, {.with_mass = true}, dam().formation, same);
  };
  const sbfem::Formation anew = sbfem::form(body.nodes, body.materials, {.with_mass = true}), again = form();
  if (!same_bits(anew, again)) return state.SkipWithError("wrong answer");
  for (auto _ : state) benchmark::DoNotOptimize(form());
  count(state);
  state.counters["formed"] = static_cast<double>(again.polygon_count() - again.summary().reused_count);
}

void forming_all(benchmark::State& state) {
  const Body& body = grown().body;
  for (auto _ : state) benchmark::DoNotOptimize(sbfem::form(body.nodes, body.materials, {.with_mass = true}));
  count(state);
}

void carrying_fields_over(benchmark::State& state) {
  Eigen::MatrixXd fields = Eigen::MatrixXd::Zero(dam().body.dofs(), 3);  // displacement, velocity, acceleration
  for (int i = 0; i < dam().body.nodes.node_count(); ++i) {
    const mesh::Point x = dam().body.nodes.coordinates().col(i);
    fields.row(2 * i) << 1.0, 0.0, -x.y();
    fields.row(2 * i + 1) << 0.0, 1.0, x.x();
  }
  const auto carry = [&] {
    return simulation::transfer_fields(dam().body, dam().formation, grown().body, grown().same, grown().report, fields);
  };
  const simulation::TransferredFields moved = carry();
  for (int i = 0; i < grown().body.nodes.node_count(); ++i) {
    const mesh::Point x = grown().body.nodes.coordinates().col(i);
    const bool right =
        std::abs(moved.values(2 * i, 0) - 1.0) < 1e-10 && std::abs(moved.values(2 * i + 1, 1) - 1.0) < 1e-10 &&
        std::abs(moved.values(2 * i, 2) + x.y()) < 1e-8 && std::abs(moved.values(2 * i + 1, 2) - x.x()) < 1e-8;
    if (!right) return state.SkipWithError("wrong answer");
  }
  for (auto _ : state) benchmark::DoNotOptimize(carry());
  count(state);
  state.counters["interpolated_nodes"] = static_cast<double>(moved.interpolated_nodes);
}

/// The stiffness with the base held.
Eigen::SparseMatrix<double> held_stiffness(const Body& body, const sbfem::Formation& formation) {
  Eigen::SparseMatrix<double> stiffness = sbfem::assemble_stiffness(body.nodes, formation);
  const simulation::Supports supports = simulation::supports_of(dam().scene, body, true);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(body.dofs());
  simulation::eliminate(supports.constraints, stiffness.diagonal().mean(), stiffness, force);
  return stiffness;
}

void assembling(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(held_stiffness(grown().body, grown().formation));
  count(state);
}

void factorising(benchmark::State& state) {
  const Eigen::SparseMatrix<double> stiffness = held_stiffness(grown().body, grown().formation);
  if (numerics::SymmetricFactor(stiffness, {.block = 2}).status() != numerics::FactorStatus::factorised) {
    return state.SkipWithError("wrong answer");
  }
  for (auto _ : state) benchmark::DoNotOptimize(numerics::SymmetricFactor(stiffness, {.block = 2}));
  count(state);
}

/// Bᵀ K⁻¹ B for the relative motion of all pairs of the crack's faces.
Eigen::MatrixXd face_compliance(const numerics::SymmetricFactor& factor, const crack::CrackPairs& pairs) {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(factor.rows(), 2 * pairs.count());
  for (int i = 0; i < pairs.count(); ++i) {
    for (int c = 0; c < 2; ++c) {
      B(2 * pairs.upper[i] + c, 2 * i + c) = 1.0;
      B(2 * pairs.lower[i] + c, 2 * i + c) = -1.0;
    }
  }
  Eigen::MatrixXd X = B;
  factor.solve_in_place(X);
  return B.transpose() * X;
}

void solving_for_the_faces(benchmark::State& state) {
  const numerics::SymmetricFactor factor(held_stiffness(grown().body, grown().formation), {.block = 2});
  const crack::CrackPairs pairs = crack::crack_pairs(grown().body.polygons, grown().body.nodes, 0);
  const Eigen::MatrixXd F = face_compliance(factor, pairs);
  // Symmetric, and a unit force that opens a pair opens it.
  if (!((F - F.transpose()).norm() < 1e-10 * F.norm()) || !(F.diagonal().minCoeff() > 0.0)) {
    return state.SkipWithError("wrong answer");
  }
  for (auto _ : state) benchmark::DoNotOptimize(face_compliance(factor, pairs));
  count(state);
  state.counters["pairs"] = static_cast<double>(pairs.count());
}

/// Everything that a growth event asks for.
void whole_event(benchmark::State& state) {
  if (!tip_is_there()) return state.SkipWithError("wrong answer");
  const Eigen::MatrixXd fields = Eigen::MatrixXd::Ones(dam().body.dofs(), 3);
  for (auto _ : state) {
    const simulation::Growth growth = simulation::grow(dam().body, dam().formation, 0, dam().next);
    benchmark::DoNotOptimize(
        simulation::transfer_fields(dam().body, dam().formation, growth.body, growth.same, growth.report, fields));
    const numerics::SymmetricFactor factor(held_stiffness(growth.body, growth.formation), {.block = 2});
    const crack::CrackPairs pairs = crack::crack_pairs(growth.body.polygons, growth.body.nodes, 0);
    benchmark::DoNotOptimize(face_compliance(factor, pairs));
  }
  count(state);
}

BENCHMARK(cutting)->Unit(benchmark::kMillisecond);
BENCHMARK(placing_nodes)->Unit(benchmark::kMillisecond);
BENCHMARK(forming_what_changed)->Unit(benchmark::kMillisecond);
BENCHMARK(forming_all)->Unit(benchmark::kMillisecond);
BENCHMARK(carrying_fields_over)->Unit(benchmark::kMillisecond);
BENCHMARK(assembling)->Unit(benchmark::kMillisecond);
BENCHMARK(factorising)->Unit(benchmark::kMillisecond);
BENCHMARK(solving_for_the_faces)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_event)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
