#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

const Studies& studies() {
  static const Studies all{
      {"one-polygon", run_one_polygon},
      {"jitter", run_jitter},
#ifdef SUNDER_HAS_SIMULATION
      {"scene", run_scene},
      {"polynomial-patch", run_polynomial_patch},
      {"state-transfer", run_state_transfer},
#endif
  };
  return all;
}

}  // namespace sunder::verification
