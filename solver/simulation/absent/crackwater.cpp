// In place of moving_water.cpp, crack_waters.cpp and run_crack_water.cpp in a build without crack water: no scene that
// asks for it comes here, and every crack is dry.
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/crack_waters.hpp"

namespace sunder::simulation {

const bool built::crackwater = false;

CrackWaters uniform_waters(const DynamicBody& body, std::span<const Mouth> /*mouths*/) {
  return CrackWaters(body.cracks.size());
}

CrackWaters moving_waters(const scene::Scene& /*scene*/, const DynamicBody& body, std::span<const Mouth> /*mouths*/,
                          const Eigen::VectorXd& /*openings*/) {
  return CrackWaters(body.cracks.size());
}

void grow_waters(const scene::Scene& /*scene*/, const DynamicBody& /*body*/, const Eigen::VectorXd& /*openings*/,
                 CrackWaters& /*waters*/) {}

bool MovingWater::trial(std::span<const double> /*openings*/, double /*mouth_pressure*/, double /*time_step*/,
                        faces::WaterForces& /*result*/) {
  return false;
}

void check_crack_water(const scene::Scene& scene) {
  refuse_absent_parts(scene);
}

void run_crack_water(const scene::Scene& scene, const RunOptions& /*options*/, Ledger& /*ledger*/,
                     results::RunSummary& /*summary*/) {
  refuse_absent_parts(scene);
}

}  // namespace sunder::simulation
