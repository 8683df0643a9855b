#pragma once
/// Planting one fault at a time in the program that is built for it (sunder-verify-faulted).

#include <string>
#include <string_view>
#include <vector>

namespace sunder::verification {

struct FaultControl {
  void (*plant)(std::string_view name);  ///< from now on this fault is there, and no other; empty: none
  bool (*reached)();                     ///< has the code asked for the planted fault since?
  void (*listen)();  ///< from now on no fault is there, and the names that the code asks for are kept
  std::vector<std::string> (*heard)();  ///< these names since then, each once, sorted
};

/// nullptr in the ordinary program.
const FaultControl* fault_control();

}  // namespace sunder::verification
