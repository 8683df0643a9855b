#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

const Studies& studies() {
  static const Studies all{
      {"one-polygon", run_one_polygon},
      {"jitter", run_jitter},
      {"convolve", run_convolve},
      {"coupled-oscillator", run_coupled_oscillator},
      {"kernel-march", run_kernel_march},
#ifdef SUNDER_HAS_SIMULATION
      {"scene", run_scene},
      {"polynomial-patch", run_polynomial_patch},
#endif
  };
  return all;
}

}  // namespace sunder::verification
