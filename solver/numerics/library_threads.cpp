#include "solver/numerics/library_threads.hpp"

#include <dlfcn.h>

namespace sunder::numerics {
namespace {

/// A function of whatever library the program was started with; nullptr where there is none of this name. Linking
/// would tie the program to one BLAS and one OpenMP, which the machine's CHOLMOD chooses.
template <class Function>
Function* library_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

struct Libraries {
  int (*active_levels)() = library_function<int()>("omp_get_max_active_levels");
  void (*set_active_levels)(int) = library_function<void(int)>("omp_set_max_active_levels");
  Libraries() {
    if (auto* set_blas_threads = library_function<void(int)>("openblas_set_num_threads")) set_blas_threads(1);
  }
  bool openmp() const { return active_levels != nullptr && set_active_levels != nullptr; }
};

const Libraries& libraries() {
  static const Libraries found;
  return found;
}

}  // namespace

OneLibraryThread::OneLibraryThread() {
  if (!libraries().openmp()) return;
  levels_ = libraries().active_levels();
  libraries().set_active_levels(0);  // no region may become active: each runs on the thread that meets it
}

OneLibraryThread::~OneLibraryThread() {
  if (libraries().openmp()) libraries().set_active_levels(levels_);
}

}  // namespace sunder::numerics
