// SUNDER_VERSION and SUNDER_FLAGS come from solver/CMakeLists.txt.
#include "solver/results/environment.hpp"

namespace sunder::results {

Environment environment() {
#if defined(__clang__)
  const std::string compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
  const std::string compiler = "g++ " __VERSION__;
#else
#error "Sunder is built by g++ or clang"
#endif
  return {SUNDER_VERSION, compiler, SUNDER_FLAGS};
}

}  // namespace sunder::results
