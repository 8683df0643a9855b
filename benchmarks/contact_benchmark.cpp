/// What contact of crack faces costs: 100 pairs, from cold and from the last step's answer, penalty, exact and with
/// friction; sizes from 10 to 400; the derivative.
///
/// Every run checks its answer before its time counts: no overlap beyond the gate, no tension, and forces only where
/// the faces touch. `iterations` are steps of the active set in one solve, beside its time; a solve that allocates is
/// an error.

#include <benchmark/benchmark.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "solver/contact/contact_solver.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Eigen allocates past operator new, and operator new comes here too: with glibc every block does.
extern "C" void* __libc_malloc(std::size_t size);
extern "C" [[gnu::noinline]] void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace {

using namespace sunder::contact;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A force on the face of a crack moves it by the logarithm of the distance, smoothed by the spacing [m²/N].
MatrixXd face_flexibility(int pairs) {
  MatrixXd F(pairs, pairs);
  for (int j = 0; j < pairs; ++j) {
    for (int i = 0; i < pairs; ++i) F(i, j) = 1e-10 * std::log(2.0 * pairs / std::hypot(i - j, 0.5));
  }
  return F;
}

/// Normal and tangential alike, uncoupled as on a straight crack between like materials.
MatrixXd rough_flexibility(int pairs) {
  MatrixXd F = MatrixXd::Zero(2 * pairs, 2 * pairs);
  F.topLeftCorner(pairs, pairs) = F.bottomRightCorner(pairs, pairs) = face_flexibility(pairs);
  return F;
}

/// Three waves along the crack, 5 mm; `phase` moves them, `offset` [m] opens or closes all of it.
VectorXd gap_of(int pairs, double phase, double offset = 0.0) {
  VectorXd gap(pairs);
  for (int i = 0; i < pairs; ++i) gap[i] = offset + 5e-3 * std::cos(6.0 * std::numbers::pi * i / pairs + phase);
  return gap;
}
constexpr double closed = -0.1;  // m: pressed together all along

bool right(benchmark::State& state, const ContactSolver& solver, const VectorXd& gap, const MatrixXd& F) {
  const ContactResult& result = solver.result();
  const bool exact = solver.options().model == ContactModel::exact;
  const VectorXd opened = gap + F * result.pair_force;
  const double terms = gap.norm() + F.norm() * result.pair_force.norm(), round_off = 1e-13 * terms;
  const double gate = exact ? round_off : solver.options().penetration_tolerance;
  bool good = result.status == ContactStatus::converged && result.pair_force.minCoeff() >= 0.0;
  good = good && opened.minCoeff() >= -gate && result.closed > 0;
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    if (result.pair_force[i] > 0.0) good = good && opened[i] <= round_off;
  }
  if (!good) state.SkipWithError("the contact is wrong");
  return good;
}

void report(benchmark::State& state, const ContactSolver& solver, long before) {
  if (allocations - before > 8) state.SkipWithError("a solve allocated");  // the harness itself allocates a few times
  state.counters["iterations"] = solver.result().iterations;
  state.counters["enlargements"] = solver.result().enlargements;
  state.counters["closed"] = solver.result().closed;
}

void cold(benchmark::State& state, ContactModel model, double offset) {
  const int pairs = static_cast<int>(state.range(0));
  const MatrixXd F = face_flexibility(pairs);
  ContactSolver solver({.model = model});
  solver.set_faces(F, VectorXd::Constant(pairs, 0.25));
  const VectorXd gap = gap_of(pairs, 0.3, offset);
  (void)solver.solve(gap);
  if (!right(state, solver, gap, F)) return;
  const long before = allocations;
  for (auto _ : state) {
    solver.forget();
    benchmark::DoNotOptimize(solver.solve(gap).pair_force.data());
  }
  report(state, solver, before);
  state.SetComplexityN(pairs);
}

/// A step like the one before: `moved` is how far the waves go each step, in pairs, to and fro.
void warm(benchmark::State& state, ContactModel model, double moved, double offset) {
  const int pairs = static_cast<int>(state.range(0));
  const MatrixXd F = face_flexibility(pairs);
  ContactSolver solver({.model = model});
  solver.set_faces(F, VectorXd::Constant(pairs, 0.25));
  const VectorXd gaps[2] = {gap_of(pairs, 0.3, offset),
                            gap_of(pairs, 0.3 + moved * 6.0 * std::numbers::pi / pairs, offset)};
  for (const int i : {0, 1, 0}) {
    (void)solver.solve(gaps[i]);
    if (!right(state, solver, gaps[i], F)) return;
  }
  const long before = allocations;
  int step = 0;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(gaps[++step % 2]).pair_force.data());
  report(state, solver, before);
}

void rough(benchmark::State& state, bool from_cold) {
  const int pairs = static_cast<int>(state.range(0));
  const MatrixXd F = rough_flexibility(pairs);
  ContactSolver solver({.model = ContactModel::exact, .friction_coefficient = 0.5});
  solver.set_faces(F, VectorXd::Constant(pairs, 0.25));
  const VectorXd gap = gap_of(pairs, 0.3), sliding = gap_of(pairs, 1.0);
  (void)solver.solve(gap, sliding);
  if (!right(state, solver, gap, F.topLeftCorner(pairs, pairs))) return;
  const VectorXd bound = 0.5 * solver.result().pair_force;
  if (!((solver.result().shear_force.cwiseAbs() - bound).maxCoeff() <= 1e-9 * bound.maxCoeff()))
    return state.SkipWithError("the friction exceeds its bound");
  const long before = allocations;
  for (auto _ : state) {
    if (from_cold) solver.forget();
    benchmark::DoNotOptimize(solver.solve(gap, sliding).pair_force.data());
  }
  report(state, solver, before);
  state.counters["friction"] = solver.result().friction_iterations;
}

void derivative(benchmark::State& state) {
  const int pairs = static_cast<int>(state.range(0));
  const MatrixXd F = face_flexibility(pairs);
  ContactSolver solver({.model = ContactModel::exact});
  solver.set_faces(F, VectorXd::Constant(pairs, 0.25));
  const VectorXd gap = gap_of(pairs, 0.3);
  const VectorXd force = solver.solve(gap).pair_force;
  MatrixXd change = gap;  // forces are homogeneous in the gap: their derivative along it is themselves
  (void)solver.differentiate(change);
  if (!((change - force).norm() <= 1e-10 * force.norm())) return state.SkipWithError("the derivative is wrong");
  change.resize(pairs, pairs);
  for (auto _ : state) {
    change.setIdentity();
    (void)solver.differentiate(change);
    benchmark::DoNotOptimize(change.data());
  }
}

BENCHMARK_CAPTURE(cold, penalty, ContactModel::penalty, 0.0)->Arg(100);
BENCHMARK_CAPTURE(cold, penalty_closed, ContactModel::penalty, closed)->Arg(100);
BENCHMARK_CAPTURE(cold, exact, ContactModel::exact, 0.0)->Arg(25)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Complexity();
BENCHMARK_CAPTURE(cold, exact_closed, ContactModel::exact, closed)->Arg(100);
BENCHMARK_CAPTURE(warm, penalty_same_pairs, ContactModel::penalty, 0.01, 0.0)->Arg(100);
BENCHMARK_CAPTURE(warm, penalty_closed, ContactModel::penalty, 0.01, closed)->Arg(100);
BENCHMARK_CAPTURE(warm, exact_same_pairs, ContactModel::exact, 0.01, 0.0)->Arg(100);
BENCHMARK_CAPTURE(warm, exact_six_pairs_change, ContactModel::exact, 1.0, 0.0)->Arg(100);
BENCHMARK_CAPTURE(warm, exact_closed, ContactModel::exact, 0.01, closed)->Arg(100);
BENCHMARK_CAPTURE(rough, cold, true)->Arg(100);
BENCHMARK_CAPTURE(rough, warm, false)->Arg(100);
BENCHMARK(derivative)->Arg(100);

}  // namespace

BENCHMARK_MAIN();
