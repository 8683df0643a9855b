#pragma once
/// Planting one fault at a time in the program that is built for it (sunder-verify-faulted).

#include <string_view>

namespace sunder::verification {

struct FaultControl {
  void (*plant)(std::string_view name);  ///< from now on this fault is there, and no other; empty: none
  bool (*reached)();                     ///< has the code asked for the planted fault since?
};

/// nullptr in the ordinary program.
const FaultControl* fault_control();

}  // namespace sunder::verification
