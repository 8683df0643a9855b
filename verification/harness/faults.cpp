/// Compiled into both programs: with SUNDER_PLANTED_FAULTS it is the other half of solver/numerics/planted_fault.hpp.
#include "verification/harness/faults.hpp"

#include <atomic>
#include <mutex>
#include <set>
#include <string>

#include "solver/numerics/planted_fault.hpp"

#ifdef SUNDER_PLANTED_FAULTS

namespace {

std::string planted;     // set before a run begins, read by its threads
bool listening = false;  // likewise
std::atomic<bool> was_reached{false};
std::mutex asking;
std::set<std::string, std::less<>> asked;  // guarded by `asking`

void plant(std::string_view name) {
  planted = name;
  listening = false;
  was_reached = false;
}
bool reached() {
  return was_reached;
}
void listen() {
  plant("");
  const std::lock_guard lock(asking);
  asked.clear();
  listening = true;
}
std::vector<std::string> heard() {
  const std::lock_guard lock(asking);
  return {asked.begin(), asked.end()};
}
void keep(std::string_view name) {
  const std::lock_guard lock(asking);
  if (asked.find(name) == asked.end()) asked.emplace(name);
}
const sunder::verification::FaultControl control{plant, reached, listen, heard};

}  // namespace

namespace sunder::numerics {
inline namespace with_faults {
bool planted_fault(std::string_view name) {
  if (listening) keep(name);
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
