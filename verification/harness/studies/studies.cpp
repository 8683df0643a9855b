#include "verification/harness/studies/studies.hpp"

namespace sunder::verification {

const Studies& studies() {
  static const Studies all{
      {"contact-history", run_contact_history},
      {"one-polygon", run_one_polygon},
      {"jitter", run_jitter},
      {"convolve", run_convolve},
      {"coupled-oscillator", run_coupled_oscillator},
      {"kernel-march", run_kernel_march},
      {"long-memory", run_long_memory},
#ifdef SUNDER_HAS_SIMULATION
      {"scene", run_scene},
      {"scene-jitter", run_scene_jitter},
      {"crack-water-motion", run_crack_water_motion},
      {"polynomial-patch", run_polynomial_patch},
      {"state-transfer", run_state_transfer},
      {"resumed", run_resumed},
      {"time-step", run_time_step},
#endif
  };
  return all;
}

}  // namespace sunder::verification
