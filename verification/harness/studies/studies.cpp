#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

const Studies& studies() {
  static const Studies all{
      {"polygon", run_polygon},
#ifdef SUNDER_HAS_SIMULATION
      {"scene", run_scene},
#endif
  };
  return all;
}

}  // namespace sunder::verification
