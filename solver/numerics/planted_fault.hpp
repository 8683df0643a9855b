#pragma once
/// A place where the verification can plant a fault, to prove that its checks would notice one.
///
///     const double sign = planted_fault("sbfem/side-face-load-sign") ? -1.0 : 1.0;
///
/// In the library this is the constant `false` and costs nothing. The source files that include this header are
/// compiled a second time with SUNDER_PLANTED_FAULTS for one test program, where `planted_fault` asks the running case.
/// Include it from .cpp files only.

#include <string_view>

namespace sunder::numerics {

#ifdef SUNDER_PLANTED_FAULTS
inline namespace with_faults {
/// True where the running case has planted the fault of this name. Defined by verification/harness.
bool planted_fault(std::string_view name);
}  // namespace with_faults
#else
inline namespace without_faults {
constexpr bool planted_fault(std::string_view /*name*/) {
  return false;
}
}  // namespace without_faults
#endif

}  // namespace sunder::numerics
