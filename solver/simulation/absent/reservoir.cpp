// In place of attached_reservoir.cpp and reservoir_response.cpp in a build without reservoir: no scene that asks for it
// comes here.
#include "solver/simulation/attached_medium.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/reservoir_response.hpp"

namespace sunder::simulation {

const bool built::reservoir = false;

std::unique_ptr<AttachedMedium> attach_reservoir(const scene::Scene& /*scene*/, const Body& /*body*/,
                                                 const StepPlan& /*plan*/, numerics::ThreadPool& /*pool*/,
                                                 Ledger& /*ledger*/) {
  return nullptr;
}

Eigen::VectorXd reservoir_pressure_weights(const scene::Scene& /*scene*/, const Body& /*body*/, double /*height*/) {
  return {};
}

double reservoir_pressure_at_rest(const scene::Scene& /*scene*/, double /*height*/) {
  return 0.0;
}

void add_reservoir_response(const scene::Scene& scene, Ledger& /*ledger*/, results::RunSummary& /*summary*/) {
  refuse_absent_parts(scene);
}

}  // namespace sunder::simulation
