#include "solver/simulation/energy_account.hpp"

#include <cmath>

namespace sunder::simulation {

namespace {

using Eigen::Array2d;
using Eigen::Index;

/// Sums over the nodes, x and y apart: as many chains of additions as the processor keeps going.
struct StepSums {
  double strain = 0.0, kinetic = 0.0;        // uᵀ K u, vᵀ M v at the end
  double by_stiffness = 0.0, by_mass = 0.0;  // Δuᵀ K Δu, Δuᵀ M (v + v')
  Eigen::Vector2d ground;                    // Δuᵀ M r
  double load = 0.0;                         // Δuᵀ (f + f')
};

StepSums sums_of(const StepEquations& equations, const Eigen::VectorXd& moved, const MotionState& to,
                 const StepLoad& start, const StepLoad& end) {
  const MotionProducts &now = equations.products(), &before = equations.products_before();
  Array2d strain(0.0, 0.0), kinetic(0.0, 0.0), by_stiffness(0.0, 0.0), by_mass(0.0, 0.0), load(0.0, 0.0);
  Array2d ground_x(0.0, 0.0), ground_y(0.0, 0.0);
  for (Index node = 0; node < now.mass.cols(); ++node) {
    const Array2d d = moved.segment<2>(2 * node);
    const Array2d Ku = now.stiffness.col(node).head<2>(), Mv = now.mass.col(node).head<2>();
    strain += to.displacement.segment<2>(2 * node).array() * Ku;
    kinetic += to.velocity.segment<2>(2 * node).array() * Mv;
    by_stiffness += d * (Ku - before.stiffness.col(node).head<2>().array());
    by_mass += d * (Mv + before.mass.col(node).head<2>().array());
    const auto mass = equations.ground_mass().middleCols<2>(2 * node);
    ground_x += d[0] * mass.col(0).array();
    ground_y += d[1] * mass.col(1).array();
    load += d * (start.force.segment<2>(2 * node) + end.force.segment<2>(2 * node)).array();
  }
  return {.strain = strain.sum(),
          .kinetic = kinetic.sum(),
          .by_stiffness = by_stiffness.sum(),
          .by_mass = by_mass.sum(),
          .ground = ground_x + ground_y,
          .load = load.sum()};
}

/// aᵀ b of the first of two vectors.
double dot(const Eigen::VectorXd& a, const numerics::VectorPair& b) {
  return a.reshaped(2, b.cols()).cwiseProduct(b.topRows<2>()).sum();
}

}  // namespace

void EnergyAccount::measure(const StepEquations& equations, const MotionState& state) {
  moved_.setZero(state.displacement.size());
  memory_.energies.strain = 0.5 * dot(state.displacement, equations.products().stiffness);
  memory_.energies.kinetic = 0.5 * dot(state.velocity, equations.products().mass);
}

void EnergyAccount::go_on(const StepEquations& equations, const MotionState& state, const EnergyMemory& memory) {
  memory_ = memory;
  measure(equations, state);
}

void EnergyAccount::begin(const StepEquations& equations, const MotionState& state) {
  measure(equations, state);
  memory_.begun_with = memory_.energies.stored();
  memory_.largest = memory_.energies.stored();
}

void EnergyAccount::grow(const StepEquations& equations, const MotionState& state) {
  const double before = memory_.energies.stored();
  measure(equations, state);
  memory_.energies.growth += memory_.energies.stored() - before;
}

void EnergyAccount::add(const StepEquations& equations, const MotionState& from, const MotionState& to,
                        const StepLoad& start, const StepLoad& end, const std::vector<Eigen::VectorXd>& media_before,
                        const FaceWork& faces, const Eigen::VectorXd& released) {
  const double dt = equations.options().time_step;
  const dynamics::Rayleigh& damping = equations.options().damping;
  moved_ = to.displacement - from.displacement;
  const StepSums sums = sums_of(equations, moved_, to, start, end);
  memory_.energies.strain = 0.5 * sums.strain;
  memory_.energies.kinetic = 0.5 * sums.kinetic;
  // C Δu / Δt with M Δu = Δt (M v + M v') / 2, exact for average acceleration
  memory_.energies.damped += 0.5 * damping.of_mass * sums.by_mass + damping.of_stiffness / dt * sums.by_stiffness;
  memory_.energies.input -= 0.5 * sums.ground.dot(start.ground + end.ground);
  memory_.energies.load += 0.5 * sums.load;
  for (std::size_t m = 0; m < media_before.size(); ++m) {
    memory_.energies.radiated += 0.5 * equations.work_on_medium(m, moved_, media_before[m]);
  }
  if (released.size() > 0) memory_.energies.growth += 0.5 * moved_.dot(released);
  memory_.energies.contact += faces.contact;
  memory_.energies.water += faces.water;
  const double came_in = memory_.energies.input + memory_.energies.load + memory_.energies.contact +
                         memory_.energies.water + memory_.energies.growth - memory_.energies.damped -
                         memory_.energies.radiated;
  memory_.worst_error =
      std::fmax(memory_.worst_error, std::abs(memory_.energies.stored() - memory_.begun_with - came_in));
  memory_.largest = std::fmax(memory_.largest, std::fmax(memory_.energies.stored(), std::abs(memory_.energies.input)));
}

}  // namespace sunder::simulation
