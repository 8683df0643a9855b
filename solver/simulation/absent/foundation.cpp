// In place of attached_foundation.cpp, foundation_line.cpp and foundation_response.cpp in a build without foundation:
// no scene that asks for it comes here.
#include "solver/simulation/attached_foundation.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/foundation_response.hpp"

namespace sunder::simulation {

const bool built::foundation = false;

AttachedFoundation attach_foundation(const Body& /*body*/, const SurfaceMotion& /*motion*/, const StepPlan& /*plan*/,
                                     const std::filesystem::path& /*cache*/, numerics::ThreadPool& /*pool*/,
                                     Ledger& /*ledger*/) {
  return {};
}

void add_foundation_response(const scene::Scene& scene, numerics::ThreadPool& /*pool*/, Ledger& /*ledger*/,
                             results::RunSummary& /*summary*/) {
  refuse_absent_parts(scene);
}

}  // namespace sunder::simulation
