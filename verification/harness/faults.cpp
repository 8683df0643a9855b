/// Compiled into both programs: with SUNDER_PLANTED_FAULTS it is the other half of solver/numerics/planted_fault.hpp.
#include "verification/harness/faults.hpp"

#include <atomic>
#include <string>

#include "solver/numerics/planted_fault.hpp"

#ifdef SUNDER_PLANTED_FAULTS

namespace {

std::string planted;  // set before a run begins, read by its threads
std::atomic<bool> was_reached{false};

void plant(std::string_view name) {
  planted = name;
  was_reached = false;
}
bool reached() {
  return was_reached;
}
const sunder::verification::FaultControl control{plant, reached};

}  // namespace

namespace sunder::numerics {
inline namespace with_faults {
bool planted_fault(std::string_view name) {
  if (name != planted) return false;
  was_reached.store(true, std::memory_order_relaxed);
  return true;
}
}  // namespace with_faults
}  // namespace sunder::numerics

namespace sunder::verification {
const FaultControl* fault_control() {
  return &control;
}
}  // namespace sunder::verification

#else

namespace sunder::verification {
const FaultControl* fault_control() {
  return nullptr;
}
}  // namespace sunder::verification

#endif
